// Small text files that must never be found half written: profiles and what goes with them.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"

namespace fyd::station {

/// Writes beside `path`, syncs and renames over it: a reader sees the old or the new file, never half of one.
/// @return an error with the path and the system's reason; the old file is then untouched
[[nodiscard]] Result<void> replaceFile(const std::string& path, std::string_view text);

}  // namespace fyd::station
