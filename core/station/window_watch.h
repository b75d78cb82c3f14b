// Whether the window that drives a session still answers.
//
// Watching begins with the first heartbeat: a headless session has no window. Each silence is reported once, the next
// only after another heartbeat.
#pragma once

#include <atomic>

#include "core/base/time.h"

namespace fyd::station {

class WindowWatch {
 public:
  static constexpr Duration kPatience = std::chrono::milliseconds(500);

  /// From the window's thread.
  void alive(Instant now) { alive_.store(now.time_since_epoch().count(), std::memory_order_relaxed); }

  /// From the haptic loop. @return true once in each silence
  [[nodiscard]] bool fellSilent(Instant now) {
    const std::int64_t alive = alive_.load(std::memory_order_relaxed);
    const bool silent = alive != kNever && now - Instant(Duration(alive)) > kPatience;
    const bool fell = silent && !silent_;
    silent_ = silent;
    return fell;
  }

 private:
  static constexpr std::int64_t kNever = 0;
  std::atomic<std::int64_t> alive_{kNever};  // ns of the clock
  bool silent_ = false;                      // the loop's
};

}  // namespace fyd::station
