// Time as the step sees it: always passed in. The step never reads a clock.
// Stability: stable since 0.1
#pragma once

#include <chrono>
#include <cmath>

#include "core/base/clock.h"

namespace fyd {

using Instant = Clock::time_point;  ///< ns since an arbitrary origin, monotonic when it comes from Clock
using Duration = Clock::duration;   ///< ns

inline constexpr double kDay_s = 86'400.0;

[[nodiscard]] constexpr double toSeconds(Duration d) { return std::chrono::duration<double>(d).count(); }
[[nodiscard]] constexpr double toMilliseconds(Duration d) {
  return std::chrono::duration<double, std::milli>(d).count();
}

/// @param seconds any double; NaN gives zero, magnitudes above 100 years saturate.
[[nodiscard]] inline Duration fromSeconds(double seconds) {
  constexpr double kCentury_s = 3.2e9;
  if (std::isnan(seconds)) return Duration::zero();
  const double bounded = seconds < -kCentury_s ? -kCentury_s : (seconds > kCentury_s ? kCentury_s : seconds);
  return std::chrono::round<Duration>(std::chrono::duration<double>(bounded));
}

/// An instant counted in seconds from the clock's origin; for tests and simulations that make their own time.
[[nodiscard]] inline Instant instantAt(double seconds) { return Instant(fromSeconds(seconds)); }

}  // namespace fyd
