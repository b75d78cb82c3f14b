// A correction never jumps: what a motor is told moves on with the prediction, and the difference a new message makes
// is caught up with as a critically damped second-order system would.
//
//   e(t) = output − prediction:   ë + 2ė/τ + e/τ² = 0 between messages, and the output and its velocity are continuous
//
// so at rest and in steady motion nothing lags; after a correction 1 − 2/e = 26 % of it is caught up with after τ, 91 %
// after 4τ.
#pragma once

#include <cstddef>

#include "core/teleop/predictor.h"

namespace fyd::teleop {

/// The time constant for two linked devices, where nobody says another: the rarer the messages, the larger what each of
/// them corrects. 15 ms at periods to 10 ms; from there as much more as the period is longer, up to 55 ms and 0.15 of
/// the delay. Chosen on five recordings and judged on five others (resources/manual/teleop.md).
/// @param delay_s held to 0 … 0.5 s
[[nodiscard]] double usualSmoothing_s(double period_s, double delay_s);

class SmoothOutput {
 public:
  /// @param time_constant_s τ; 0: the prediction itself
  explicit SmoothOutput(double time_constant_s) : tau_s_(time_constant_s) {}

  /// At each tick, in the order of time. What is not finite leaves the output where it was.
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
