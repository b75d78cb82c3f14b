// Smooths the jumps of a prediction at new messages: the output follows the prediction, and the error that a jump
// leaves decays as in a critically damped second-order system.
//
//   e(t) = output − prediction:   ë + 2ė/τ + e/τ² = 0 between messages, and the output and its velocity are continuous.
//
// At rest and at constant speed there is no lag. Of a correction 1 − 2/e = 26 % are made after τ, 91 % after 4τ.
#pragma once

#include <cstddef>

#include "core/teleop/prediction/predictor.h"

namespace fyd::teleop {

/// The default time constant for two linked devices. It grows with the period, because rarer messages make larger
/// corrections: 15 ms at periods up to 10 ms; beyond, 15 ms plus the excess of the period over 10 ms, at most 55 ms
/// plus 0.15 of the delay. Tuned on five recordings and evaluated on five others (resources/manual/teleop.md).
/// @param delay_s clamped to 0 … 0.5 s
[[nodiscard]] double defaultSmoothing_s(double period_s, double delay_s);

class SmoothOutput {
 public:
  /// @param time_constant_s τ; 0: the prediction itself
  explicit SmoothOutput(double time_constant_s) : tau_s_(time_constant_s) {}

  /// At each tick, in the order of time. For inputs that are not finite the output is held.
  /// @param velocity_mm_per_s the prediction's own (Predictor::velocity)
  [[nodiscard]] Position step(double time_s, const Position& predicted_mm, const Position& velocity_mm_per_s);
  [[nodiscard]] double timeConstant_s() const { return tau_s_; }
  /// Of the last step.
  [[nodiscard]] const Position& velocity_mm_per_s() const { return velocity_mm_per_s_; }
  /// The next prediction is output unchanged.
  void reset() { begun_ = false; }

 private:
  double tau_s_;
  double time_s_ = 0.0;
  Position position_mm_{};
  Position velocity_mm_per_s_{};
  bool begun_ = false;
};

}  // namespace fyd::teleop
