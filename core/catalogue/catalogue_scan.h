// Recordings in folders, and whether a file is still the one that was catalogued.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/message.h"
#include "core/catalogue/catalogue_types.h"

namespace fyd::catalogue {

struct FileFacts {
  std::uint64_t bytes = 0;
  std::int64_t modified_ns = 0;  ///< since 1970
};

/// Nothing when there is no ordinary file.
[[nodiscard]] std::optional<FileFacts> fileFacts(const std::string& path);
[[nodiscard]] bool isUnchanged(const CatalogueEntry& entry, const FileFacts& facts);

struct FoundRecordings {
  std::vector<std::string> files;  ///< absolute paths of .h5 and .h5.partial, sorted
  std::vector<Message> problems;   ///< "folder: why", of each that could not be read to its end
};

/// Links to folders are not followed; a folder that does not exist holds nothing. Folders below it that are the
/// system's, such as lost+found, are left out where this user may not list them.
/// @param deep also in the folders below
[[nodiscard]] FoundRecordings recordingsIn(const std::string& folder, bool deep);

}  // namespace fyd::catalogue
