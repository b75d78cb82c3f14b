// The KRC's time for one command: the shorter of the period that it states (interface state: sample times) and the mean
// period of its own time stamps over 64 measurements (at first over those received). A tick that is assumed too short
// makes the arm slower; one that is too long would make it exceed its limits. So while nothing is known the tick is
// FRI's shortest.
#pragma once

#include <cstdint>
#include <optional>

#include "core/protocol/fri_codec.h"

namespace fyd::device {

inline constexpr double kFriShortestTick_s = 0.001;
inline constexpr double kFriLongestTick_s = 0.1;

class FriTick {
 public:
  /// Each measurement taken, in their order.
  void take(const protocol::FriMeasurement& measurement);
  /// The controller came back, perhaps with another cycle.
  void reset() { *this = FriTick(); }
  /// 0.001…0.1
  [[nodiscard]] double seconds() const;

 private:
  double stated_s_ = 0.0;    // 0: not stated
  double measured_s_ = 0.0;  // 0: not known yet
  bool counting_ = false;
  bool window_complete_ = false;  // there was a whole window; from then on measured_s_ changes with whole ones only
  std::uint16_t first_sequence_ = 0;
  float first_time_s_ = 0.0F;
};

}  // namespace fyd::device
