// Recordings in folders, and whether a file is still the one that was catalogued.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/catalogue/catalogue_types.h"

namespace fyd::catalogue {

struct FileFacts {
  std::uint64_t bytes = 0;
  std::int64_t modified_ns = 0;  ///< since 1970
};

/// Nothing when there is no ordinary file.
[[nodiscard]] std::optional<FileFacts> fileFacts(const std::string& path);
[[nodiscard]] bool isUnchanged(const CatalogueEntry& entry, const FileFacts& facts);

/// Absolute paths of .h5 and .h5.partial, sorted; unreadable folders are left out, links to folders are
/// not followed.
/// @param deep also in the folders below
[[nodiscard]] std::vector<std::string> recordingsIn(const std::string& folder, bool deep);

}  // namespace fyd::catalogue
