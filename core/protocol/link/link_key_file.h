// Key files on disk: made readable by their owner alone, and read only when they still are.
#pragma once

#include <string>

#include "core/protocol/link/link_keys.h"

namespace fyd::protocol {

/// @return an error when it cannot be read, is readable or writable by others than its owner, or is not a key
[[nodiscard]] Result<LinkKey> readKeyFile(const std::string& path);
/// Makes a new file of mode 0600 and syncs it. @return an error when the file exists already or cannot be written
[[nodiscard]] Result<void> writeKeyFile(const LinkKey& key, const std::string& path);

}  // namespace fyd::protocol
