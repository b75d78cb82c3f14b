// Inputs of a step in which nothing is missing: a finger presses in the middle of three sensors.
#pragma once

#include <array>
#include <cstdint>

#include "core/pipeline/inputs.h"

namespace fyd::pipeline {

inline constexpr std::array<std::uint16_t, control::kMotorCount> kCountsAt20_deg = {228, 3868};  // ±20°

/// Something new of each device and of the robot's state at `now`; commands, accelerations and the link's phase stay.
inline void makeWhole(Inputs& inputs, Instant now,
                      const std::array<std::uint16_t, control::kMotorCount>& encoder_counts = kCountsAt20_deg) {
  sensing::FingerDetection finger;
  finger.contact = true;
  finger.area_px = 400;
  finger.quality = 1;
  finger.reason = sensing::FingerReason::found;
  sensing::IrCounts ir;
  for (int i = 0; i < 3; ++i) (void)ir.push(1500);
  inputs.now = now;
  inputs.finger.set(finger, now);
  inputs.ir.set(ir, now);
  inputs.bridge.set({.value_mV_per_V = 0.3}, now);
  inputs.motors.set({.encoder_counts = encoder_counts}, now);
  inputs.robot.state.set({.stiffness_N_per_mm = 0.6}, now);
}

}  // namespace fyd::pipeline
