// Whose calibrated values a session uses.
//
// A profile belongs to one touchpad, which it names (calibration.touchpad); no other uses its calibrated values. Each
// other one has its own in a file beside the profile, and the simulated touchpad always has: lab.toml goes with
// lab.simulated.toml. All other parameters stand in the profile for every touchpad. A profile that names none, as those
// of earlier versions, is taken as the one's that opens it; what a calibration on the simulation wrote into it is left
// out with a real touchpad.
#pragma once

#include <string>

#include "core/station/profile/profile.h"

namespace fyd::station {

/// A profile with the calibrated values of one touchpad, which it names.
struct TouchpadProfile {
  Profile profile;
  Message notice;          ///< whose calibrated values these are not, or may not be; empty: nothing to say
  bool set_aside = false;  ///< calibrated values were not taken, and the defaults are used
};

/// "lab.simulated.toml": where the values of a touchpad stand that the profile does not belong to.
[[nodiscard]] std::string valuesFileOf(const std::string& profile_path, const std::string& touchpad);

/// @param path of the profile, which need not be there; empty: none
/// @param touchpad as in touchpad_name.h; empty: it does not answer yet. The profile's own is then expected
[[nodiscard]] Result<TouchpadProfile> loadProfileFor(const std::string& path, const std::string& touchpad);

/// Lets a profile in memory be used with a touchpad: calibrated values of another one become the defaults.
[[nodiscard]] TouchpadProfile withDefaultsFor(Profile profile, const std::string& touchpad);

/// Takes all calibrated values of `from`, and whose they are.
void copyCalibratedValues(const Profile& from, Profile& to);

/// Writes the profile; its calibrated values go to the file of the touchpad that it names, and those of another
/// touchpad in `path` stay. A profile that is new or names no touchpad becomes that of the first real one.
[[nodiscard]] Result<void> saveProfileFor(const Profile& profile, const std::string& path);

}  // namespace fyd::station
