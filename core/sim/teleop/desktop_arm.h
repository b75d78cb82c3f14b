// A simulated desktop arm with the figures of the tele-gesture paper's PHANToM: 160 × 130 × 130 mm, 0.02 mm, six
// degrees of freedom of position, three of force, 6.4 N. It moves as a mass with little friction, to which the hand's
// mass is added. The hand alone sets its orientation: the wrist has no motors.
#pragma once

#include "core/base/vec3.h"
#include "core/protocol/link/link_messages.h"
#include "core/protocol/position_code.h"

namespace fyd::sim {

class DesktopArm {
 public:
  static constexpr Vec3 kWorkspace_mm{160.0, 130.0, 130.0};  ///< about the middle
  static constexpr double kPrecision_mm = 0.02;
  static constexpr double kMostForce_N = 6.4;  ///< of each motor
  static constexpr double kMass_kg = 0.045;    ///< felt at the tip (the maker's data)
  static constexpr double kFriction_N_s_per_m = 0.1;

  [[nodiscard]] static protocol::Workspace workspace();

  /// @param more_kg added mass, of a hand
  explicit DesktopArm(double more_kg = 0.0, const Vec3& at_mm = {}) : mass_kg_(kMass_kg + more_kg), at_mm_(at_mm) {}

  /// The motors' force is limited to kMostForce_N; at the ends of the workspace are stops.
  void step(const Vec3& motors_N, const Vec3& outside_N, double dt_s);

  [[nodiscard]] const Vec3& position_mm() const { return at_mm_; }
  [[nodiscard]] const Vec3& velocity_mm_per_s() const { return velocity_mm_per_s_; }
  /// As its encoders have it: in steps of the precision, within the workspace.
  [[nodiscard]] Vec3 measured_mm() const;

 private:
  double mass_kg_;
  Vec3 at_mm_;
  Vec3 velocity_mm_per_s_;
};

}  // namespace fyd::sim
