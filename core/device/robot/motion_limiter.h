// Limits of an arm's commands: workspace, speed, acceleration and jerk, for any target. Pure: one call gives one
// command, and the time between two commands, the arm's tick, is a parameter. The tick is the arm's own, not this
// machine's: an arm that takes a command every 5 ms gets 5 ms of motion in each, even if the messages behind the
// targets arrive late or in bursts.
//
// Each axis follows its goal (the target, clamped to the workspace) with its share 1/√3 of the three limits, so that
// the vectors stay within them; see axis_motion.h. It reaches a target at rest without overshoot, meets a moving one,
// and never leaves the workspace. An axis that begins outside of it is not driven back: it may go where its target
// leads it, no further out than where it stood, until it has come inside.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/error.h"
#include "core/base/vec3.h"
#include "core/device/robot/axis_motion.h"

namespace fyd::device {

struct MotionLimits {
  Vec3 workspace_mm{35.0, 25.0, 70.0};  ///< ± from the start, each > 0 [authors' program]
  double speed_mm_s = 250.0;            ///< 1…1000
  double acceleration_mm_s2 = 5000.0;   ///< 10…100 000
  double jerk_mm_s3 = 250'000.0;        ///< 1000…10 000 000; the default: 20 ms from rest to the whole acceleration
};

/// @return an error that names the limit, its value and its range
[[nodiscard]] Result<void> checkLimits(const MotionLimits& limits);

class MotionLimiter {
 public:
  /// @param limits as checkLimits accepts them
  explicit MotionLimiter(const MotionLimits& limits = {});

  /// At rest at `position_mm`, even outside of the workspace; a position that is not finite changes nothing.
  void reset(const Vec3& position_mm);
  /// At rest at the present position.
  void stand();

  /// The next position to command, mm, always finite. A target that is not finite is refused: the last goal stays.
  /// @param tick_s until the arm takes the next command, s; above 1 counts as 1; what is not above 0 moves nothing
  /// @param velocity_mm_s of the target: at constant velocity it is followed without lag. Not finite counts as 0
  const Vec3& advance(const Vec3& target_mm, double tick_s, const Vec3& velocity_mm_s = {});
  /// The next position of the fastest stop, which becomes the goal.
  const Vec3& brake(double tick_s);

  [[nodiscard]] const Vec3& position_mm() const { return position_mm_; }
  [[nodiscard]] bool atRest() const;
  /// Targets refused so far.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  /// Where an axis may go: the workspace, and as far beyond it as the axis stood.
  struct Room {
    double low = 0.0, high = 0.0;
    [[nodiscard]] double nearest(double place) const { return std::clamp(place, low, high); }
    [[nodiscard]] bool holds(double place) const { return place >= low && place <= high; }
  };

  [[nodiscard]] AxisState next(const AxisState& axis, double goal, double wanted, double velocity, const Room& room,
                               double tick_s) const;
  void narrow(std::size_t axis, double edge, double& goal);
  const Vec3& take();

  MotionLimits limits_;
  AxisLimits axis_limits_;
  std::array<AxisState, 3> axes_{};
  std::array<Room, 3> rooms_{};
  Vec3 goal_mm_;
  Vec3 position_mm_;
  std::uint64_t refused_ = 0;
};

}  // namespace fyd::device
