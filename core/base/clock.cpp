#include "core/base/clock.h"

#include <time.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>

namespace fyd {
namespace {

using Point = Clock::time_point;

constexpr int kMostHolds = 32;
constexpr Clock::duration kShortestSleep = std::chrono::microseconds(100);  // while the clock stands still

struct Holds {
  std::mutex mutex;
  std::array<Point, kMostHolds> until{};  // Point::max(): a thread that has not named a time yet
  std::array<bool, kMostHolds> taken{};
  std::atomic<int> count{0};
  std::atomic<Clock::rep> held_back{0};
};

// Never destroyed: threads may still read the clock while the process ends.
Holds& holds() {
  static auto* const all = new Holds;
  return *all;
}

Clock::duration real() { return std::chrono::steady_clock::now().time_since_epoch(); }

/// With the mutex locked.
Point heldNow(Holds& all) {
  Point latest = Point::max();
  for (std::size_t i = 0; i < all.taken.size(); ++i) {
    if (all.taken[i]) latest = std::min(latest, all.until[i]);
  }
  const Clock::duration held_back(all.held_back.load(std::memory_order_relaxed));
  const Point free(real() - held_back);
  if (free <= latest) return free;
  all.held_back.store((held_back + (free - latest)).count(), std::memory_order_relaxed);
  return latest;
}

}  // namespace

Point Clock::now() {
  Holds& all = holds();
  const rep held_back = all.held_back.load();
  const duration free = real();
  // A hold may have come, and gone, since the first line: what it held back must not be missing here.
  if (all.count.load() == 0 && all.held_back.load() == held_back) return Point(free - duration(held_back));
  const std::lock_guard lock(all.mutex);
  return heldNow(all);
}

void Clock::sleepUntil(Point when) {
  for (Point at = now(); at < when; at = now()) {
    const auto due = std::chrono::steady_clock::now() + std::max(when - at, kShortestSleep);
    const auto ns = due.time_since_epoch().count();
    const timespec wake{.tv_sec = ns / 1'000'000'000, .tv_nsec = ns % 1'000'000'000};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR) {
    }
  }
}

Clock::duration Clock::heldBack() { return duration(holds().held_back.load(std::memory_order_relaxed)); }

ClockHold::ClockHold(bool wanted) : place_(-1) {
  if (!wanted) return;
  Holds& all = holds();
  const std::lock_guard lock(all.mutex);
  const auto free = std::ranges::find(all.taken, false);
  if (free == all.taken.end()) return;  // more threads than any station has
  place_ = static_cast<int>(free - all.taken.begin());
  all.taken[static_cast<std::size_t>(place_)] = true;
  all.until[static_cast<std::size_t>(place_)] = Point::max();
  all.count.fetch_add(1, std::memory_order_release);
}

ClockHold::~ClockHold() {
  if (place_ < 0) return;
  Holds& all = holds();
  const std::lock_guard lock(all.mutex);
  (void)heldNow(all);  // what was held back stays so
  all.taken[static_cast<std::size_t>(place_)] = false;
  all.count.fetch_sub(1, std::memory_order_release);
}

void ClockHold::until(Point when) {
  if (place_ < 0) return;
  Holds& all = holds();
  const std::lock_guard lock(all.mutex);
  all.until[static_cast<std::size_t>(place_)] = std::max(when, heldNow(all));
}

}  // namespace fyd
