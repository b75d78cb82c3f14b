// Finishes, in place, a recording whose recorder is gone and whose blocks are all sound.
#pragma once

#include <memory>
#include <string>

#include "core/base/error.h"
#include "core/session/recording_disk.h"

namespace fyd::session {

/// Applies the journal, takes away the gone recorder's mark and, unless it is there, adds the commit that says
/// "closed"; then drops the journal. A power cut or a kill at any moment loses nothing: doing it again ends it.
/// @param calls tests put broken disks here
[[nodiscard]] Result<void> finishRecording(const std::string& path, std::shared_ptr<DiskCalls> calls = {});

}  // namespace fyd::session
