// A robot arm that presses a tool on a material, in virtual time (steps of at most 1 ms, at most 100 ms a call).
//
// Reference: the target, clamped to the workspace x ±35, y ±25, z ±70 mm [authors' program], followed as a
//   critically damped second order of 60 rad/s (lag 33 ms), within 10 m/s² and the speed limit.
// Contact: the material's surface lies 2 mm below the start. With c the reference's depth below it,
//   K the arm's Cartesian impedance, k and b the material's stiffness and damping, p the tool's depth in it:
//   K·(c − p) = k·p + b·ṗ,  F = max(0, K·(c − p));  at rest F = c·K·k/(K + k).
// Accelerometer: gravity (+1 g on z at rest), the surface (material.h), sensor noise; clipped at its range.
#pragma once

#include <random>

#include "core/device/robot/robot.h"
#include "core/sim/material.h"
#include "core/sim/sim_parameters.h"

namespace fyd::sim {

inline constexpr Vec3 kRobotWorkspace_mm{35.0, 25.0, 70.0};  ///< ± from the start
inline constexpr double kBandwidth_rad_s = 60.0;
inline constexpr double kMaterialSurface_mm = -2.0;  ///< z of the untouched surface

class RobotArm final : public device::Robot {
 public:
  explicit RobotArm(const SimParameters& parameters);

  [[nodiscard]] Message description() const override;
  [[nodiscard]] bool inVirtualTime() const override { return true; }
  /// At constant velocity: twice the time constant of the second-order reference.
  [[nodiscard]] double lag_s() const override { return 2.0 / kBandwidth_rad_s; }

  /// A target beyond the workspace is followed to its edge; if `now` did not increase, nothing moves.
  /// @return an error when the target is not finite; the arm then keeps its last target
  [[nodiscard]] Result<device::RobotReadings> exchange(const Vec3& target_mm, Instant now) override;

  /// Stiffness of the material under the tool, N/mm; 0 when there is none. For error figures.
  [[nodiscard]] double trueStiffness_N_per_mm() const { return stiffness_; }

 private:
  void step(double dt_s);
  void moveReference(double dt_s);
  void pressMaterial(double dt_s);
  [[nodiscard]] Vec3 senseAcceleration();

  SimParameters parameters_;
  MaterialProperties material_;
  double stiffness_ = 0.0;
  Vec3 target_mm_;
  Vec3 reference_mm_;
  Vec3 velocity_mm_s_;
  double depth_mm_ = 0.0;
  double force_N_ = 0.0;
  double travelled_mm_ = 0.0;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  Instant last_{};
  bool started_ = false;
};

}  // namespace fyd::sim
