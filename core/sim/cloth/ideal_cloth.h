// The ideal cloth's normal force: F = k(θ)·s·δ·(1 + h·q)   ([thesis §4.1.4], its four measured points)
//
//   θ  stretch angle of the motors, °          δ  indentation under the finger, mm
//   k  through (20°, 0.501), (45°, 0.550), (60°, 0.673), (90°, 0.715) N/mm: monotone cubic (PCHIP);
//      outside of the points linear with the nearest segment's chord, to 0° and 120°
//   s  spread between pieces of cloth, 0.7–1.3   h  hysteresis, share of the force
//   q  −1…1, moves with δ, by 1 with each 0.3 mm, and saturates: +1 while pressing, −1 after 0.6 mm of releasing
//      (rate-independent; the loop lies symmetrically about the mean line)
#pragma once

namespace fyd::sim {

inline constexpr double kNominalAngleMinimum_deg = 0.0;
inline constexpr double kNominalAngleMaximum_deg = 120.0;

/// k(θ) of the nominal cloth, N/mm; strictly increasing, θ clamped to 0…120°, NaN reads as 20°.
[[nodiscard]] double nominalStiffness(double angle_deg);

/// θ at which the nominal cloth has the stiffness k; clamped to 0…120°, NaN gives 20°.
[[nodiscard]] double nominalAngle(double stiffness_N_per_mm);

/// Radius of the spot that the camera sees; 0 without force. (Of the ideal cloth.)
[[nodiscard]] double spotRadius_mm(double force_N);

/// One piece of cloth under one finger, with the memory that hysteresis needs.
class IdealCloth {
 public:
  IdealCloth(double stiffness_scale, double hysteresis);

  /// Follows the indentation to a new value. @param indentation_mm ≤ 0 and NaN mean no contact
  /// @return the normal force in N, ≥ 0
  double press(double angle_deg, double indentation_mm);

  /// The same for hysteresis alone. @return its factor on the force, 1 + h·q; without contact 1
  double loop(double indentation_mm);

  /// Without hysteresis, N/mm: the true value that a controller is judged by.
  [[nodiscard]] double stiffness(double angle_deg) const { return scale_ * nominalStiffness(angle_deg); }

 private:
  double scale_;
  double hysteresis_;
  double direction_ = 0.0;  // q
  double last_mm_ = 0.0;
};

}  // namespace fyd::sim
