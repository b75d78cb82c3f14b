// Storing a recording: only a whole one, and its entry in the catalogue goes along.
#include "core/session/archive_move.h"
#include "core/session/catalogue.h"
#include "core/session/catalogue_word.h"

namespace fyd::session {

Result<StoredFile> storeClosed(const std::string& file, const std::string& folder, const std::string& catalogue_word) {
  const auto word = parseCatalogueWord(catalogue_word);
  if (!word) return tl::unexpected(word.error());
  auto entry = readCatalogueEntry(file);
  if (!entry) return tl::unexpected(entry.error());
  if (entry->wholeness == Wholeness::growing) return fail("{}: is still being recorded; close it first", file);
  if (entry->wholeness == Wholeness::crashed) {
    return fail("{}: was left behind by a crash; `fyd session recover` makes it whole first", file);
  }
  if (entry->wholeness == Wholeness::damaged) {
    return fail("{}: is damaged; `fyd session recover` keeps what can be proven of it first", file);
  }
  if (word->kind == CatalogueWord::Kind::none) {
    return moveFile(entry->path, folder, [](const std::string&) -> Result<void> { return {}; });
  }
  // Asked before anything is copied: a catalogue that is away would leave the recording in two places.
  auto catalogue = Catalogue::open(catalogue_word);
  if (!catalogue) return tl::unexpected(catalogue.error());
  return moveFile(entry->path, folder, [&](const std::string& path) {
    entry->path = path;
    return catalogue->add(*entry);
  });
}

}  // namespace fyd::session
