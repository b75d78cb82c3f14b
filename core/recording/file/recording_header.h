// The recording's header in the file: /header/* texts and the root's numbers, guarded by one CRC32C.
#pragma once

#include <hdf5.h>

#include "core/recording/recording_types.h"

namespace fyd::recording {

/// @throws RecordingFailure
void writeHeader(hid_t file, const RecordingHeader& header);
/// @throws RecordingFailure: no recording, another version, damaged
[[nodiscard]] RecordingHeader readHeader(hid_t file);
/// What can be read of it; of a damaged one `missing` says so, and what cannot be read stays empty.
/// @throws when it is no recording of this format
[[nodiscard]] RecordingHeader salvageHeader(hid_t file);

/// The table's name in MissingRows for the header itself.
inline constexpr const char* kHeaderTable = "/header";

}  // namespace fyd::recording
