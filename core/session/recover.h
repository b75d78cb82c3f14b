// Makes a recording whole whose recorder was killed or lost its power; never deletes anything.
//
// Nothing damaged    the file itself is finished and gets its name: FILE.partial becomes FILE
// Blocks damaged     every step that can be read goes into a new FILE; the old one is kept beside it as FILE.damaged
// Nothing readable   the file is left as it is
#pragma once

#include <cstdint>
#include <string>

#include "core/base/error.h"
#include "core/session/progress.h"

namespace fyd::session {

/// Its values are the command's exit codes.
enum class RecoverResult : std::uint8_t { whole = 0, nothing = 1, part_lost = 3 };

struct RecoverOutcome {
  RecoverResult result = RecoverResult::nothing;
  std::string file;  ///< whole now; empty: nothing
  std::string kept;  ///< the damaged original, when there is one
  std::uint64_t steps = 0;
  std::uint64_t lost_steps = 0;  ///< committed once and not readable any more
  std::string first_damage;
};

/// A step is kept with all its inputs or not at all; missing ones show as a gap.
/// @param path FILE or FILE.partial
/// @return an error when it is missing, is being recorded at this moment, the disk refuses, or `progress` ended it; the
/// file is then as it was, and there is none beside it
[[nodiscard]] Result<RecoverOutcome> recover(const std::string& path, const Progress& progress = {});

}  // namespace fyd::session
