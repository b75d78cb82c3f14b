// Events per second over the last full second; one writer, any reader.
#pragma once

#include <atomic>

#include "core/base/time.h"

namespace fyd {

class RateMeter {
 public:
  void count(Instant now) {
    ++in_window_;
    const double elapsed_s = toSeconds(now - window_start_);
    if (elapsed_s < 1.0) return;
    rate_hz_.store(elapsed_s < 2.0 ? static_cast<double>(in_window_) / elapsed_s : 0.0, std::memory_order_relaxed);
    window_start_ = now;
    in_window_ = 0;
  }
  [[nodiscard]] double rate_hz() const { return rate_hz_.load(std::memory_order_relaxed); }

 private:
  Instant window_start_{};
  int in_window_ = 0;
  std::atomic<double> rate_hz_{0.0};
};

}  // namespace fyd
