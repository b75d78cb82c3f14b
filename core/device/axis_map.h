// How the touchpad's axes lie in the base of a robot.
#pragma once

#include <array>
#include <string_view>

#include "core/base/error.h"
#include "core/base/vec3.h"

namespace fyd::device {

/// How the touchpad's axes (x right, y back, z up) lie in the robot's base: entry i says along which of our axes base
/// axis i points, 1…3 for x…z, negative for the opposite way.
struct AxisMap {
  std::array<int, 3> base_from_ours{-2, -1, 3};  ///< the authors' X = −y, Y = −x, Z = z; a mirror, as printed

  [[nodiscard]] Vec3 toBase(const Vec3& ours) const;
  [[nodiscard]] Vec3 toOurs(const Vec3& base) const;
};
/// Reads "-y,-x,z". @return an error when it is not three different axes
[[nodiscard]] Result<AxisMap> parseAxisMap(std::string_view text);

}  // namespace fyd::device
