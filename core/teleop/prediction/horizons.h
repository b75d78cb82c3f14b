// The prediction horizons in use, in steps Δ of the messages.
//
// Δ is the time between messages; it is set anew when several spacings in a row are shorter or longer. Only the
// horizons in use are computed ("nodes"): the shortest and the longest age of the newest message at the ticks, and one
// between them when they are four steps apart or more.
#pragma once

#include <array>
#include <cstddef>

#include "core/teleop/prediction/linear_forecast.h"

namespace fyd::teleop {

class Horizons {
 public:
  static constexpr std::size_t kNodes = LinearForecast::kNodes;
  using Steps = LinearForecast::Steps;
  static constexpr std::size_t kLongestNode = 1;  ///< index of the longest node, if there are any
  static constexpr double kLeastStep_s = 0.010;   ///< lower limit of Δ: samples a hand's motion finely enough
  static constexpr double kLossSpacing = 1.5;     ///< in Δ: a longer spacing means lost messages

  /// At each message: the time since the previous one.
  /// @return whether Δ has changed; the nodes are discarded then
  bool updateSpacing(double spacing_s);
  /// At each tick: the newest message's age.
  /// @return whether it is the first tick: the nodes can be chosen from now on
  bool updateAge(double age_s);
  /// Once per message.
  /// @return the nodes if they have changed, otherwise nullptr
  const Steps* choose();

  /// Δ; 0 before two messages are known.
  [[nodiscard]] double step_s() const { return step_s_; }
  [[nodiscard]] const Steps& steps() const { return steps_; }
  /// 95 % quantile of the newest message's age at the ticks; 0 before the first tick.
  [[nodiscard]] double agePercentile95_s() const { return age_95_s_ > 0.0 ? age_95_s_ : 0.0; }

 private:
  double step_s_ = 0.0;
  int shorter_ = 0, longer_ = 0;                 ///< spacings in a row that are shorter or longer than Δ
  double least_age_s_ = -1.0, age_95_s_ = -1.0;  ///< least and 95 % quantile at the ticks; −1: none yet
  int messages_until_choice_ = 0;
  Steps steps_{};
};

}  // namespace fyd::teleop
