// Factor on predicted displacements, 0 … 1, from how well recent predictions came true.
//
// It is the regression coefficient of the true displacement on the predicted one over about the last hundred ticks,
// times 1.2, limited to 0 … 1: on noise, which cannot be predicted, it goes to 0. At the beginning the regression has a
// prior with the weight of five predictions. The prior coefficient depends on the motion's smoothness: the ratio of the
// sums of squared second and first differences of the messages is 0 on a straight line, 2 on a random walk and 3 on
// white noise; from 2 on the prior coefficient is 0. For horizons beyond 220 ms it falls with the square of the
// horizon, because the hand may change its aim.
#pragma once

#include "core/teleop/prediction/predictor.h"

namespace fyd::teleop {

class Trust {
 public:
  /// At each message.
  /// @param first_mm2 squared first difference of the positions, @param second_mm2 squared second difference
  void addDifferences(double first_mm2, double second_mm2);
  /// The displacement predicted for a past tick, from the newest message at that time, and the true one.
  void addOutcome(const Position& predicted_mm, const Position& true_mm);

  /// The factor on a prediction before any error is known; 0 … 1.
  [[nodiscard]] double initialFactor(const Position& predicted_mm) const;
  /// The factor on predictions; 0 … 1.
  /// @param typical_mm2 mean of recent squared displacements over the horizons
  /// @param initial_share remaining weight of the prior: 1 at the beginning, less with each message
  /// @param age_s horizon: age of the newest message
  [[nodiscard]] double factor(double typical_mm2, double initial_share, double age_s) const;

 private:
  /// 1 on a straight line, 0 on a random walk and on noise.
  [[nodiscard]] double smoothness() const;

  double first_mm2_ = 0.0, second_mm2_ = 0.0;       ///< Σ of squared first and second differences
  double predicted_mm2_ = 0.0, product_mm2_ = 0.0;  ///< running Σ|predicted|² and Σ predicted · true
};

}  // namespace fyd::teleop
