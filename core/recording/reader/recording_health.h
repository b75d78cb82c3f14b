// The state of a recording in a word, with the reason, from what opening the file shows.
#pragma once

#include <string>

#include "core/recording/reader/recording.h"

namespace fyd::recording {

/// In a word, and why.
struct Health {
  std::string word;  ///< good, gaps (something is lost), growing, or damaged (to be recovered)
  Message reason;    ///< empty when there is nothing to say
};
[[nodiscard]] Health healthOf(const RecordingInfo& info);

/// As in "/inputs/bridge is lost for 250 steps from row 500 on (why)".
[[nodiscard]] Message wordsOf(const MissingRows& missing);

/// Why a replay cannot compare every recorded step bit for bit; empty: it can.
/// Steps that are gone do not count here: the replay itself ends at the gap.
[[nodiscard]] Message whyNoExactReplay(const RecordingInfo& info);

}  // namespace fyd::recording
