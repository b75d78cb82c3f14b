// Goes through a damaged recording and takes what can be read of it into a new one.
#pragma once

#include "core/session/progress.h"
#include "core/session/recording_salvage.h"
#include "core/session/recording_writer.h"

namespace fyd::session {

struct CopyOutcome {
  std::uint64_t steps = 0;
  std::uint64_t lost_steps = 0;      ///< in the file, and cannot be read or proven
  bool first_lost = false;           ///< the header's step_state is that before a row that is not there
  std::vector<MissingRows> missing;  ///< with what was missing in the original already; rows are those of the copy
  bool operator==(const CopyOutcome&) const = default;
};

/// A step is kept as long as its telemetry can be read; what else cannot is named as missing.
/// @param from by `openDamaged(path)`. @param to nullptr: only looks what there would be to copy
/// @return an error when the disk refused or `progress` ended it
[[nodiscard]] Result<CopyOutcome> copyReadable(const std::string& path, const Recording& from, RecordingWriter* to,
                                               const Progress& progress);

}  // namespace fyd::session
