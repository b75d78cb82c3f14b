// Copies what can be read of a damaged recording into a new one.
#pragma once

#include "core/recording/progress.h"
#include "core/recording/reader/recording_salvage.h"
#include "core/recording/writer/recording_writer.h"

namespace fyd::recording {

struct CopyOutcome {
  std::uint64_t steps = 0;
  std::uint64_t lost_steps = 0;      ///< in the file, and cannot be read or proven
  bool first_lost = false;           ///< the row after the header's step_state is lost
  std::vector<MissingRows> missing;  ///< with what was missing in the original already; rows are those of the copy
  bool operator==(const CopyOutcome&) const = default;
};

/// A step is kept as long as its telemetry can be read; what else cannot is named as missing.
/// @param to nullptr: only finds what can be copied
/// @return an error when writing failed or `progress` ended it
[[nodiscard]] Result<CopyOutcome> copyReadable(const std::string& path, const DamagedRecording& from,
                                               RecordingWriter* to, const Progress& progress);

}  // namespace fyd::recording
