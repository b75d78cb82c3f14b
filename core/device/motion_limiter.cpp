#include "core/device/motion_limiter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fyd::device {
namespace {

constexpr Duration kStep = std::chrono::milliseconds(1);
constexpr double kStep_s = 0.001;
constexpr Duration kLongestCatchUp = std::chrono::milliseconds(20);

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
  return {};
}

MotionLimiter::MotionLimiter(const MotionLimits& limits)
    : limits_(limits),
      axis_speed_(limits.speed_mm_s / std::numbers::sqrt3),
      axis_acceleration_(limits.acceleration_mm_s2 / std::numbers::sqrt3) {}

void MotionLimiter::reset(const Vec3& position_mm) {
  if (!position_mm.finite()) return;
  position_mm_ = position_mm;
  goal_mm_ = position_mm;
  velocity_mm_s_ = {};
  owed_ = {};
}

const Vec3& MotionLimiter::apply(const Vec3& target_mm, Instant now) {
  if (target_mm.finite()) {
    const Vec3& w = limits_.workspace_mm;
    goal_mm_ = {std::clamp(target_mm.x, -w.x, w.x), std::clamp(target_mm.y, -w.y, w.y),
                std::clamp(target_mm.z, -w.z, w.z)};
  } else {
    ++refused_;
  }
  if (!started_ || now > last_) {
    if (started_) owed_ = std::min(owed_ + std::min<Duration>(now - last_, kLongestCatchUp), kLongestCatchUp);
    started_ = true;
    last_ = now;
  }
  for (; owed_ >= kStep; owed_ -= kStep) step();
  return position_mm_;
}

void MotionLimiter::step() {
  stepAxis(position_mm_.x, velocity_mm_s_.x, goal_mm_.x);
  stepAxis(position_mm_.y, velocity_mm_s_.y, goal_mm_.y);
  stepAxis(position_mm_.z, velocity_mm_s_.z, goal_mm_.z);
}

void MotionLimiter::stepAxis(double& position, double& velocity, double goal) const {
  const double speed_unit = axis_acceleration_ * kStep_s;
  const double distance_unit = speed_unit * kStep_s;
  const double distance = std::abs(goal - position) / distance_unit;
  double whole = std::floor(std::sqrt(0.25 + 2.0 * distance) - 0.5);
  if (whole < 0.0) whole = 0.0;
  const double rest = distance - whole * (whole + 1.0) / 2.0;
  const double braking = (whole + rest / (whole + 1.0)) * speed_unit;
  const double wanted = std::copysign(std::min(braking, axis_speed_), goal - position);
  velocity += std::clamp(wanted - velocity, -speed_unit, speed_unit);
  position += velocity * kStep_s;
}

}  // namespace fyd::device
