// A finger pressed over each distance sensor in turn, as the operator does for the cloth's calibration.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/sim/sim_parameters.h"
#include "core/sim/touchpad/ir_sensor.h"
#include "core/sim/touchpad/picture.h"

namespace fyd::sim {

struct ClothPress {
  double depth_mm = 0.0;
  Spot contact;                                          ///< on the cloth
  Spot seen;                                             ///< as the camera shows it
  std::array<double, kIrPlaces.size()> deflection_mm{};  ///< over each sensor
};

/// @param depths_mm of the presses over each sensor, one after the other, mm
[[nodiscard]] std::vector<ClothPress> pressesOverSensors(const SimParameters& parameters, double stretch_deg,
                                                         std::span<const double> depths_mm);

}  // namespace fyd::sim
