// Decides whether a recording is whole, growing, crashed or damaged. `info`, `verify`, `replay`, `recover`, the
// exports, the catalogue and the window all use this.
#pragma once

#include "core/recording/reader/recording_info.h"
#include "core/recording/reader/recording_source.h"
#include "core/recording/reader/recording_tables.h"

namespace fyd::recording {

/// From what opening the file shows: its end, the commits, the journal; `verify` checks the blocks themselves.
/// Sets wholeness, damage, unproven_rows and what the commits count.
void judge(const RecordingSource& source, const RecordingTables& tables, RecordingInfo& info);

/// Steps that a recovery found gone. @return at most 2⁶⁴ − 1, whatever the file says
[[nodiscard]] std::uint64_t goneSteps(const RecordingHeader& header);

}  // namespace fyd::recording
