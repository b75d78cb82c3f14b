// Finishes, in place, a recording whose recorder is gone and whose blocks are all sound.
#pragma once

#include <string>

#include "core/base/error.h"

namespace fyd::session {

/// Applies the journal, takes away the gone recorder's mark and adds the commit that says "closed"; itself all or
/// nothing, so that a power cut in the middle changes nothing.
[[nodiscard]] Result<void> finishRecording(const std::string& path);

}  // namespace fyd::session
