#include "core/sim/robot/robot_arm.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fyd::sim {
namespace {

constexpr double kAccelerationLimit_mm_s2 = 10'000.0;
constexpr double kLongestStep_s = 0.001;
constexpr double kLongestCatchUp_s = 0.1;
constexpr double kHalfSpeed_mm_s = 30.0;    // speed at which vibration has half the amplitude of high speed
constexpr double kStrongestForce_N = 10.0;  // beyond which the vibration does not grow
constexpr double kWaveLimit_Hz = 400.0;     // the tool's body damps higher frequencies
constexpr std::uint64_t kRobotStream = 0x726f626f74ULL;

double length(const Vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }

Vec3 shortened(const Vec3& v, double longest) {
  const double l = length(v);
  return l > longest ? longest / l * v : v;
}

Vec3 clamped(const Vec3& v, const Vec3& limit) {
  return {std::clamp(v.x, -limit.x, limit.x), std::clamp(v.y, -limit.y, limit.y), std::clamp(v.z, -limit.z, limit.z)};
}

}  // namespace

RobotArm::RobotArm(const SimParameters& parameters)
    : parameters_(parameters),
      material_(propertiesOf(parameters.material)),
      stiffness_(parameters.material_stiffness_N_per_mm > 0.0 && parameters.material != Material::none
                     ? parameters.material_stiffness_N_per_mm
                     : material_.stiffness_N_per_mm),
      random_(static_cast<std::uint64_t>(parameters.seed) ^ kRobotStream) {}

Message RobotArm::description() const {
  return say("simulated robot on {}", kMaterialNames[static_cast<std::size_t>(parameters_.material)]);
}

Result<device::RobotReadings> RobotArm::exchange(const Vec3& target_mm, Instant now) {
  if (!target_mm.finite()) {
    return fail("robot target ({}, {}, {}) mm: expected three finite numbers", target_mm.x, target_mm.y, target_mm.z);
  }
  target_mm_ = clamped(target_mm, kRobotWorkspace_mm);
  if (!started_ || now > last_) {
    double left_s = started_ ? std::min(toSeconds(now - last_), kLongestCatchUp_s) : 0.0;
    started_ = true;
    last_ = now;
    while (left_s > 0.0) {
      const double dt_s = std::min(left_s, kLongestStep_s);
      step(dt_s);
      left_s -= dt_s;
    }
  }
  const double z_mm = depth_mm_ > 0.0 ? kMaterialSurface_mm - depth_mm_ : reference_mm_.z;
  return device::RobotReadings{.position_mm = {reference_mm_.x, reference_mm_.y, z_mm},
                               .force_N = force_N_,
                               .acceleration_g = senseAcceleration(),
                               .taken = last_,
                               .commanded_mm = reference_mm_};
}

void RobotArm::step(double dt_s) {
  moveReference(dt_s);
  pressMaterial(dt_s);
  if (force_N_ > 0.0) travelled_mm_ += std::hypot(velocity_mm_s_.x, velocity_mm_s_.y) * dt_s;
}

void RobotArm::moveReference(double dt_s) {
  const Vec3 wanted =
      kBandwidth_rad_s * kBandwidth_rad_s * (target_mm_ - reference_mm_) - 2.0 * kBandwidth_rad_s * velocity_mm_s_;
  const Vec3 acceleration = shortened(wanted, kAccelerationLimit_mm_s2);
  velocity_mm_s_ = shortened(velocity_mm_s_ + dt_s * acceleration, parameters_.robot_speed_limit_mm_s);
  const Vec3 next = reference_mm_ + dt_s * velocity_mm_s_;
  reference_mm_ = clamped(next, kRobotWorkspace_mm);
  if (reference_mm_.x != next.x) velocity_mm_s_.x = 0.0;
  if (reference_mm_.y != next.y) velocity_mm_s_.y = 0.0;
  if (reference_mm_.z != next.z) velocity_mm_s_.z = 0.0;
}

void RobotArm::pressMaterial(double dt_s) {
  const double below_mm = kMaterialSurface_mm - reference_mm_.z;
  if (below_mm <= 0.0 || stiffness_ <= 0.0) {
    depth_mm_ = 0.0;
    force_N_ = 0.0;
    return;
  }
  const double impedance = parameters_.robot_stiffness_N_per_mm;
  const double together = impedance + stiffness_;
  const double settled_mm = impedance * below_mm / together;
  const double damping = material_.damping_Ns_per_mm;
  const double remains = damping > 0.0 ? std::exp(-together * dt_s / damping) : 0.0;  // exact for any step
  depth_mm_ = std::min(settled_mm + (depth_mm_ - settled_mm) * remains, below_mm);
  force_N_ = impedance * (below_mm - depth_mm_);
}

Vec3 RobotArm::senseAcceleration() {
  const double speed = force_N_ > 0.0 ? std::hypot(velocity_mm_s_.x, velocity_mm_s_.y) : 0.0;
  const double strength = speed / (speed + kHalfSpeed_mm_s) * std::sqrt(std::min(force_N_, kStrongestForce_N));
  Vec3 sum{0.0, 0.0, 1.0};
  for (const SurfaceWave& wave : material_.waves) {
    const double frequency = speed / wave.length_mm / kWaveLimit_Hz;
    const double passed = strength / (1.0 + frequency * frequency * frequency * frequency);
    const double angle = 2.0 * std::numbers::pi * std::fmod(travelled_mm_ / wave.length_mm, 1.0);
    sum.x += passed * wave.amplitude_g.x * std::sin(angle + wave.phase_rad.x);
    sum.y += passed * wave.amplitude_g.y * std::sin(angle + wave.phase_rad.y);
    sum.z += passed * wave.amplitude_g.z * std::sin(angle + wave.phase_rad.z);
  }
  const double noise = std::hypot(strength * material_.broadband_g, parameters_.accelerometer_noise_g);
  const double range = parameters_.accelerometer_range_g;
  const double x = sum.x + noise * normal_(random_);
  const double y = sum.y + noise * normal_(random_);
  const double z = sum.z + noise * normal_(random_);
  return clamped({x, y, z}, {range, range, range});
}

}  // namespace fyd::sim
