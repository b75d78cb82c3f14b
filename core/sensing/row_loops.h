// Inner loops of the adaptive finger detector's pass over one row. The rows never overlap; `__restrict__` says so and
// lets the compiler process 16 pixels at a time.
#pragma once

#include <algorithm>
#include <cstdint>

namespace fyd::sensing {

/// Adds the row to each column's sum, least and most.
inline void gather(const std::uint8_t* __restrict__ grey, int count, std::uint16_t* __restrict__ sums,
                   std::uint8_t* __restrict__ least, std::uint8_t* __restrict__ most) {
  for (int x = 0; x < count; ++x) {
    sums[x] = static_cast<std::uint16_t>(sums[x] + grey[x]);
    least[x] = std::min(least[x], grey[x]);
    most[x] = std::max(most[x], grey[x]);
  }
}

/// 255 where the row is darker than its limits.
/// @return not 0 when a pixel is marked
inline std::uint8_t mark(const std::uint8_t* __restrict__ grey, const std::uint8_t* __restrict__ limits, int count,
                         std::uint8_t* __restrict__ marks) {
  std::uint8_t any = 0;
  for (int x = 0; x < count; ++x) {
    const std::uint8_t dark = grey[x] < limits[x] ? 255 : 0;
    marks[x] = dark;
    any = static_cast<std::uint8_t>(any | dark);
  }
  return any;
}

/// Light, truncated to whole grey values.
inline void toLimits(const float* __restrict__ light, int count, std::uint8_t* __restrict__ limits) {
  for (int x = 0; x < count; ++x) limits[x] = static_cast<std::uint8_t>(static_cast<int>(std::min(light[x], 255.0F)));
}

}  // namespace fyd::sensing
