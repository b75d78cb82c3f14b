// Rebuilds a damaged catalogue: moves the old file aside, takes over its readable entries, and reads the recordings
// again.
#pragma once

#include <string>
#include <vector>

#include "core/catalogue/catalogue.h"

namespace fyd::catalogue {

struct RebuildReport {
  std::string moved_aside;  ///< new path of the damaged file; empty: it was not damaged
  std::size_t rescued = 0;  ///< entries whose notes and tags could be read from it
  std::vector<std::string> folders;
  ScanReport scan;
};
/// Builds the catalogue again from the recordings in its folders and in `folders`. A damaged SQLite file is moved
/// aside, never deleted; entries that can still be read from it are taken over.
[[nodiscard]] Result<RebuildReport> rebuildCatalogue(const std::string& word, const std::vector<std::string>& folders,
                                                     const EntryReader& read = readCatalogueEntry);

}  // namespace fyd::catalogue
