// The clock of every session: monotonic, that of the operating system. A session in which everything is simulated may
// hold it back: it then never runs ahead of a thread that is late, so that the simulated world waits for a slow
// computer, as a paused simulation does. It is one for the process, because devices, robot and step must agree on it.
// Stability: may change
#pragma once

#include <chrono>

#include "core/base/api.h"

namespace fyd {

struct FYD_API Clock {
  using duration = std::chrono::nanoseconds;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<Clock>;
  static constexpr bool is_steady = false;  ///< monotonic, but slower than real time while it is held back

  /// ns since an arbitrary origin; from any thread, never earlier than a time it has returned before.
  [[nodiscard]] static time_point now();
  /// Sleeps until then, as precisely as the system allows, longer while the clock is held back.
  static void sleepUntil(time_point when);
  /// How long it has been held back since the process began.
  [[nodiscard]] static duration heldBack();
};

/// One thread's part in holding the clock back: while it exists, the clock does not pass the time that the thread
/// named last. A thread names a new one before it waits, later than the time at which it will wake.
class FYD_API ClockHold {
 public:
  /// @param holds false: does nothing
  explicit ClockHold(bool holds);
  ClockHold(const ClockHold&) = delete;
  ClockHold& operator=(const ClockHold&) = delete;
  ~ClockHold();

  /// @param when at the latest; a time in the past counts as the present
  void until(Clock::time_point when);

 private:
  int place_;  // in the table of holds; -1: none
};

}  // namespace fyd
