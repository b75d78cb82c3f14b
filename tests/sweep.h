// Numbers at equal distances, counted: added up instead, rounding would decide whether the last is one of them.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace fyd {

/// From `from` on in steps of `by`, upward or downward, before `end`.
[[nodiscard]] inline std::vector<double> stepsBefore(double from, double end, double by) {
  const long count = std::max(0L, std::lround(std::ceil((end - from) / by - 1e-9)));
  std::vector<double> out;
  out.reserve(static_cast<std::size_t>(count));
  for (long i = 0; i < count; ++i) out.push_back(from + by * static_cast<double>(i));
  return out;
}

/// The same up to `last`, which is one of them where a step ends there.
[[nodiscard]] inline std::vector<double> stepsTo(double from, double last, double by) {
  return stepsBefore(from, last + 0.5e-6 * by, by);
}

}  // namespace fyd
