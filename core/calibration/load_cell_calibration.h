// Calibration of the load cell from known weights: F = slope·value + offset, ordinary least squares over all points.
//
// Outliers are named and kept. Beside the line: drift (what the residual gains from the first point to the last, told
// apart from the force by fitting both), and hysteresis (mean residual while loading less that while unloading).
#pragma once

#include <vector>

#include "core/calibration/calibration_parameters.h"
#include "core/calibration/calibration_result.h"

namespace fyd::calibration {

struct LoadCellSamples {
  std::vector<double> value_mV_per_V;  ///< in the order they were taken
  std::vector<double> force_N;
};

struct LoadCellCalibration {
  CalibrationResult result;           ///< coefficients: slope (N per mV/V), offset (N); valid_from…valid_to in mV/V
  double drift_N = kUnknown;          ///< from the first point to the last; NaN when order and force go together
  double drift_error_N = kUnknown;    ///< standard error
  double hysteresis_N = kUnknown;     ///< NaN unless two weights or more were both put on and taken off
  double repeatability_N = kUnknown;  ///< spread of points at the same weight; NaN without repeats
};

[[nodiscard]] LoadCellCalibration calibrateLoadCell(const LoadCellSamples& samples,
                                                    const CalibrationParameters& parameters);

}  // namespace fyd::calibration
