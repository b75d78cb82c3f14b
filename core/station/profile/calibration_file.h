// The record of calibrations beside a profile: lab.toml goes with lab.calibration.toml.
#pragma once

#include <string>
#include <vector>

#include "core/calibration/calibration_record.h"
#include "core/station/profile/profile.h"

namespace fyd::station {

/// "lab.calibration.toml" for "lab.toml", in the same folder.
[[nodiscard]] std::string calibrationFileOf(const std::string& profile_path);

/// The records beside a profile, oldest first; none when there is no such file.
[[nodiscard]] Result<std::vector<calibration::CalibrationRecord>> loadCalibrationRecords(
    const std::string& profile_path);

/// Applies an accepted result to the profile and saves it with its record appended. When anything fails, the profile in
/// memory, the file and its record are as they were.
/// @param record who, when, conditions and sensor; the rest is filled in from the result
[[nodiscard]] Result<calibration::CalibrationRecord> saveCalibration(const calibration::CalibrationResult& result,
                                                                     calibration::CalibrationRecord record,
                                                                     Profile& profile, const std::string& profile_path);

struct OutdatedPart {
  std::string part;  ///< "no-touch"
  Message why;       ///< "taken with another curve: take it again (distance sensor 2)"
};
/// The parts whose values rest on an older calibration than the profile has; see calibration_dependence.h.
[[nodiscard]] Result<std::vector<OutdatedPart>> outdatedParts(const std::string& profile_path, Profile profile);

}  // namespace fyd::station
