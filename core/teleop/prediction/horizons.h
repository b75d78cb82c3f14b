// The prediction horizons in use, in steps Δ of the messages.
//
// Δ is the time between messages; it is set anew when several spacings in a row are shorter or longer. Only the
// horizons in use are computed ("nodes"): the shortest and the longest age of the newest message at the ticks, and one
// between them when they are far apart.
#pragma once

#include <array>
#include <cstddef>

#include "core/teleop/prediction/linear_forecast.h"

namespace fyd::teleop {

class Horizons {
 public:
  static constexpr std::size_t kNodes = LinearForecast::kNodes;
  using Steps = LinearForecast::Steps;
  static constexpr std::size_t kLongest = 1;     ///< the place of the longest, where there are any
  static constexpr double kLeastStep_s = 0.010;  ///< Δ of faster messages: enough to sample a hand's motion
  static constexpr double kLonger = 1.5;         ///< in Δ: in a longer spacing messages were lost

  /// At each message: its time after the one before.
  /// @return whether Δ has changed; the nodes are discarded then
  bool watchSpacing(double spacing_s);
  /// At each tick: the newest message's age.
  /// @return whether it is the first tick: the nodes can be chosen from now on
  bool watchAge(double age_s);
  /// Once per message.
  /// @return the nodes if they have changed, otherwise nullptr
  const Steps* choose();

  /// Δ; 0 before two messages are known.
  [[nodiscard]] double step_s() const { return step_s_; }
  [[nodiscard]] const Steps& steps() const { return steps_; }
  /// Age of the newest message that about 95 % of the ticks do not exceed; 0 before the first tick.
  [[nodiscard]] double mostAge_s() const { return most_age_s_ > 0.0 ? most_age_s_ : 0.0; }

 private:
  double step_s_ = 0.0;
  int shorter_ = 0, longer_ = 0;                   ///< spacings in a row that do not fit Δ
  double least_age_s_ = -1.0, most_age_s_ = -1.0;  ///< of the newest message at the ticks; −1: none yet
  int until_choice_ = 0;
  Steps steps_{};
};

}  // namespace fyd::teleop
