// What an accepted calibration changes: the calibrated values of its touchpad, and the record beside the profile.
#pragma once

#include <string>
#include <vector>

#include "core/station/profile/calibration_records.h"
#include "core/station/profile/profile.h"

namespace fyd::station {

/// Applies an accepted result to the profile and saves it with its record appended. When anything fails, the profile in
/// memory, the files and the record are as they were.
/// @param record who, when, conditions and sensor; the rest is filled in from the result
/// @param profile of the touchpad that was calibrated, which it names (calibrated_values.h)
[[nodiscard]] Result<calibration::CalibrationRecord> saveCalibration(const calibration::CalibrationResult& result,
                                                                     calibration::CalibrationRecord record,
                                                                     Profile& profile, const std::string& profile_path);

struct OutdatedPart {
  std::string part;  ///< "no-touch"
  Message why;       ///< "taken with another curve: take it again (distance sensor 2)"
};
/// The parts whose values rest on an older calibration of the profile's touchpad; see calibration_dependence.h.
[[nodiscard]] Result<std::vector<OutdatedPart>> outdatedParts(const std::string& profile_path, Profile profile);

}  // namespace fyd::station
