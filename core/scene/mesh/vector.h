// Products of Vec3, for geometry.
// Stability: may change
#pragma once

#include <cmath>

#include "core/base/vec3.h"

namespace fyd::scene {

/// Largest coordinate of a scene: squares and sums of such values neither overflow nor lose their meaning.
inline constexpr double kFarthest_mm = 1e9;

[[nodiscard]] inline double dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline Vec3 cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline double squared(Vec3 a) { return dot(a, a); }
[[nodiscard]] inline double length(Vec3 a) { return std::sqrt(squared(a)); }
/// Zero stays zero.
[[nodiscard]] inline Vec3 unit(Vec3 a) {
  const double l = length(a);
  return l > 0.0 ? (1.0 / l) * a : Vec3{};
}

}  // namespace fyd::scene
