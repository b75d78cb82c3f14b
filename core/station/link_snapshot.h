// What the link thread hands to the haptic loop, which reads only the newest of it.
#pragma once

#include <cstdint>

#include "core/base/timed.h"
#include "core/pipeline/inputs.h"

namespace fyd::station {

/// The latest state values from the robot; its streams go through the rings.
struct LinkSnapshot {
  pipeline::LinkPhase phase = pipeline::LinkPhase::waiting;
  // Each increases even with what was over before the loop read it.
  std::uint64_t losses = 0;    ///< of the link
  std::uint64_t sessions = 0;  ///< begun by a robot
  Timed<pipeline::RobotState> state;
  Timed<pipeline::RobotMotorReference> motor_reference;
  double sample_delay_ms = 0.0;  ///< how long the texture must wait for accelerations; 0: for none (classic)
};

/// The phase for one step after the other: a loss and a new session are seen for a step each, also when both were over
/// before the loop read the snapshot. Else a robot that restarts within a cycle would be taken for the one before.
class SeenPhase {
 public:
  [[nodiscard]] pipeline::LinkPhase next(const LinkSnapshot& newest) {
    if (newest.losses != losses_) {
      losses_ = newest.losses;
      return pipeline::LinkPhase::lost;
    }
    if (newest.sessions != sessions_) {
      sessions_ = newest.sessions;
      return pipeline::LinkPhase::waiting;
    }
    return newest.phase;
  }

 private:
  std::uint64_t losses_ = 0;
  std::uint64_t sessions_ = 0;
};

}  // namespace fyd::station
