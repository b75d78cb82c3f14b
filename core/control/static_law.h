// The static stiffness law: which stretch angle gives which stiffness, and back.
//
//   interpolated   k(θ): monotone cubic through the calibration points ([Fritsch 1984]: the tangents are
//                  weighted harmonic means of the neighbouring slopes); it never overshoots between the points, and
//                  ends at the first and the last
//   thesis         θ = 314.5 k² − 107 k − 0.3552 [thesis §4.1.4], on the 0.3…0.9 N/mm the thesis states.
//                  Caution: −4.2° at 0.3, 158° at 0.9, and up to 10° off the four points it was fitted to
//   thesis-linear  θ = 204.6 k − 23.6 (the authors' later code): another cloth, 33…59° above the four points
//
// No allocation anywhere; the cubic's inverse is found by bisection, to better than 1e−12°.
// Stability: may change
#pragma once

#include <array>
#include <cstddef>

#include "core/base/api.h"
#include "core/base/parameter.h"
#include "core/control/control_parameters.h"

namespace fyd::control {

/// A value of the law, or the nearest the law can give.
struct LawValue {
  double value = 0.0;
  bool clamped = false;  ///< what was asked lies outside the domain (or is NaN: then the domain's lower end)
};

class FYD_API StaticLaw {
 public:
  /// The four measured points of the thesis.
  StaticLaw();
  explicit StaticLaw(const ControlParameters& parameters);

  /// @return false, and nothing changed, when `checkControlParameters` would refuse the points
  bool configure(StaticLawKind kind, const ParameterList& angle_deg, const ParameterList& stiffness_N_per_mm);

  /// Narrows the domain to these angles (motor travel), as far as the law reaches. Where it does not reach at all, the
  /// domain is one point: the travel's end that is nearest to the law, with the stiffness of the law's nearest end.
  void limitTravel(double minimum_deg, double maximum_deg);

  [[nodiscard]] LawValue angle_deg(double stiffness_N_per_mm) const;
  [[nodiscard]] LawValue stiffness_N_per_mm(double angle_deg) const;
  /// dk/dθ, N/mm per degree, ≥ 0; the end's own slope outside the domain.
  [[nodiscard]] double slope_N_per_mm_deg(double angle_deg) const;

  [[nodiscard]] double minimumStiffness_N_per_mm() const { return minimum_k_; }
  [[nodiscard]] double maximumStiffness_N_per_mm() const { return maximum_k_; }
  [[nodiscard]] double minimumAngle_deg() const { return minimum_deg_; }
  [[nodiscard]] double maximumAngle_deg() const { return maximum_deg_; }

 private:
  [[nodiscard]] double angleAt(double stiffness_N_per_mm) const;  // inside the law's own domain
  [[nodiscard]] double stiffnessAt(double angle_deg) const;       // inside the law's own domain
  [[nodiscard]] double cubic(std::size_t segment, double angle_deg) const;
  [[nodiscard]] std::size_t segmentOf(const std::array<double, kParameterListCapacity>& knots, double x) const;
  void takeWholeDomain();

  StaticLawKind kind_ = StaticLawKind::interpolated;
  std::size_t count_ = 0;
  std::array<double, kParameterListCapacity> theta_{};
  std::array<double, kParameterListCapacity> k_{};
  std::array<double, kParameterListCapacity> tangent_{};  // dk/dθ at the points
  double minimum_k_ = 0.0, maximum_k_ = 0.0;              // domain after limitTravel
  double minimum_deg_ = 0.0, maximum_deg_ = 0.0;
  double whole_minimum_deg_ = 0.0, whole_maximum_deg_ = 0.0;  // domain of the law itself
};

}  // namespace fyd::control
