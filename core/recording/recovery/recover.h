// Makes a recording whole whose recorder was killed or lost its power; never deletes anything.
//
// Nothing damaged    the file itself is finished and gets its name: FILE.partial becomes FILE
// Something damaged  every step whose telemetry can be read goes into a new FILE, which says what is missing; the old
//                    one is kept beside it as FILE.damaged
// Nothing readable   the file is left as it is
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/recording/progress.h"
#include "core/recording/recording_types.h"

namespace fyd::recording {

/// The values are the exit codes of `fyd session recover`.
enum class RecoverResult : std::uint8_t { whole = 0, nothing = 1, part_lost = 3 };

struct RecoverOutcome {
  RecoverResult result = RecoverResult::nothing;
  std::string file;  ///< whole now; empty: nothing
  std::string kept;  ///< the damaged original, when there is one
  std::uint64_t steps = 0;
  std::uint64_t lost_steps = 0;      ///< not readable any more, or proven by nothing
  std::vector<MissingRows> missing;  ///< of `file`: what else is not there, and these steps
  Message first_damage;
};

/// Steps that are gone show as a gap. Of a step that is kept, what cannot be read is named as missing and never
/// replaced by a guess; a replay of it is never called identical.
/// @param path FILE or FILE.partial
/// @return an error when it is missing, is being recorded at this moment, writing fails, or `progress` ended it; the
/// file is then unchanged, and no other one was left beside it
[[nodiscard]] Result<RecoverOutcome> recover(const std::string& path, const Progress& progress = {});

}  // namespace fyd::recording
