#include "core/catalogue/catalogue_delivery.h"

#include "core/catalogue/catalogue.h"
#include "core/catalogue/catalogue_address.h"
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

}  // namespace fyd::catalogue
