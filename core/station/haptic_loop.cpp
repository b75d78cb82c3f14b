#include "core/station/haptic_loop.h"

#include <algorithm>
#include <vector>

#include "core/station/real_time.h"

namespace fyd::station {
void StepTimes::add(Duration time) {
  const std::uint64_t count = count_.load(std::memory_order_relaxed);
  const auto ns = std::clamp<std::int64_t>(time.count(), 0, UINT32_MAX);
  times_ns_[count % kCapacity].store(static_cast<std::uint32_t>(ns), std::memory_order_relaxed);
  count_.store(count + 1, std::memory_order_release);
}

StepTimes::Figures StepTimes::figures() const {
  const std::size_t count = std::min<std::uint64_t>(count_.load(std::memory_order_acquire), kCapacity);
  if (count == 0) return {};
  std::vector<std::uint32_t> sorted(count);
  for (std::size_t i = 0; i < count; ++i) sorted[i] = times_ns_[i].load(std::memory_order_relaxed);
  std::sort(sorted.begin(), sorted.end());
  return {.p50_ns = static_cast<double>(sorted[count / 2]), .p99_ns = static_cast<double>(sorted[count * 99 / 100])};
}

void HapticLoop::run(const std::stop_token& stop, bool waits, const Cycle& cycle) {
  // Just less than one period late: the next cycle is then never counted as missed.
  constexpr Duration kLatest = kHapticPeriod - Duration(1);
  real_time_ = askForRealTime(Urgency::haptic);
  if (real_time_) lockMemory();
  ClockHold hold(waits);
  Instant due = Clock::now() + kHapticPeriod;
  while (!stop.stop_requested()) {
    hold.until(due + kLatest);
    Clock::sleepUntil(due);
    const Instant now = Clock::now();
    const auto late_cycles = static_cast<std::uint64_t>((now - due) / kHapticPeriod);
    missed_.fetch_add(late_cycles, std::memory_order_relaxed);
    cycle(now, missed_.load(std::memory_order_relaxed));
    cycles_.fetch_add(1, std::memory_order_relaxed);
    due += kHapticPeriod * static_cast<Duration::rep>(late_cycles + 1);
  }
}

}  // namespace fyd::station
