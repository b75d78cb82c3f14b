// Positions coded to a workspace and a precision [tele-gesture Eq. 1]:
//   points per axis = extent / precision, rounded up;   bits per axis = ⌈log₂ points⌉ of the longest axis.
//
// The extent is cut into that many cells of equal length, step = extent / points ≤ precision (within a millionth); the
// code is the cell's number and stands for its centre, so the error is at most half a step anywhere within the
// workspace, its borders included. 160 mm at 0.02 mm: 8000 points, 13 bits. Outside, the position is held at the
// border.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/base/vec3.h"

namespace fyd::protocol {

struct Workspace {
  Vec3 minimum_mm;
  Vec3 maximum_mm;
  double precision_mm = 0.02;

  friend bool operator==(const Workspace&, const Workspace&) = default;
};

inline constexpr unsigned kMaximumBitsPerAxis = 20;  ///< three axes and a flag fit 64 bits

class PositionCode {
 public:
  PositionCode() = default;  ///< codes nothing; to be assigned

  /// @return nothing when a corner is not finite, an extent not positive, the precision not positive, or an axis
  /// would need more than kMaximumBitsPerAxis
  [[nodiscard]] static std::optional<PositionCode> make(const Workspace& workspace);

  /// x in the lowest bits, then y, then z. A component that is not finite is coded as the one nearest to 0.
  [[nodiscard]] std::uint64_t encode(const Vec3& position_mm) const;
  /// @return nothing for a code no position has
  [[nodiscard]] std::optional<Vec3> decode(std::uint64_t code) const;

  [[nodiscard]] unsigned bitsPerAxis() const { return bits_; }
  [[nodiscard]] const std::array<std::uint32_t, 3>& points() const { return points_; }
  [[nodiscard]] std::uint32_t pointsOfLongestAxis() const;
  [[nodiscard]] const std::array<double, 3>& step_mm() const { return step_mm_; }

 private:
  std::array<double, 3> minimum_mm_{};
  std::array<double, 3> step_mm_{};
  std::array<double, 3> cells_per_mm_{};
  std::array<std::uint32_t, 3> points_{};
  unsigned bits_ = 0;
};

}  // namespace fyd::protocol
