// From the finger to the tool, in virtual time: the simulated touchpad and the step (lockstep.h), both ends of the
// protocol, a network between them, and the robot end's own way to the arm. The same parts as in a session, without
// threads, sockets and clocks: the same every time, apart from the link's keys.
#pragma once

#include <cstdint>
#include <vector>

#include "core/device/following_robot.h"
#include "core/device/touch_reference.h"
#include "core/sim/lockstep.h"
#include "core/sim/network_emulator.h"

namespace fyd::sim {

struct ReachSettings {
  /// Its finger should stay on the cloth and within the robot's workspace by the mapping: the robot then goes where the
  /// finger is (pipeline.absolute_motion), so that the truth is known without the touchpad.
  LockstepOptions touchpad;
  NetworkProfile network;  ///< forward leads to the touchpad
  bool secured = true;     ///< FYD Link; false: the classic protocol
  device::TouchReferenceSettings reference;
  device::MotionLimits limits;
  double seconds = 10.0;
};

/// Millisecond by millisecond, in the touchpad's frame, mm.
struct ReachRow {
  double t_s = 0.0;
  Vec3 finger_mm;  ///< the truth, by the mapping's scale
  Vec3 touch_mm;   ///< as sent, likewise
  Vec3 told_mm;    ///< what the limits let through to the arm
  Vec3 tool_mm;    ///< where the arm is
  bool touching = false;
};

/// @return an error for a network setting out of its range
[[nodiscard]] Result<std::vector<ReachRow>> reach(const ReachSettings& settings);

}  // namespace fyd::sim
