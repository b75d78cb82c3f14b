#include "core/protocol/position_code.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace fyd::protocol {
namespace {

// 160 mm / 0.02 mm is 8000 points, also when the numbers came as 32-bit floats.
constexpr double kRoundingSlack = 1e-6;

}  // namespace

std::optional<PositionCode> PositionCode::make(const Workspace& workspace) {
  if (!workspace.minimum_mm.finite() || !workspace.maximum_mm.finite() || !(workspace.precision_mm > 0.0)) return {};
  const Vec3 extent = workspace.maximum_mm - workspace.minimum_mm;
  PositionCode code;
  code.minimum_mm_ = {workspace.minimum_mm.x, workspace.minimum_mm.y, workspace.minimum_mm.z};
  const std::array<double, 3> extents{extent.x, extent.y, extent.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double points = std::ceil(extents[axis] / workspace.precision_mm * (1.0 - kRoundingSlack));
    if (!(extents[axis] > 0.0 && points >= 1.0 && points <= double(1U << kMaximumBitsPerAxis))) return {};
    code.points_[axis] = static_cast<std::uint32_t>(points);
    code.step_mm_[axis] = extents[axis] / points;
    code.cells_per_mm_[axis] = points / extents[axis];
    if (!std::isfinite(code.cells_per_mm_[axis]) || !(code.step_mm_[axis] > 0.0)) return {};
  }
  code.bits_ = std::max(1U, static_cast<unsigned>(std::bit_width(code.pointsOfLongestAxis() - 1)));
  return code;
}

std::uint32_t PositionCode::pointsOfLongestAxis() const { return *std::ranges::max_element(points_); }

std::uint64_t PositionCode::encode(const Vec3& position_mm) const {
  const std::array<double, 3> wanted{position_mm.x, position_mm.y, position_mm.z};
  std::uint64_t code = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double value = std::isfinite(wanted[axis]) ? wanted[axis] : 0.0;
    const double cell = (value - minimum_mm_[axis]) * cells_per_mm_[axis];
    const double held = std::clamp(cell, 0.0, static_cast<double>(points_[axis] - 1));
    code |= static_cast<std::uint64_t>(held) << (axis * bits_);
  }
  return code;
}

std::optional<Vec3> PositionCode::decode(std::uint64_t code) const {
  if ((code >> (3 * bits_)) != 0) return {};
  std::array<double, 3> value{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::uint64_t cell = (code >> (axis * bits_)) & ((std::uint64_t{1} << bits_) - 1);
    if (cell >= points_[axis]) return {};
    value[axis] = minimum_mm_[axis] + (static_cast<double>(cell) + 0.5) * step_mm_[axis];
  }
  return Vec3{value[0], value[1], value[2]};
}

}  // namespace fyd::protocol
