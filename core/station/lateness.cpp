#include "core/station/lateness.h"

#include <algorithm>

namespace fyd::station {

bool mayBeLateness(pipeline::Fault fault) {
  using enum pipeline::Fault;
  switch (fault) {
    case step_gap:
    case steps_missed:
    case motors_stale:
    case ir_stale:
    case bridge_stale:
    case camera_stale:
    case robot_lost: return true;
    default: return false;
  }
}

Message describe(const Lateness& lateness) {
  if (!lateness.worthNaming()) return {};
  return say(
      "this computer was late: {:.1f} % of the haptic cycles of that second were missed, longest gap {:.0f} ms; close "
      "other programs",
      lateness.missed_percent, lateness.longest_gap_ms);
}

void LatenessMeter::add(Instant now, std::uint64_t missed_cycles) {
  steps_[count_ % steps_.size()] = {now, missed_cycles};
  ++count_;
}

Lateness LatenessMeter::lastSecond() const {
  if (count_ < 2) return {};
  const Step& newest = steps_[(count_ - 1) % steps_.size()];
  const std::size_t known = std::min(count_, steps_.size());
  Duration longest{};
  std::uint64_t missed_before = newest.missed_cycles;
  std::size_t steps = 0;
  Instant later = newest.when;
  for (std::size_t back = 1; back < known; ++back) {
    const Step& step = steps_[(count_ - 1 - back) % steps_.size()];
    longest = std::max(longest, later - step.when);
    missed_before = step.missed_cycles;
    later = step.when;
    ++steps;
    if (newest.when - step.when >= std::chrono::seconds(1)) break;
  }
  const auto missed = static_cast<double>(newest.missed_cycles - missed_before);
  return {.missed_percent = 100.0 * missed / (missed + static_cast<double>(steps)),
          .longest_gap_ms = toMilliseconds(longest)};
}

}  // namespace fyd::station
