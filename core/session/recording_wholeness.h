// How whole a recording is. `info`, `verify`, `replay`, `recover`, the exports, the catalogue and the window all say
// what is said here.
#pragma once

#include "core/session/recording.h"
#include "core/session/recording_source.h"
#include "core/session/recording_tables.h"

namespace fyd::session {

/// From what opening the file shows: its end, the commits, the journal; the blocks themselves are `verify`'s.
/// Sets wholeness, damage, unproven_rows and what the commits count.
void judge(const RecordingSource& source, const RecordingTables& tables, RecordingInfo& info);

}  // namespace fyd::session
