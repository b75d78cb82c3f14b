// Mapping between the touchpad's axes and those of a robot's base.
#pragma once

#include <array>
#include <string_view>

#include "core/base/error.h"
#include "core/base/vec3.h"

namespace fyd::device {

/// The touchpad's axes (x right, y back, z up) in the robot's base: entry i is the touchpad axis along which base axis
/// i points, 1…3 for x…z, negative for the opposite direction.
struct AxisMap {
  std::array<int, 3> base_from_touchpad{-2, -1, 3};  ///< X = −y, Y = −x, Z = z as printed by the authors: left-handed

  [[nodiscard]] Vec3 toBase(const Vec3& ours) const;
  [[nodiscard]] Vec3 toTouchpad(const Vec3& base) const;
};
/// Reads "-y,-x,z". @return an error when it is not three different axes
[[nodiscard]] Result<AxisMap> parseAxisMap(std::string_view text);

}  // namespace fyd::device
