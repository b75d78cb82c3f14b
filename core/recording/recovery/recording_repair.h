// Finishes, in place, a recording whose recorder ended without closing it and whose blocks are all intact.
#pragma once

#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/recording/file/recording_disk.h"

namespace fyd::recording {

/// Applies the journal, clears HDF5's "open for writing" flag and, unless it is there, adds the commit that says
/// "closed"; then drops the journal. A power cut or a kill at any moment loses nothing: repeating the call finishes it.
/// @param calls tests simulate disk errors here
[[nodiscard]] Result<void> finishRecording(const std::string& path, std::shared_ptr<DiskCalls> calls = {});

}  // namespace fyd::recording
