// The file of calibration records beside a profile: lab.toml goes with lab.calibration.toml. It holds those of every
// touchpad that the profile was used with.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/calibration/calibration_record.h"

namespace fyd::station {

/// "lab" for "lab.toml", in the same folder: what the names of files beside a profile begin with.
[[nodiscard]] std::string stemOf(const std::string& profile_path);

/// "lab.calibration.toml" for "lab.toml", in the same folder.
[[nodiscard]] std::string calibrationFileOf(const std::string& profile_path);

/// The text of that file; nothing where there is none.
[[nodiscard]] Result<std::optional<std::string>> readCalibrationFile(const std::string& profile_path);

/// The records beside a profile, oldest first; none when there is no such file.
[[nodiscard]] Result<std::vector<calibration::CalibrationRecord>> loadCalibrationRecords(
    const std::string& profile_path);

/// Those that count for a touchpad: its own; for a real one also those of earlier versions, which name none.
/// @param touchpad as in touchpad_name.h; empty: not known, every real one's
[[nodiscard]] std::vector<calibration::CalibrationRecord> recordsFor(
    std::vector<calibration::CalibrationRecord> records, std::string_view touchpad);

}  // namespace fyd::station
