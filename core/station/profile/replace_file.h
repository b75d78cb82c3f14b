// Replaces small text files atomically: profiles, calibration records, presets.
#pragma once

#include <string>
#include <string_view>

#include "core/base/error.h"

namespace fyd::station {

/// Writes beside the file, syncs and renames over it: a reader sees the old or the new one, never half of one. A link
/// stays a link, and the file it leads to keeps mode and owner.
/// @return an error with the path and the reason, also when a device, a pipe or a folder stands there; what was there
/// is then untouched
[[nodiscard]] Result<void> replaceFile(const std::string& path, std::string_view text);

}  // namespace fyd::station
