// How much of what is predicted is to be believed: the share that has come true at the ticks lately.
//
// It is the regression of the true displacement on the predicted one over the last hundred ticks or so, times 1.2, at
// most 1: on noise, where nothing can be known, it goes to 0. At the beginning it is as if five predictions had come
// true, in the share to which the messages are a smooth motion: Σ of their second differences squared by that of the
// first is 0 on a straight line, 2 on a random walk and 3 on white noise, of which nothing is believed; and in that
// further ahead than 220 ms, less, by the square: a hand changes its mind.
#pragma once

#include "core/teleop/predictor.h"

namespace fyd::teleop {

class Trust {
 public:
  /// A message has come.
  /// @param step_mm2 the squared difference to the one before, @param bend_mm2 the second difference's
  void watch(double step_mm2, double bend_mm2);
  /// What was predicted for a tick, from the newest message of then, and what is known now to have come.
  void settle(const Position& predicted_by_mm, const Position& true_by_mm);

  /// The share of a prediction to believe before any error is known; 0 … 1.
  [[nodiscard]] double first(const Position& by_mm) const;
  /// The share of predictions to believe; 0 … 1.
  /// @param usual_mm2 squared displacement over the horizons, of late
  /// @param youth 1 at the beginning, less with each message
  [[nodiscard]] double now(double usual_mm2, double youth, double age_s) const;

 private:
  [[nodiscard]] double smoothness() const;

  double steps_mm2_ = 0.0, bends_mm2_ = 0.0;
  double by_mm2_ = 0.0, along_mm2_ = 0.0;  ///< running Σ|predicted|² and Σ predicted · true
};

}  // namespace fyd::teleop
