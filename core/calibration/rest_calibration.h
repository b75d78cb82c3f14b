// Calibrations that use readings at rest only: the accelerometer lying still, and the distances and force of the
// untouched cloth.
//
// The accelerometer's mean is not kept in the profile: in a session the robot's end may subtract rest before it sends
// (core/device/robot/robot_preparation.h), and what is left of it the texture's high-pass takes away; the offline chain
// subtracts the first reading (core/texture/rest_removal.h). The calibration judges whether the sensor is plausible:
// still, and 1 g long, or about 0 g where the robot's end subtracts. Exactly 0 without any noise means that there is no
// sensor.
#pragma once

#include <array>
#include <vector>

#include "core/calibration/calibration_parameters.h"
#include "core/calibration/calibration_result.h"
#include "core/sensing/tare.h"

namespace fyd::calibration {

struct RestSamples {
  std::array<std::vector<double>, 3> axis_g;  ///< x, y, z
};

struct RestCalibration {
  CalibrationResult result;  ///< coefficients: mean of x, y, z; residuals: |a − mean| of each sample; changes nothing
  std::array<double, 3> mean_g{};
  std::array<double, 3> sigma_g{};
  double magnitude_g = kUnknown;
};

[[nodiscard]] RestCalibration calibrateRest(const RestSamples& samples, const CalibrationParameters& parameters);

/// What a finished or failed tare (sensing/tare.h) says, in the form of the other calibrations: the offsets of the
/// distance sensors and the load cell's zero, or why the cloth was not at rest.
/// @param zero_N the load cell's present zero, which the tare's force is read against
[[nodiscard]] CalibrationResult judgeTare(sensing::TareState state, const sensing::TareResult& tare, double zero_N);

}  // namespace fyd::calibration
