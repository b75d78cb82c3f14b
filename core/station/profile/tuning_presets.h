// Named sets of live parameters, kept as TOML files in a folder beside the profile: NAME.toml, in a profile's own form.
//
// A preset may name any of the parameters that may change while the station runs; those it does not name stay as they
// are, and so do calibrated values, which belong to one touchpad. It is checked as a whole before anything of it is
// used.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/station/profile/profile.h"

namespace fyd::station {

/// 1 to 40 letters, digits, spaces, '-' and '_'; a space neither first nor last. The message says what is allowed.
[[nodiscard]] Result<void> checkPresetName(std::string_view name);

/// "presets" beside the profile.
[[nodiscard]] std::string presetFolder(const std::string& profile_path);

/// In order of their names; none when there is no folder. Files that are no presets' are left out.
[[nodiscard]] std::vector<std::string> presetNames(const std::string& folder);

/// Whether presets keep its value: a live number that no calibration finds.
[[nodiscard]] bool isInPreset(const Parameter& parameter);

/// Every such parameter of the profile, as the text of a preset.
[[nodiscard]] std::string formatPreset(const Profile& profile);

/// @param base what the preset is laid over; parameters that it does not name keep their value, and calibrated ones
/// that a preset of an earlier version names
/// @return an error with file, line, value and range; also for a parameter that cannot change while the station runs
[[nodiscard]] Result<Profile> parsePreset(std::string_view text, std::string_view source_name, const Profile& base);

[[nodiscard]] Result<std::string> readPreset(const std::string& folder, std::string_view name);
/// Makes the folder when it is not there; replaces what had that name.
[[nodiscard]] Result<void> writePreset(const std::string& folder, std::string_view name, std::string_view text);
[[nodiscard]] Result<void> removePreset(const std::string& folder, std::string_view name);

}  // namespace fyd::station
