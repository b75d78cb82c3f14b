// How far ahead a predictor is asked to look, in steps Δ of the messages.
//
// Δ is the time between messages; another one begins when several in a row are shorter or longer. Of the horizons only
// those in use are worked on ("nodes"): the shortest and the longest age of the newest message at the ticks, and one
// between them when they are far apart.
#pragma once

#include <array>
#include <cstddef>

#include "core/teleop/linear_forecast.h"

namespace fyd::teleop {

class Horizons {
 public:
  static constexpr std::size_t kNodes = LinearForecast::kNodes;
  using Steps = LinearForecast::Steps;
  static constexpr std::size_t kLongest = 1;     ///< the place of the longest, where there are any
  static constexpr double kLeastStep_s = 0.010;  ///< Δ of faster messages: a hand moves no faster than this shows
  static constexpr double kLonger = 1.5;         ///< spacings beyond this, in Δ, have lost messages between them

  /// The newest message came this long after the one before.
  /// @return whether another Δ begins; the nodes are forgotten then
  bool watchSpacing(double spacing_s);
  /// A tick, at which the newest message is this old.
  /// @return whether it is the first: the nodes can be chosen from now on
  bool watchAge(double age_s);
  /// Once a message.
  /// @return the nodes when they are others from now on, otherwise nullptr
  const Steps* choose();

  /// Δ; 0 before two messages are known.
  [[nodiscard]] double step_s() const { return step_s_; }
  [[nodiscard]] const Steps& steps() const { return steps_; }
  /// At nearly all ticks the newest message is younger; 0 before the first tick.
  [[nodiscard]] double mostAge_s() const { return most_age_s_ > 0.0 ? most_age_s_ : 0.0; }

 private:
  double step_s_ = 0.0;
  int shorter_ = 0, longer_ = 0;                   ///< spacings in a row that do not fit Δ
  double least_age_s_ = -1.0, most_age_s_ = -1.0;  ///< of the newest message at the ticks; −1: none yet
  int until_choice_ = 0;
  Steps steps_{};
};

}  // namespace fyd::teleop
