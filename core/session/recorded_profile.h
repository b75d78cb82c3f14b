// The step's parameters out of the profile a recording carries. The profile is the whole station's; what belongs to
// other rooms, and what this version does not know any more, is passed over.
#pragma once

#include "core/base/error.h"
#include "core/pipeline/parameters.h"
#include "core/session/recording_types.h"
#include "core/texture/surface_model.h"

namespace fyd::session {

/// @return an error when the text is damaged or a value cannot be
[[nodiscard]] Result<pipeline::Parameters> recordedParameters(const RecordingHeader& header);

/// The stored surface that was felt; nothing when there was none.
[[nodiscard]] Result<std::optional<texture::SurfaceModel>> recordedSurface(const RecordingHeader& header);

}  // namespace fyd::session
