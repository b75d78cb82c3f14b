// Smooths the jumps of a prediction at new messages: the output moves on with the prediction, and the difference that a
// new message makes decays as in a critically damped second-order system.
//
//   e(t) = output − prediction:   ë + 2ė/τ + e/τ² = 0 between messages, and the output and its velocity are continuous
//
// so at rest and at constant speed there is no lag; of a correction 1 − 2/e = 26 % are made after τ, 91 % after 4τ.
#pragma once

#include <cstddef>

#include "core/teleop/prediction/predictor.h"

namespace fyd::teleop {

/// The default time constant for two linked devices; it grows with the period, as rarer messages make larger
/// corrections. 15 ms at periods up to 10 ms; beyond, 15 ms plus the excess of the period, at most 55 ms plus 0.15 of
/// the delay. Chosen on five recordings and judged on five others (resources/manual/teleop.md).
/// @param delay_s held to 0 … 0.5 s
[[nodiscard]] double usualSmoothing_s(double period_s, double delay_s);

class SmoothOutput {
 public:
  /// @param time_constant_s τ; 0: the prediction itself
  explicit SmoothOutput(double time_constant_s) : tau_s_(time_constant_s) {}

  /// At each tick, in the order of time. For inputs that are not finite the output stays where it was.
  /// @param velocity_mm_per_s the prediction's own (Predictor::velocity)
  [[nodiscard]] Position step(double time_s, const Position& predicted_mm, const Position& velocity_mm_per_s);
  /// Of the last step.
  [[nodiscard]] const Position& velocity_mm_per_s() const { return velocity_mm_per_s_; }
  /// The next prediction is taken as it is.
  void reset() { begun_ = false; }

 private:
  double tau_s_;
  double time_s_ = 0.0;
  Position position_mm_{};
  Position velocity_mm_per_s_{};
  bool begun_ = false;
};

}  // namespace fyd::teleop
