// What a damaged recording still gives, for `recover`.
#pragma once

#include "core/session/recording.h"

namespace fyd::session {

/// As Recording::open, but a damaged header is taken as far as it can be read.
[[nodiscard]] Result<std::unique_ptr<Recording>> openDamaged(const std::string& path);

/// One picture as it stands in the file, not decoded.
[[nodiscard]] Result<EncodedPicture> encodedPicture(const Recording& recording, std::uint64_t index);

}  // namespace fyd::session
