// The cloth's calibration: presses over each sensor show how the cloth spreads a press, without a depth gauge.
//
// A sensor under the finger reads nearly all of the indentation, so it gives the depth, and the other sensors give the
// share of it that they see. Two unknowns for the whole cloth follow from all presses together: the radius
// share κ (r = κ·√(area/π), core/sensing/contact_cloth.h) and the ratio of the tensions along x and y; the edges, held
// or free, are those that fit better. Least squares (Levenberg–Marquardt), with the usual values as a weak prior, on
//
//   Σ (zᵢⱼ − sᵢ(κ, ratio)·δⱼ)²/σᵢⱼ²,    δⱼ of each press from its own readings
//
// The lasting error of the stiffness is the uncertainty that the calibrated mode itself computes for the indentation,
// over nine places of the cloth, with the presses' area; at least the held-out error beside the finger. Twice that
// becomes control.measurement_bias.
//
// Held-out error: for the presses over one sensor, a fit on the other presses predicts the readings of the sensors
// beside the finger from the one under it.
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
  double share_sigma = kUnknown;       ///< error of a share that the formula leaves
  double stiffness_error = kUnknown;   ///< relative and lasting, over the cloth; half of control.measurement_bias
  std::vector<ClothSensor> sensors;
};

[[nodiscard]] ClothCalibration calibrateCloth(const ClothSamples& samples,
                                              const sensing::IndentationParameters& profile,
                                              const CalibrationParameters& parameters);

}  // namespace fyd::calibration
