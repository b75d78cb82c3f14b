// What to think of a recording before trusting it, in words; what opening it showed is all that is asked.
#pragma once

#include <string>

#include "core/session/recording.h"

namespace fyd::session {

/// In a word, and why.
struct Health {
  std::string word;  ///< good, gaps (something is lost), growing, or damaged (to be recovered)
  Message reason;    ///< empty when there is nothing to say
};
[[nodiscard]] Health healthOf(const RecordingInfo& info);

/// As in "/inputs/bridge is lost for 250 steps from row 500 on (why)".
[[nodiscard]] Message wordsOf(const MissingRows& missing);

/// Why a replay cannot prove every recorded step bit for bit, whatever it computes; empty: nothing is in its way.
/// Steps that are gone do not count here: the replay itself ends at the gap.
[[nodiscard]] Message whyNoExactReplay(const RecordingInfo& info);

}  // namespace fyd::session
