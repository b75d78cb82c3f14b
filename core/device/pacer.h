// Gives pictures from files at their own rate: waits until the next one is due.
#pragma once

#include <cmath>
#include <thread>

#include "core/base/time.h"

namespace fyd::device {

inline constexpr double kUsualRate_Hz = 30.0;

class Pacer {
 public:
  /// Rates that make no sense (0, NaN, beyond 1000 Hz) count as 30 Hz; slower than one a second as one a second.
  explicit Pacer(double rate_Hz) : rate_Hz_(sensible(rate_Hz)) {}

  [[nodiscard]] double rate_Hz() const { return rate_Hz_; }

  /// Sleeps until the next picture is due. Pictures that became due while the caller was busy are not made up for.
  void wait() {
    const Instant now = Clock::now();
    due_ += fromSeconds(1.0 / rate_Hz_);
    if (due_ < now) due_ = now;
    std::this_thread::sleep_until(due_);
  }

 private:
  static double sensible(double rate_Hz) {
    if (!(rate_Hz > 0.0 && rate_Hz <= 1000.0)) return kUsualRate_Hz;
    return rate_Hz < 1.0 ? 1.0 : rate_Hz;
  }

  double rate_Hz_;
  Instant due_{};
};

}  // namespace fyd::device
