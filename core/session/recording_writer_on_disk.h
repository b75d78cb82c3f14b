// RecordingWriter::create with another disk under it: for tests that break disks.
#pragma once

#include "core/session/recording_disk.h"
#include "core/session/recording_writer.h"

namespace fyd::session {

[[nodiscard]] Result<std::unique_ptr<RecordingWriter>> createRecording(const std::string& path,
                                                                       const RecordingHeader& header,
                                                                       std::shared_ptr<DiskCalls> calls);

}  // namespace fyd::session
