// The record of calibrations that goes with a profile: who, when, under which conditions, how well, and what changed.
//
// TOML text, `format = 2` first, one [[record]] per accepted calibration, oldest first. It stands in a file of its own
// beside the profile (lab.toml, lab.calibration.toml), because a profile holds only parameters. A newer
// format, an unknown key or a value of the wrong type is refused with file and line. Format 1 had neither the touchpad
// nor points, coefficients and picture.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/calibration/calibration_parameters.h"
#include "core/calibration/calibration_result.h"

namespace fyd::calibration {

struct CalibrationRecord {
  std::string procedure;
  int sensor = 0;  ///< 1…8 for a distance sensor, 0 where there is only one
  std::string who;
  std::string when;        ///< "2026-11-21T20:15:00Z", UTC
  std::string conditions;  ///< free words: light, temperature, target
  std::string touchpad;    ///< that it was made on: "serial:A7"; empty: not known
  bool simulated = false;  ///< readings or points are those of the simulator
  std::string picture;     ///< file of the fit's picture, in the folder of the record; empty: none
  std::string curve;
  std::string unit;
  std::string verdict;
  std::int64_t points = 0;
  std::int64_t outliers = 0;
  double rmse = kUnknown;
  double held_out_rmse = kUnknown;
  double max_residual = kUnknown;
  double condition_number = kUnknown;
  std::vector<double> residuals;
  std::vector<SampleColumn> samples;
  std::vector<Coefficient> coefficients;
  std::vector<AppliedChange> changes;
};

/// What the conditions of a record of format 1 begin with when its points were simulated.
inline constexpr std::string_view kSimulatedPoints = "simulated points";

/// @param said what the result does not know: sensor, who, when, conditions, touchpad, picture
[[nodiscard]] CalibrationRecord makeRecord(const CalibrationResult& result, std::vector<AppliedChange> changes,
                                           CalibrationRecord said);

[[nodiscard]] std::string formatRecords(std::span<const CalibrationRecord> records);
/// @param source_name stands before the line in messages
[[nodiscard]] Result<std::vector<CalibrationRecord>> parseRecords(std::string_view text, std::string_view source_name);

/// Whether two values, as `formatParameter` writes them, are the same for a sensor: of a list that all distance sensors
/// share only its own entry counts. @param sensor 0: the whole value
[[nodiscard]] bool sameValue(std::string_view a, std::string_view b, int sensor);

/// Whether the profile still holds what the record wrote; false after a change by hand or a newer calibration. Other
/// sensors' entries in a shared list and what a later tare changes do not count.
[[nodiscard]] bool inForce(const CalibrationRecord& record, std::span<const Parameter> parameters);

enum class Age : std::uint8_t { fresh, ageing, old };
[[nodiscard]] std::string_view toString(Age age);

struct AgeOfRecord {
  int days = 0;  ///< 0 for a record of the future: a clock was wrong, and that is said in `warning`
  Age age = Age::fresh;
  Message warning;  ///< empty while fresh
};
/// @param today "2026-11-21" or longer, as `when`; @return an error for a date that is none
[[nodiscard]] Result<AgeOfRecord> ageOf(const CalibrationRecord& record, std::string_view today,
                                        const CalibrationParameters& parameters);

}  // namespace fyd::calibration
