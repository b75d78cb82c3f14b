// From the finger to the tool, in virtual time: the simulated touchpad and the step (lockstep.h), both ends of the
// protocol, a network between them, and the robot end's mapping to the arm. The same parts as in a session, without
// threads, sockets and clocks: reproducible, apart from the link's keys.
#pragma once

#include <cstdint>
#include <vector>

#include "core/device/robot/following_robot.h"
#include "core/device/robot/touch_reference.h"
#include "core/sim/network/network_emulator.h"
#include "core/sim/touchpad/lockstep.h"

namespace fyd::sim {

struct ReachSettings {
  /// Its finger should stay on the cloth and, as mapped, within the robot's workspace: the robot then goes where the
  /// finger is (pipeline.absolute_motion), so that the true target is known without the touchpad.
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
  Vec3 finger_mm;  ///< the true one, by the mapping's scale
  Vec3 touch_mm;   ///< as sent, likewise
  Vec3 told_mm;    ///< commanded to the arm, after the limits
  Vec3 tool_mm;    ///< where the arm is
  bool touching = false;
};

/// @return an error for a network setting out of its range
[[nodiscard]] Result<std::vector<ReachRow>> reach(const ReachSettings& settings);

}  // namespace fyd::sim
