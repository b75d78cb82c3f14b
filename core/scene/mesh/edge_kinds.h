// Which edges and vertices of a mesh are a rim (boundary: an edge with one triangle) or a crease (folded by more than
// 40°).
#pragma once

#include <vector>

#include "core/scene/mesh/triangle_distance.h"

namespace fyd::scene {

class EdgeKinds {
 public:
  /// cos 40°
  static constexpr double kCreaseCosine = 0.766044443118978;

  explicit EdgeKinds(const Mesh& mesh);

  /// Whether the nearest feature is a rim or a crease; the inside of a triangle is neither.
  [[nodiscard]] bool rim(const Nearest& nearest) const { return of(rims_, nearest); }
  [[nodiscard]] bool crease(const Nearest& nearest) const { return of(creases_, nearest); }
  /// @param side 0: edge 01, 1: 12, 2: 20
  [[nodiscard]] bool creaseEdge(std::uint32_t triangle, std::size_t side) const {
    return (creases_[triangle] >> (3 + side) & 1) != 0;
  }
  [[nodiscard]] std::size_t bytes() const { return rims_.size() + creases_.size(); }

 private:
  using Bits = std::vector<std::uint8_t>;  // for each triangle, a bit for each Feature

  [[nodiscard]] static bool of(const Bits& bits, const Nearest& nearest) {
    if (nearest.feature == Feature::inside) return false;
    return (bits[nearest.triangle] >> static_cast<std::size_t>(nearest.feature) & 1) != 0;
  }

  Bits rims_, creases_;
};

}  // namespace fyd::scene
