// From a closed recording to its catalogue, whatever state the catalogue is in.
#include "core/session/catalogue.h"
#include "core/session/catalogue_pending.h"
#include "core/session/catalogue_text.h"
#include "core/session/catalogue_word.h"

namespace fyd::session {

Result<void> deliverEntry(const std::string& catalogue_word, const CatalogueEntry& entry) {
  const auto word = parseCatalogueWord(catalogue_word);
  if (!word) return tl::unexpected(word.error());
  if (word->kind == CatalogueWord::Kind::none) return {};
  if (auto ok = checkEntry(entry); !ok) return ok;  // waiting would not make it better
  const auto put = Catalogue::open(catalogue_word).and_then([&](Catalogue catalogue) { return catalogue.add(entry); });
  if (put) return {};
  if (auto queued = queueEntry(word->key, entry, put.error().text()); !queued) {
    return fail("{}; nor can the entry wait: {}. The recording is safe; put it in later with `fyd session add {}`",
                put.error().message, queued.error().message, entry.path);
  }
  return fail("{}; the entry waits in {} and goes in when the catalogue is next opened", put.error().message,
              pendingPath());
}

}  // namespace fyd::session
