// The recording's header in the file: /header/* texts and the root's numbers, guarded by one CRC32C.
#pragma once

#include <hdf5.h>

#include "core/session/recording_types.h"

namespace fyd::session {

/// @throws RecordingFailure
void writeHeader(hid_t file, const RecordingHeader& header);
/// @throws RecordingFailure: no recording, another version, damaged
[[nodiscard]] RecordingHeader readHeader(hid_t file);
/// What can be read of a damaged one; the rest stays empty. @throws when it is no recording of this format
[[nodiscard]] RecordingHeader readDamagedHeader(hid_t file);

}  // namespace fyd::session
