#include "core/device/robot/axis_map.h"

#include <cmath>
#include <cstdlib>
#include <utility>

namespace fyd::device {
namespace {

double component(const Vec3& v, int axis) { return axis == 1 ? v.x : (axis == 2 ? v.y : v.z); }

}  // namespace

Vec3 AxisMap::toBase(const Vec3& ours) const {
  const auto along = [&](int axis) { return std::copysign(1.0, axis) * component(ours, std::abs(axis)); };
  return {along(base_from_touchpad[0]), along(base_from_touchpad[1]), along(base_from_touchpad[2])};
}

Vec3 AxisMap::toTouchpad(const Vec3& base) const {
  std::array<double, 3> ours{};
  for (int i = 0; i < 3; ++i) {
    const int axis = base_from_touchpad[static_cast<std::size_t>(i)];
    ours[static_cast<std::size_t>(std::abs(axis) - 1)] = std::copysign(1.0, axis) * component(base, i + 1);
  }
  return {ours[0], ours[1], ours[2]};
}

Result<AxisMap> parseAxisMap(std::string_view text) {
  const auto wrong = [&] { return fail("axes \"{}\": expected x, y and z once each, such as -y,-x,z", text); };
  AxisMap map;
  std::array<bool, 3> used{};
  std::string_view rest = text;
  for (std::size_t i = 0; i < 3; ++i) {
    const int sign = rest.starts_with('-') ? -1 : 1;
    if (sign < 0) rest.remove_prefix(1);
    if (rest.empty() || rest[0] < 'x' || rest[0] > 'z') return wrong();
    const int axis = rest[0] - 'x';
    if (std::exchange(used[static_cast<std::size_t>(axis)], true)) return wrong();
    map.base_from_touchpad[i] = sign * (axis + 1);
    rest.remove_prefix(1);
    if (i < 2) {
      if (!rest.starts_with(',')) return wrong();
      rest.remove_prefix(1);
    }
  }
  if (!rest.empty()) return wrong();
  return map;
}

}  // namespace fyd::device
