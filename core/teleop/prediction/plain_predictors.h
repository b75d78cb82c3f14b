// The tele-gesture paper's three predictors, as printed: the baselines in comparisons.
//
//   order 0   the newest position
//   order 1   the newest position + slope · its age
//   hybrid    the mean of both
//
// The slope is that of the least-squares line through the messages dated within max(10 ms, one period) before the
// newest; with one message it is 0. For an unknown period the time between the two newest messages is taken.
#pragma once

#include "core/teleop/prediction/motion_history.h"

namespace fyd::teleop {

class PlainPredictor final : public Predictor {
 public:
  static constexpr double kSlopeWindow_s = 0.010;

  /// @param slope_factor 0: order 0, 1: order 1, ½: hybrid
  /// @param period_s of the sender's messages; 0: not known
  PlainPredictor(double slope_factor, double period_s) : slope_factor_(slope_factor), period_s_(period_s) {}

  void message(double date_s, const Position& position_mm) override;
  [[nodiscard]] Position predict(double time_s) override;
  [[nodiscard]] Position velocity(double time_s) const override;
  void endMotion() override;

 private:
  double slope_factor_;
  double period_s_;
  MotionHistory history_;
  Position slope_mm_per_s_{};
};

/// The time between the dates of the two newest messages, s; 0 with fewer.
[[nodiscard]] double newestSpacing(const MotionHistory& history);
/// The least-squares slope over the messages no older than the window, in mm/s; zeros with fewer than two.
[[nodiscard]] Position newestSlope(const MotionHistory& history, double window_s);

}  // namespace fyd::teleop
