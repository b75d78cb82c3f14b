// Contact with the vertices of a mesh: each one that the probe has passed and that is within a sphere of radius R
// around it pushes along its normal, as far as the probe has passed it.
//
// F = k Σ h_i n_i / N,  N = (vertices per area of the mesh)·π (R² − d²): as many as the sphere would hold on a plane at
// the depth d of the probe. So on a plane F is k·d in the mean, and the number of touched nodes is felt.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/scene/contact_push.h"

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
  double per_mm2_;  // vertices
  Vec3 lowest_mm_;
  double cell_mm_ = 0.0;
  std::array<std::int64_t, 3> cells_{};
  std::vector<std::uint32_t> begin_;  // of a cell's nodes
  std::vector<Node> nodes_;
};

}  // namespace fyd::scene
