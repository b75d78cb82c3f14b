// Calls a function at 1 kHz on absolute time, with the highest priority the system grants, and counts steps
// and missed cycles.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <stop_token>

#include "core/base/time.h"

namespace fyd::station {

inline constexpr Duration kHapticPeriod = std::chrono::milliseconds(1);

/// Durations of the last steps, written by the loop, read by any thread; for statistics only.
class StepTimes {
 public:
  static constexpr std::size_t kCapacity = 10'000;
  void add(Duration time);
  struct Figures {
    double p50_ns = 0.0;
    double p99_ns = 0.0;
  };
  [[nodiscard]] Figures figures() const;

 private:
  std::array<std::atomic<std::uint32_t>, kCapacity> times_ns_{};
  std::atomic<std::uint64_t> count_{0};
};

struct LoopStatus {
  std::uint64_t steps = 0;
  std::uint64_t missed_cycles = 0;
  double step_ns_p50 = 0.0;  ///< over the last 10 000 steps
  double step_ns_p99 = 0.0;
  bool real_time = false;  ///< SCHED_FIFO granted
  /// Everything is simulated: the world waits for a late computer, and no cycle is missed.
  bool waits = false;
  double waited_s = 0.0;  ///< since the session began
};

class HapticLoop {
 public:
  /// Called once a period. A cycle that could not start within its period is skipped and counted in `missed_cycles`.
  using Cycle = std::function<void(Instant now, std::uint64_t missed_cycles)>;

  /// Runs on the calling thread until asked to stop.
  /// @param waits the session's clock waits for this thread, so that no cycle is missed
  void run(const std::stop_token& stop, bool waits, const Cycle& cycle);

  [[nodiscard]] std::uint64_t cycles() const { return cycles_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t missedCycles() const { return missed_.load(std::memory_order_relaxed); }
  [[nodiscard]] bool realTime() const { return real_time_.load(std::memory_order_relaxed); }

 private:
  std::atomic<std::uint64_t> cycles_{0};
  std::atomic<std::uint64_t> missed_{0};
  std::atomic<bool> real_time_{false};
};

}  // namespace fyd::station
