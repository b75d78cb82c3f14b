// The median of a list of values.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

namespace fyd {

/// What counts where an even number of values has two in the middle.
enum class Middle : std::uint8_t { mean, lower, upper };

/// @param values no NaN among them. @return NaN when there are none
[[nodiscard]] inline double median(std::vector<double> values, Middle middle = Middle::mean) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto upper = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, upper);
  if (values.size() % 2 == 1 || middle == Middle::upper) return *upper;
  const double lower = *std::max_element(values.begin(), upper);
  return middle == Middle::lower ? lower : std::midpoint(lower, *upper);
}

}  // namespace fyd
