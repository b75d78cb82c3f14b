// The cloth's normal stiffness: F = k(θ)·s·δ·(1 + h·q)   (thesis §4.1.4, its four measured points)
//
//   θ  stretch angle of the motors, °          δ  indentation under the finger, mm
//   k  through (20°, 0.501), (45°, 0.550), (60°, 0.673), (90°, 0.715) N/mm: monotone cubic (PCHIP);
//      outside the points straight on with the nearest segment's chord, to 0° and 120°
//   s  spread between pieces of cloth, 0.7–1.3   h  hysteresis, share of the force
//   q  −1…1, moved by δ̇ and saturated: +1 after 0.3 mm of pressing, −1 after 0.3 mm of letting go
//      (rate-independent; the loop lies symmetrically about the mean line)
#pragma once

namespace fyd::sim {

inline constexpr double kFabricAngleMinimum_deg = 0.0;
inline constexpr double kFabricAngleMaximum_deg = 120.0;

/// k(θ) of the nominal fabric, N/mm; strictly increasing, θ clamped to 0…120°, NaN reads as 20°.
[[nodiscard]] double fabricStiffness(double angle_deg);

/// θ at which the nominal fabric has the stiffness k; clamped to 0…120°, NaN gives 20°.
[[nodiscard]] double fabricAngle(double stiffness_N_per_mm);

/// Radius of the spot that the camera sees; 0 without force. (Of the ideal cloth.)
[[nodiscard]] double spotRadius_mm(double force_N);

/// One piece of cloth under one finger, with the memory that hysteresis needs.
class Fabric {
 public:
  Fabric(double stiffness_scale, double hysteresis);

  /// Follows the indentation to a new value. @param indentation_mm ≤ 0 and NaN mean no contact
  /// @return the normal force in N, ≥ 0
  double press(double angle_deg, double indentation_mm);

  /// The same for the share of the force that hysteresis adds or takes: 1 + h·q. Without contact 1.
  double loop(double indentation_mm);

  /// Without hysteresis, N/mm: what the controller is judged against.
  [[nodiscard]] double stiffness(double angle_deg) const { return scale_ * fabricStiffness(angle_deg); }

 private:
  double scale_;
  double hysteresis_;
  double direction_ = 0.0;  // q
  double last_mm_ = 0.0;
};

}  // namespace fyd::sim
