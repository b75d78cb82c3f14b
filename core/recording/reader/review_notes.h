// Notes, bookmarks and tags written while a recording is reviewed. The recording itself is never changed: they stand
// beside it (reviewNotesPath, recording_place.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/recording/reader/recording_info.h"

namespace fyd::recording {

struct ReviewNote {
  double time_s = 0.0;  ///< in the recording
  NoteKind kind = NoteKind::note;
  std::string text;
  std::string written_utc;  ///< ISO 8601
};

struct ReviewNotes {
  std::vector<ReviewNote> notes;                 ///< in order of time
  std::optional<std::vector<std::string>> tags;  ///< in place of the recording's own; none: these hold
};

/// None when there is no such file.
/// @param id of the recording, as in its header; empty: its header is damaged, and nothing is compared
/// @return an error that names file and entry when it is damaged, or when its notes are of a recording with another id;
/// a file that says no id is taken
[[nodiscard]] Result<ReviewNotes> readReviewNotes(const std::string& recording_path, const std::string& id);

/// The tags that hold: the review's where it changed them and could be read, otherwise the recording's own.
[[nodiscard]] std::vector<std::string> tagsInForce(const RecordingHeader& header, const Result<ReviewNotes>& review);
[[nodiscard]] std::vector<std::string> tagsInForce(const RecordingInfo& info);

/// Replaces the file atomically: a reader sees the old notes or the new ones.
[[nodiscard]] Result<void> writeReviewNotes(const std::string& recording_path, const std::string& id,
                                            ReviewNotes review);

}  // namespace fyd::recording
