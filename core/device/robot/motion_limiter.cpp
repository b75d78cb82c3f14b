#include "core/device/robot/motion_limiter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fyd::device {
namespace {

constexpr double kLongestTick_s = 1.0;

double tickOf(double tick_s) { return tick_s > 0.0 ? std::min(tick_s, kLongestTick_s) : 0.0; }

}  // namespace

Result<void> checkLimits(const MotionLimits& limits) {
  const Vec3& w = limits.workspace_mm;
  if (!w.finite() || !(std::min({w.x, w.y, w.z}) > 0.0)) {
    return fail("workspace ±({}, {}, {}) mm: expected three numbers above 0", w.x, w.y, w.z);
  }
  if (!(limits.speed_mm_s >= 1.0 && limits.speed_mm_s <= 1000.0)) {
    return fail("speed limit {} mm/s: expected 1 to 1000", limits.speed_mm_s);
  }
  if (!(limits.acceleration_mm_s2 >= 10.0 && limits.acceleration_mm_s2 <= 100'000.0)) {
    return fail("acceleration limit {} mm/s²: expected 10 to 100000", limits.acceleration_mm_s2);
  }
  if (!(limits.jerk_mm_s3 >= 1000.0 && limits.jerk_mm_s3 <= 1e7)) {
    return fail("jerk limit {} mm/s³: expected 1000 to 10000000", limits.jerk_mm_s3);
  }
  return {};
}

MotionLimiter::MotionLimiter(const MotionLimits& limits)
    : limits_(limits),
      axis_limits_{.speed = limits.speed_mm_s / std::numbers::sqrt3,
                   .acceleration = limits.acceleration_mm_s2 / std::numbers::sqrt3,
                   .jerk = limits.jerk_mm_s3 / std::numbers::sqrt3} {
  reset({});
}

void MotionLimiter::reset(const Vec3& position_mm) {
  if (!position_mm.finite()) return;
  axes_ = {AxisState{.position = position_mm.x}, AxisState{.position = position_mm.y},
           AxisState{.position = position_mm.z}};
  const Vec3& w = limits_.workspace_mm;
  const auto room = [](double place, double edge) {
    return Room{.low = std::min(-edge, place), .high = std::max(edge, place)};
  };
  rooms_ = {room(position_mm.x, w.x), room(position_mm.y, w.y), room(position_mm.z, w.z)};
  goal_mm_ = position_mm;
  position_mm_ = position_mm;
}

void MotionLimiter::stand() { reset(Vec3(position_mm_)); }

AxisState MotionLimiter::next(const AxisState& axis, double goal, double wanted, double velocity, const Room& room,
                              double tick_s) const {
  if (velocity != 0.0 && goal == wanted) {
    const AxisState met =
        meet(axis, goal, std::clamp(velocity, -axis_limits_.speed, axis_limits_.speed), axis_limits_, tick_s);
    // From each state a stop within the room is possible.
    if (room.holds(restPlace(met, axis_limits_))) return met;
  }
  return approach(axis, goal, axis_limits_, tick_s);
}

const Vec3& MotionLimiter::advance(const Vec3& target_mm, double tick_s, const Vec3& velocity_mm_s) {
  Vec3 wanted_mm = goal_mm_;
  Vec3 velocity{};
  if (target_mm.finite()) {
    wanted_mm = target_mm;
    if (velocity_mm_s.finite()) velocity = velocity_mm_s;
    goal_mm_ = {rooms_[0].nearest(target_mm.x), rooms_[1].nearest(target_mm.y), rooms_[2].nearest(target_mm.z)};
  } else {
    ++refused_;
  }
  const double tick = tickOf(tick_s);
  axes_[0] = next(axes_[0], goal_mm_.x, wanted_mm.x, velocity.x, rooms_[0], tick);
  axes_[1] = next(axes_[1], goal_mm_.y, wanted_mm.y, velocity.y, rooms_[1], tick);
  axes_[2] = next(axes_[2], goal_mm_.z, wanted_mm.z, velocity.z, rooms_[2], tick);
  return take();
}

const Vec3& MotionLimiter::brake(double tick_s) {
  for (AxisState& axis : axes_) axis = device::brake(axis, axis_limits_, tickOf(tick_s));
  goal_mm_ = {restPlace(axes_[0], axis_limits_), restPlace(axes_[1], axis_limits_), restPlace(axes_[2], axis_limits_)};
  return take();
}

/// An axis that has come into the workspace, and will stop in it, stays in it.
void MotionLimiter::narrow(std::size_t axis, double edge, double& goal) {
  Room& room = rooms_[axis];
  const Room inside{.low = -edge, .high = edge};
  if (inside.holds(room.low) && inside.holds(room.high)) return;
  if (!inside.holds(axes_[axis].position) || !inside.holds(restPlace(axes_[axis], axis_limits_))) return;
  room = inside;
  goal = inside.nearest(goal);
}

const Vec3& MotionLimiter::take() {
  narrow(0, limits_.workspace_mm.x, goal_mm_.x);
  narrow(1, limits_.workspace_mm.y, goal_mm_.y);
  narrow(2, limits_.workspace_mm.z, goal_mm_.z);
  position_mm_ = {axes_[0].position, axes_[1].position, axes_[2].position};
  return position_mm_;
}

bool MotionLimiter::atRest() const { return axes_[0].atRest() && axes_[1].atRest() && axes_[2].atRest(); }

}  // namespace fyd::device
