// Reads a recording's catalogue entry from its file.
#pragma once

#include <functional>
#include <string>

#include "core/base/error.h"
#include "core/catalogue/catalogue_types.h"

namespace fyd::catalogue {

using EntryReader = std::function<Result<CatalogueEntry>(const std::string& path)>;
/// Through Recording::open; `station` is this host.
[[nodiscard]] Result<CatalogueEntry> readCatalogueEntry(const std::string& path);

}  // namespace fyd::catalogue
