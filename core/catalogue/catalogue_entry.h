// Reads a recording's catalogue entry from its file.
#pragma once

#include <functional>
#include <string>

#include "core/base/error.h"
#include "core/catalogue/catalogue_types.h"
#include "core/recording/reader/review_notes.h"

namespace fyd::catalogue {

/// Its errors name the file.
using EntryReader = std::function<Result<CatalogueEntry>(const std::string& path)>;
/// Through Recording::open; `station` is this host. Notes and tags written in a review belong to it; where the file of
/// these is damaged, the recording's own are taken.
[[nodiscard]] Result<CatalogueEntry> readCatalogueEntry(const std::string& path);
/// The entry's notes with one more line.
[[nodiscard]] std::string withNote(const std::string& notes, const recording::ReviewNote& note);

}  // namespace fyd::catalogue
