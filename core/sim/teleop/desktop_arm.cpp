#include "core/sim/teleop/desktop_arm.h"

#include <algorithm>
#include <cmath>

namespace fyd::sim {

protocol::Workspace DesktopArm::workspace() {
  return {.minimum_mm = -0.5 * kWorkspace_mm, .maximum_mm = 0.5 * kWorkspace_mm, .precision_mm = kPrecision_mm};
}

void DesktopArm::step(const Vec3& motors_N, const Vec3& outside_N, double dt_s) {
  const auto axis = [&](double motor, double outside, double side, double& at, double& velocity) {
    const double force = std::clamp(std::isfinite(motor) ? motor : 0.0, -kMostForce_N, kMostForce_N) + outside -
                         kFriction_N_s_per_m * 1e-3 * velocity;
    velocity += 1e3 * dt_s * force / mass_kg_;
    at += dt_s * velocity;
    const double within = std::clamp(at, -0.5 * side, 0.5 * side);
    if (at != within) {  // a stop
      at = within;
      velocity = 0.0;
    }
  };
  axis(motors_N.x, outside_N.x, kWorkspace_mm.x, at_mm_.x, velocity_mm_per_s_.x);
  axis(motors_N.y, outside_N.y, kWorkspace_mm.y, at_mm_.y, velocity_mm_per_s_.y);
  axis(motors_N.z, outside_N.z, kWorkspace_mm.z, at_mm_.z, velocity_mm_per_s_.z);
}

Vec3 DesktopArm::measured_mm() const {
  const auto read = [](double at, double side) {
    return kPrecision_mm * std::round(std::clamp(at, -0.5 * side, 0.5 * side) / kPrecision_mm);
  };
  return {read(at_mm_.x, kWorkspace_mm.x), read(at_mm_.y, kWorkspace_mm.y), read(at_mm_.z, kWorkspace_mm.z)};
}

}  // namespace fyd::sim
