// Filters of a gesture before it is sent and after it is received.
//
// Emission: removes tremor of about a tenth of a millimetre and the device's quantisation. The least-squares line over
// the last `window` of samples, evaluated at its newest end (tele-gesture paper: linear regression): noise is divided
// by about √n / 2, motion at constant speed is not delayed, and an acceleration a gives an error of a·window²/12.
//
// Reception: a jitter buffer. Messages are passed on in the order of their dates, each `hold` after its date, so that
// reordering and jitter up to `hold` have no effect; then the speed between them is low-passed. Delay: `hold`, plus one
// time constant while the speed changes.
// Stability: may change
#pragma once

#include <optional>

#include "core/base/api.h"
#include "core/teleop/prediction/motion_history.h"

namespace fyd::teleop {

class FYD_API EmissionFilter {
 public:
  /// @param window_s 0: nothing is filtered
  explicit EmissionFilter(double window_s) : window_s_(window_s) {}

  /// @return the position to send; the previous one if the input is not finite or not newer
  [[nodiscard]] Position step(double time_s, const Position& position_mm);
  void reset() { history_.clear(); }

 private:
  double window_s_;
  MotionHistory history_;
  Position last_mm_{};
};

class FYD_API ReceptionFilter {
 public:
  /// @param hold_s delay after its date at which a message is passed on, 0 and more; on the receiver's clock
  /// @param speed_constant_s of the low-pass on speed; 0: none
  ReceptionFilter(double hold_s, double speed_constant_s) : hold_s_(hold_s), tau_s_(speed_constant_s) {}

  void message(double date_s, const Position& position_mm) { history_.insert(date_s, position_mm); }
  /// At each tick, in the order of time.
  /// @return the hand's position `hold` ago by the messages, low-passed; nothing before the first message
  [[nodiscard]] std::optional<Position> step(double time_s);
  void reset();

 private:
  double hold_s_;
  double tau_s_;
  MotionHistory history_;
  bool begun_ = false;
  double time_s_ = 0.0;
  Position position_mm_{}, target_mm_{}, speed_mm_per_s_{};
};

}  // namespace fyd::teleop
