// Factor on predicted displacements, 0 … 1, from how well recent predictions came true.
//
// It is the regression coefficient of the true displacement on the predicted one over about the last hundred ticks,
// times 1.2, at most 1: on noise, which cannot be predicted, it goes to 0. It is initialised as by five predictions
// that came true to a share that depends on the motion's smoothness. That is the ratio of the sums of squared second
// and first differences of the messages: 0 on a straight line, 2 on a random walk and 3 on white noise; from 2 on the
// share is 0. Beyond 220 ms ahead the initial share falls with the square of the horizon, as the hand's intention may
// change.
#pragma once

#include "core/teleop/prediction/predictor.h"

namespace fyd::teleop {

class Trust {
 public:
  /// At each message.
  /// @param step_mm2 the squared difference to the one before, @param bend_mm2 the second difference's
  void watch(double step_mm2, double bend_mm2);
  /// The displacement that was predicted for a tick, from the newest message at that time, and the true one.
  void settle(const Position& predicted_by_mm, const Position& true_by_mm);

  /// The factor on a prediction before any error is known; 0 … 1.
  [[nodiscard]] double first(const Position& by_mm) const;
  /// The factor on predictions; 0 … 1.
  /// @param usual_mm2 recent squared displacement over the horizons
  /// @param youth 1 at the beginning, less with each message
  [[nodiscard]] double now(double usual_mm2, double youth, double age_s) const;

 private:
  [[nodiscard]] double smoothness() const;

  double steps_mm2_ = 0.0, bends_mm2_ = 0.0;
  double by_mm2_ = 0.0, along_mm2_ = 0.0;  ///< running Σ|predicted|² and Σ predicted · true
};

}  // namespace fyd::teleop
