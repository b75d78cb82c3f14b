// Any robot behind the motion limits. When it did not follow for a while (an error, a controller in another mode), the
// motion starts anew from where the arm then stands, so that no target that piled up meanwhile makes it leap.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "core/device/motion_limiter.h"
#include "core/device/robot.h"

namespace fyd::device {

class FollowingRobot final : public Robot {
 public:
  /// @param limits as checkLimits accepts them
  FollowingRobot(std::unique_ptr<Robot> robot, const MotionLimits& limits)
      : robot_(std::move(robot)), limiter_(limits) {}

  [[nodiscard]] std::string description() const override { return robot_->description(); }
  [[nodiscard]] bool inVirtualTime() const override { return robot_->inVirtualTime(); }

  [[nodiscard]] Result<RobotReadings> exchange(const Vec3& target_mm, Instant now) override {
    auto readings = robot_->exchange(limiter_.apply(target_mm, now), now);
    resumed_ = readings && !following_;
    following_ = readings.has_value();
    if (resumed_) limiter_.reset(readings->commanded_mm.value_or(readings->position_mm));
    return readings;
  }

  /// The last exchange was the first that succeeded: it moved nothing, the next ones start from where the arm stands.
  [[nodiscard]] bool resumed() const { return resumed_; }
  [[nodiscard]] bool following() const { return following_; }
  [[nodiscard]] const MotionLimiter& limiter() const { return limiter_; }

 private:
  std::unique_ptr<Robot> robot_;
  MotionLimiter limiter_;
  bool following_ = false;
  bool resumed_ = false;
};

}  // namespace fyd::device
