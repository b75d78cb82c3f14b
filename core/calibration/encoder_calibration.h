// Encoder calibration from a commanded sweep: sign and zero of both encoders, and the range that was swept.
//
//   counts = zero ± angle·4096/360   (mod 4096)
//
// Counts are unwrapped along the sweep, so neighbouring points must be less than half a turn apart.
#pragma once

#include <array>
#include <vector>

#include "core/calibration/calibration_parameters.h"
#include "core/calibration/calibration_result.h"
#include "core/control/motor_types.h"

namespace fyd::calibration {

struct EncoderSamples {
  /// Commanded angle of each motor and what its encoder says, in the order of the sweep.
  std::array<std::vector<double>, control::kMotorCount> command_deg;
  std::array<std::vector<double>, control::kMotorCount> counts;  ///< 0…4095
};

struct EncoderFinding {
  bool inverted = false;
  int zero_counts = 0;
  double counts_per_deg = kUnknown;  ///< signed; ±11.378 when motor and encoder agree
  double from_deg = kUnknown;
  double to_deg = kUnknown;
};

struct EncoderCalibration {
  CalibrationResult result;  ///< residuals in degrees: the first encoder's points, then the second's
  std::array<EncoderFinding, control::kMotorCount> encoders;
};

[[nodiscard]] EncoderCalibration calibrateEncoders(const EncoderSamples& samples,
                                                   const CalibrationParameters& parameters);

}  // namespace fyd::calibration
