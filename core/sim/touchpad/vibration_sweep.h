// Data of a device test that identifies the simulated path from duty to finger, as the haptic loop records it, with an
// accelerometer on the cloth.
#pragma once

#include <cstdint>
#include <vector>

#include "core/device/touchpad/test_motion.h"
#include "core/sim/finger_vibration_parameters.h"
#include "core/texture/felt/plant_sweep.h"

namespace fyd::sim {

/// @param test breakaway or chirp; @param stretch_deg where the motors stand; the sensor's noise is 2 mg
[[nodiscard]] std::vector<texture::SweepRow> simulatedSweep(const FingerVibrationParameters& parameters,
                                                            device::DeviceTest test, double stretch_deg,
                                                            std::uint64_t seed);

}  // namespace fyd::sim
