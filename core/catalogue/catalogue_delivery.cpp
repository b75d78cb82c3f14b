#include "core/catalogue/catalogue_delivery.h"

#include <set>

#include "core/catalogue/catalogue.h"
#include "core/catalogue/catalogue_address.h"
#include "core/catalogue/catalogue_entry.h"
#include "core/catalogue/catalogue_pending.h"
#include "core/catalogue/catalogue_text.h"

namespace fyd::catalogue {

Result<void> deliverEntry(const std::string& catalogue_word, const CatalogueEntry& entry) {
  const auto word = parseCatalogueAddress(catalogue_word);
  if (!word) return tl::unexpected(word.error());
  if (word->kind == CatalogueAddress::Kind::none) return {};
  if (auto ok = checkEntry(entry); !ok) return ok;  // an invalid entry is not queued
  const auto put = Catalogue::open(catalogue_word).and_then([&](Catalogue catalogue) { return catalogue.add(entry); });
  if (put) return {};
  if (auto queued = queueEntry(word->key, entry, put.error().text()); !queued) {
    return fail("{}; nor can the entry wait: {}. The recording is safe; put it in later with `fyd session add {}`",
                put.error().message, queued.error().message, entry.path);
  }
  return fail("{}; the entry waits in {} and goes in when the catalogue is next opened", put.error().message,
              pendingPath());
}

Result<void> catalogueRecording(const std::string& catalogue_word, const std::string& recording_path) {
  const auto word = parseCatalogueAddress(catalogue_word);
  if (!word) return tl::unexpected(word.error());
  if (word->kind == CatalogueAddress::Kind::none) return {};
  const auto entry = readCatalogueEntry(recording_path);
  if (!entry) return tl::unexpected(entry.error());
  return deliverEntry(catalogue_word, *entry);
}

Result<void> catalogueReview(const std::string& catalogue_word, const std::string& recording_id,
                             const ReviewChange& change) {
  const auto word = parseCatalogueAddress(catalogue_word);
  if (!word) return tl::unexpected(word.error());
  if (word->kind == CatalogueAddress::Kind::none) return {};
  auto catalogue = Catalogue::open(catalogue_word);
  if (!catalogue) return tl::unexpected(catalogue.error());
  const auto found = catalogue->search({.id = recording_id});
  if (!found) return tl::unexpected(found.error());
  if (found->empty()) return {};
  const CatalogueEntry& entry = found->front();
  CatalogueEntry reviewed = entry;
  if (change.note) {  // what is too long for the catalogue is cut, as when the recording is read
    reviewed.notes = withNote(entry.notes, *change.note);
    if (auto ok = catalogue->setNotes(entry.id, withFittingTexts(reviewed).notes); !ok) return ok;
  }
  if (change.tags_added.empty() && change.tags_removed.empty()) return {};
  std::set<std::string> tags(entry.tags.begin(), entry.tags.end());
  tags.insert(change.tags_added.begin(), change.tags_added.end());
  for (const std::string& tag : change.tags_removed) tags.erase(tag);
  reviewed.tags.assign(tags.begin(), tags.end());
  return catalogue->setTags(entry.id, withFittingTexts(reviewed).tags);
}

}  // namespace fyd::catalogue
