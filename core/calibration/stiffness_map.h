// The stiffness map: which stretch angle gives which stiffness, from presses at known angles.
//
//   F = k(angle)·indentation + c, one k per angle, one c for all: c is the remaining tare error
//
// The slopes become a law that rises strictly with the angle: neighbours that fall within their uncertainty are pooled
// (isotonic regression, weighted by 1/σ²), a fall beyond it is refused. control.law interpolates the points
// monotonically (core/control/static_law.h), so nothing more is fitted through them.
#pragma once

#include <vector>

#include "core/calibration/calibration_parameters.h"
#include "core/calibration/calibration_result.h"

namespace fyd::calibration {

/// The deepest press at an angle must be at least this deep to determine a stiffness.
inline constexpr double kLeastPress_mm = 0.5;

struct StiffnessSamples {
  std::vector<double> angle_deg;
  std::vector<double> indentation_mm;
  std::vector<double> force_N;
};

struct AngleStiffness {
  double angle_deg = 0.0;  ///< mean of the points
  double stiffness_N_per_mm = 0.0;
  double standard_error = kUnknown;
  double low_95 = kUnknown;  ///< 95 % interval
  double high_95 = kUnknown;
  std::size_t points = 0;
};

struct StiffnessMap {
  CalibrationResult result;            ///< coefficients: k of each angle; valid_from…valid_to in degrees
  std::vector<AngleStiffness> angles;  ///< rising
  double force_offset_N = kUnknown;    ///< c; NaN when the presses cannot determine it, then taken as 0
  double force_offset_error_N = kUnknown;
  std::vector<double> law_angle_deg;  ///< rising; what the control law takes
  std::vector<double> law_stiffness_N_per_mm;
};

[[nodiscard]] StiffnessMap calibrateStiffness(const StiffnessSamples& samples, const CalibrationParameters& parameters);

/// Says in the verdict and the notes that no cloth calibration has verified the indentation, whose relative error the
/// stiffness shares.
void sayIndentationUnproven(CalibrationResult& result);

/// Weighted isotonic regression by pooling adjacent violators: blocks with their mean place and rising level.
struct MonotonePoint {
  double place = 0.0;
  double level = 0.0;
  double weight = 0.0;
};
[[nodiscard]] std::vector<MonotonePoint> poolViolators(const std::vector<MonotonePoint>& points);

}  // namespace fyd::calibration
