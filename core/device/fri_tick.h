// How long a KRC takes for one command: the shorter of what it states (interface state: sample times) and what its own
// time stamps say, counted over 64 of its measurements (at first over those that there are). A tick taken too short
// makes the arm slower; one taken too long would make it faster than its limits, so nothing known counts as the
// shortest that FRI has.
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
  double stated_s_ = 0.0;    // 0: it does not say
  double measured_s_ = 0.0;  // 0: not known yet
  bool counting_ = false;
  bool window_complete_ = false;  // one was, so that the next figure waits for a whole one
  std::uint16_t first_sequence_ = 0;
  float first_time_s_ = 0.0F;
};

}  // namespace fyd::device
