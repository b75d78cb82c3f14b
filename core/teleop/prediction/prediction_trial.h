// A trial of a predictor: a recorded motion is sent over a simulated network and predicted at the receiver.
//
// Message n is the newest row at or before n·period after the first row, with that row's own date, position and date
// only; it arrives delay + U(0, jitter) after n·period, and may overtake another. Without a period each row is a
// message, dated and sent at its own time. Ticks are the trace's rows, from the first arrival on. Rows of NaN are a
// gap, which ends a motion: it has no messages and no ticks, and messages still in transit are dropped. Ticks begin
// again with the first arrival of the next motion.
// Stability: may change
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/base/time.h"
#include "core/teleop/prediction/predictor.h"

namespace fyd::teleop {

struct FYD_API Trace {
  std::size_t axes = 0;
  std::vector<double> time_s;  ///< strictly rising
  std::vector<Position> position_mm;

  [[nodiscard]] bool gap(std::size_t row) const;
  /// Rows per second, from the median distance of two rows.
  [[nodiscard]] double rate_Hz() const;
};

/// What is computed of a trace grows with its time.
inline constexpr double kLongestTrace_s = kDay_s;

/// @return an error naming the row when the times do not rise or are not finite, or a position is further away than
///         MotionHistory::kLargestCoordinate_mm; or when there are fewer than two rows, no row but gaps, not as many
///         positions as times, or not 1 to kMostAxes axes; or when they last longer than kLongestTrace_s
[[nodiscard]] FYD_API Result<void> checkTrace(const Trace& trace);
/// @return an error when it lasts longer than this
[[nodiscard]] FYD_API Result<void> checkLength(const Trace& trace, double most_s);

struct TrialNetwork {
  double period_ms = 10.0;
  double delay_ms = 50.0;
  double jitter_ms = 0.0;
  double loss_percent = 0.0;
  std::uint64_t seed = 1;
};

/// @return an error naming the value and its range
[[nodiscard]] FYD_API Result<void> checkNetwork(const TrialNetwork& network);
/// More than this, and more than the trace has rows, are refused: each message is kept in memory.
inline constexpr std::size_t kMostMessages = 10'000'000;
/// @pre checkTrace and checkNetwork find nothing
/// @return an error when the trace takes more messages of this period than that
[[nodiscard]] FYD_API Result<void> checkMessages(const Trace& trace, const TrialNetwork& network);

struct TrialMessage {
  std::size_t row = 0;
  double arrival_s = 0.0;
};

/// What happens at each tick, in the order of time.
struct TrialPlan {
  struct Tick {
    std::size_t row = 0;
    std::size_t first = 0, last = 0;  ///< messages [first, last) arrive since the tick before
    bool begins = false;              ///< first tick of a motion
  };
  std::vector<TrialMessage> messages;  ///< in the order of arrival; without those after their motion's end
  std::vector<Tick> ticks;
};

/// @pre checkTrace, checkNetwork and checkMessages find nothing
[[nodiscard]] FYD_API TrialPlan planTrial(const Trace& trace, const TrialNetwork& network);

/// The predictor's output at each tick.
/// @pre the plan is this trace's
/// @param smooth_s the time constant of SmoothOutput; 0: none
[[nodiscard]] FYD_API std::vector<Position> runTrial(const Trace& trace, const TrialPlan& plan, Predictor& predictor,
                                                     double smooth_s);

/// All NaN where there is no tick: no message arrived.
struct TrialFigures {
  std::size_t ticks = 0;
  double rms_mm = 0.0;
  double mean_mm = 0.0;
  double max_mm = 0.0;
  double vibration_ratio = 0.0;  ///< 20–200 Hz RMS of the output's velocity over the true motion's; NaN below
                                 ///< 1 kHz, and when that one is 0
  double largest_step_mm = 0.0;  ///< of the output, between two ticks of one motion
  double jerk_ratio = 0.0;       ///< RMS of the third difference over the true motion's; NaN when that one is 0
};

/// @pre the plan is this trace's, and the output has a position for each of its ticks, as of runTrial
[[nodiscard]] FYD_API TrialFigures trialFigures(const Trace& trace, const TrialPlan& plan,
                                                std::span<const Position> output);

}  // namespace fyd::teleop
