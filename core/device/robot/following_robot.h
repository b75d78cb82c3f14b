// Any robot behind the motion limits. The arm keeps them itself in its own tick, or else they are kept here, one tick
// per exchange. When the arm did not follow for a while (an error, a controller in another mode), the motion starts
// anew from where it then stands, so that it does not jump to the target.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/device/robot/motion_limiter.h"
#include "core/device/robot/robot.h"

namespace fyd::device {

class FollowingRobot final {
 public:
  /// @param limits as checkLimits accepts them
  FollowingRobot(std::unique_ptr<Robot> robot, const MotionLimits& limits)
      : robot_(std::move(robot)), limiter_(limits), robot_keeps_limits_(robot_->keepLimits(limits)) {}

  [[nodiscard]] Message description() const { return robot_->description(); }
  [[nodiscard]] bool inVirtualTime() const { return robot_->inVirtualTime(); }
  [[nodiscard]] double lag_s() const { return robot_->lag_s(); }

  /// @param target_mm if not finite, it is refused and the last one stays
  /// @param velocity_mm_s of the target: at constant velocity it is followed without lag
  /// @param tick_s nominal time from this exchange to the next, s: the machine's delays do not change the motion
  /// @return an error as Robot::exchange gives it
  [[nodiscard]] Result<RobotReadings> exchange(const Vec3& target_mm, double tick_s, Instant now,
                                               const Vec3& velocity_mm_s = {}) {
    if (target_mm.finite()) {
      target_mm_ = target_mm;
      velocity_mm_s_ = velocity_mm_s;
    } else {
      ++refused_;
      velocity_mm_s_ = {};
    }
    robot_->targetMoves(velocity_mm_s_);
    auto readings = robot_->exchange(robot_keeps_limits_ ? target_mm_ : advanced(tick_s), now);
    resumed_ = readings && !following_;
    following_ = readings.has_value();
    if (resumed_) {
      limiter_.reset(readings->commanded_mm.value_or(readings->position_mm));
      target_mm_ = limiter_.position_mm();
      velocity_mm_s_ = {};
    }
    if (readings)
      commanded_mm_ = robot_keeps_limits_ ? readings->commanded_mm.value_or(target_mm_) : limiter_.position_mm();
    return readings;
  }
  /// Brakes within the limits from the next exchange on, whatever the target.
  void comeToRest() {
    stopping_ = true;
    robot_->comeToRest();
  }
  /// Whether the commanded position is at rest.
  [[nodiscard]] bool atRest() const { return robot_keeps_limits_ ? robot_->atRest() : limiter_.atRest(); }

  /// The last exchange was the first that succeeded: it moved nothing, the next ones start from where the arm stands.
  [[nodiscard]] bool resumed() const { return resumed_; }
  [[nodiscard]] bool following() const { return following_; }
  /// The commanded position when the arm last followed.
  [[nodiscard]] const Vec3& commanded_mm() const { return commanded_mm_; }
  /// Targets refused so far because they were not finite.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  const Vec3& advanced(double tick_s) {
    return stopping_ ? limiter_.brake(tick_s) : limiter_.advance(target_mm_, tick_s, velocity_mm_s_);
  }

  std::unique_ptr<Robot> robot_;
  MotionLimiter limiter_;
  bool robot_keeps_limits_;
  Vec3 target_mm_;
  Vec3 velocity_mm_s_;
  Vec3 commanded_mm_;
  std::uint64_t refused_ = 0;
  bool following_ = false;
  bool resumed_ = false;
  bool stopping_ = false;
};

}  // namespace fyd::device
