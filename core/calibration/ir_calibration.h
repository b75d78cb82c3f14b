// Calibration of one distance sensor from readings at known distances.
//
// Every candidate curve is fitted and judged by its held-out error (whole distances held out, the nearest and the
// farthest always known, so that the error is one of interpolation, in units of the expected noise). The simplest curve
// within 5 % of the best is chosen. A curve must fall at every single ADC code of its span, as the step would read it.
#pragma once

#include <cstddef>
#include <vector>

#include "core/calibration/calibration_parameters.h"
#include "core/calibration/calibration_result.h"
#include "core/calibration/ir_choice.h"
#include "core/sensing/indentation_parameters.h"

namespace fyd::calibration {

struct IrSamples {
  std::vector<double> adc;          ///< 0…4095, may be means
  std::vector<double> distance_mm;  ///< known, 1…1000
};

struct IrOptions {
  std::size_t sensor = 0;         ///< 0…7, whose curve and span the changes set
  bool without_outliers = false;  ///< fit without the points the others contradict; they are still listed
};

struct IrCalibration {
  CalibrationResult result;  ///< valid_from…valid_to in ADC counts
  IrCurve curve;
  double valid_from_mm = kUnknown;  ///< distance at the highest code
  double valid_to_mm = kUnknown;
  std::vector<IrAttempt> attempts;
};

/// @param present the profile's, for the sensor's noise and the lists that the changes extend
[[nodiscard]] IrCalibration calibrateIr(const IrSamples& samples, const sensing::IndentationParameters& present,
                                        const CalibrationParameters& parameters, const IrOptions& options = {});

}  // namespace fyd::calibration
