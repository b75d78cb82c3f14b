// The cloth's calibration: presses over each sensor tell how the cloth spreads a press, without a depth gauge.
//
// A sensor under the finger reads nearly all of the indentation, so it tells how deep the finger is, and the other
// sensors tell what share of it they see. Two unknowns for the whole cloth follow from all presses together: the radius
// share κ (r = κ·√(area/π), core/sensing/contact_cloth.h) and the ratio of the tensions along x and y; the edges, held
// or free, are those that fit better. Gauss–Newton on
//
//   Σ (zᵢⱼ − sᵢ(κ, ratio)·δⱼ)²/σᵢⱼ²,    δⱼ of each press from its own readings
//
// What of the stiffness stays unknown (control.measurement_bias) is the doubt that the calibrated mode itself has of
// the indentation, over nine places of the cloth, with the presses' area; no less than the held-out error beside the
// finger.
//
// Held-out error: the presses over one sensor are foretold by a fit on the others, what the sensors beside the finger
// read from the one under it.
#pragma once

#include <vector>

#include "core/calibration/calibration_parameters.h"
#include "core/calibration/calibration_result.h"
#include "core/sensing/indentation_parameters.h"

namespace fyd::calibration {

struct ClothSamples {
  std::vector<std::vector<double>> codes;  ///< per press, one per sensor, means of codes; NaN: none
  std::vector<double> x_mm;                ///< of the contact on the cloth, perspective removed
  std::vector<double> y_mm;
  std::vector<double> area_mm2;  ///< of the contact
};

/// One sensor's part in the presses.
struct ClothSensor {
  std::size_t presses = 0;  ///< over it
  double shallowest_mm = kUnknown;
  double deepest_mm = kUnknown;
};

struct ClothCalibration {
  CalibrationResult result;  ///< coefficients: radius share and tension ratio; valid_from…valid_to in mm of indentation
  sensing::ClothEdges edges = sensing::ClothEdges::held;
  double other_edges_rmse = kUnknown;  ///< of the best fit with the other edges
  double share_sigma = kUnknown;       ///< what the formula leaves of a share
  double stiffness_error = kUnknown;   ///< relative and lasting, over the cloth: half of what the loop is told
  std::vector<ClothSensor> sensors;
};

[[nodiscard]] ClothCalibration calibrateCloth(const ClothSamples& samples,
                                              const sensing::IndentationParameters& profile,
                                              const CalibrationParameters& parameters);

}  // namespace fyd::calibration
