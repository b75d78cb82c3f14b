// Contact with the vertices of a mesh: a sphere of radius R around the haptic point pushes at the nodes that it meets
// on its way into the body.
//
// For a node at v with the normal n and a probe at p: height h = (v − p)·n along n, distance ℓ at right angles to n,
// ℓ² = |v − p|² − h². Its weight is w = (1 − ℓ²/R²)² (1 − h²/4R²)², and 0 for ℓ > R or |h| > 2R. The force is that of
// the potential ½ k D² with the depth D = 1.05 Σ w max(h, 0) / (Σ w + 0.05 W): W is Σ w on a plane with as many nodes
// per area as the mesh has on average; its 5 % let the force fade where there are few nodes. So on a plane the force is
// k·d on average, no closed path gives work, and deeper than 2R there is no force.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/scene/contact/contact_push.h"

namespace fyd::scene {

class ContactNodes {
 public:
  ContactNodes(const Mesh& mesh, double radius_mm);

  [[nodiscard]] Push push(const Vec3& probe_mm, const Nearest& nearest) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  struct Node {
    Vec3 point_mm, normal;
  };
  [[nodiscard]] std::array<std::int64_t, 3> cellOf(const Vec3& point_mm) const;

  double radius_mm_;
  double regularisation_;  // 0.05 W
  Vec3 lowest_mm_;
  double cell_mm_ = 0.0;
  std::array<std::int64_t, 3> cells_{};
  std::vector<std::uint32_t> begin_;  // of a cell's nodes
  std::vector<Node> nodes_;
};

}  // namespace fyd::scene
