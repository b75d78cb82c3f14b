// Calibration of the vibration plant, from duty to finger: core/texture/felt/felt_identification.h with a verdict in
// words and the parameters texture.plant_* it would change.
#pragma once

#include <vector>

#include "core/calibration/calibration_result.h"
#include "core/texture/felt/felt_identification.h"

namespace fyd::calibration {

struct TextureCalibration {
  CalibrationResult result;                ///< coefficients: resonance, damping, breakaway of each motor
  texture::FeltIdentification identified;  ///< while the verdict is accepted
};

/// @param profile  what the sweep does not identify: free speed, time constant, position gain, radius
[[nodiscard]] TextureCalibration calibrateTexture(const std::vector<texture::SweepRow>& sweep,
                                                  const texture::FeltPlant& profile);

}  // namespace fyd::calibration
