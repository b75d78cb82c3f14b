// Delivers a closed recording's entry to its catalogue, or queues it while the catalogue is unavailable.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/catalogue/catalogue_types.h"
#include "core/recording/reader/review_notes.h"

namespace fyd::catalogue {

/// Adds a closed recording to the catalogue. If the catalogue fails, the entry waits in pendingPath() and is delivered
/// when the catalogue is next opened: the error says so. The recording is safe either way.
[[nodiscard]] Result<void> catalogueRecording(const std::string& catalogue_word, const std::string& recording_path);
/// The same with an entry at hand.
[[nodiscard]] Result<void> deliverEntry(const std::string& catalogue_word, const CatalogueEntry& entry);

/// What a review added to a closed recording.
struct ReviewChange {
  std::optional<recording::ReviewNote> note;
  std::vector<std::string> tags_added;
  std::vector<std::string> tags_removed;
};
/// Enters it into the recording's entry, so that a search finds it. A recording that has no entry gets none.
[[nodiscard]] Result<void> catalogueReview(const std::string& catalogue_word, const std::string& recording_id,
                                           const ReviewChange& change);

}  // namespace fyd::catalogue
