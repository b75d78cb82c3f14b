#include "core/device/robot/fri_tick.h"

#include <algorithm>
#include <cmath>

namespace fyd::device {
namespace {

constexpr std::uint16_t kWindow = 64;

bool possible(double tick_s) { return tick_s > 0.0 && tick_s <= kFriLongestTick_s; }

}  // namespace

void FriTick::take(const protocol::FriMeasurement& m) {
  stated_s_ = 0.0;
  for (const double stated : {static_cast<double>(m.measurement_period_s), static_cast<double>(m.command_period_s)}) {
    if (possible(stated)) stated_s_ = stated_s_ > 0.0 ? std::min(stated_s_, stated) : stated;
  }
  const auto ticks = static_cast<std::uint16_t>(m.header.sequence - first_sequence_);
  if (counting_ && ticks > 0 && (!window_complete_ || ticks >= kWindow)) {
    // Less the resolution of the float time stamp: after hours it is whole milliseconds.
    const double resolution_s = std::nextafter(m.time_s, HUGE_VALF) - m.time_s;
    const double measured = (static_cast<double>(m.time_s) - static_cast<double>(first_time_s_) - resolution_s) / ticks;
    measured_s_ = possible(measured) ? measured : 0.0;
  }
  if (counting_ && ticks < kWindow) return;
  window_complete_ = counting_;
  counting_ = true;
  first_sequence_ = m.header.sequence;
  first_time_s_ = m.time_s;
}

double FriTick::seconds() const {
  double tick_s = kFriShortestTick_s;
  if (stated_s_ > 0.0 && measured_s_ > 0.0) {
    tick_s = std::min(stated_s_, measured_s_);
  } else if (stated_s_ > 0.0 || measured_s_ > 0.0) {
    tick_s = std::max(stated_s_, measured_s_);
  }
  return std::clamp(tick_s, kFriShortestTick_s, kFriLongestTick_s);
}

}  // namespace fyd::device
