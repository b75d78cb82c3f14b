#include "core/scene/mesh/edge_kinds.h"

#include "core/scene/mesh/vector.h"

namespace fyd::scene {
namespace {

/// From edges to the vertices at their ends, in every triangle that has them.
void markVertices(const Mesh& mesh, std::vector<std::uint8_t>& bits) {
  const auto triangles = mesh.triangles();
  std::vector<bool> marked(mesh.vertices().size());
  for (std::size_t t = 0; t < bits.size(); ++t) {
    for (std::size_t side = 0; side < 3; ++side) {
      if ((bits[t] >> (3 + side) & 1) != 0) {
        marked[triangles[t][side]] = marked[triangles[t][(side + 1) % 3]] = true;
      }
    }
  }
  for (std::size_t t = 0; t < bits.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (marked[triangles[t][i]]) bits[t] |= static_cast<std::uint8_t>(1U << i);
    }
  }
}

}  // namespace

EdgeKinds::EdgeKinds(const Mesh& mesh) : rims_(mesh.triangles().size()), creases_(mesh.triangles().size()) {
  std::vector<Vec3> normals;
  normals.reserve(rims_.size());
  for (std::uint32_t t = 0; t < rims_.size(); ++t) normals.push_back(mesh.triangleNormal(t));
  for (std::uint32_t t = 0; t < rims_.size(); ++t) {
    for (std::size_t side = 0; side < 3; ++side) {
      const std::uint32_t other = mesh.neighbours(t)[side];
      const auto bit = static_cast<std::uint8_t>(8U << side);
      if (other == kNoTriangle) {
        rims_[t] |= bit;
      } else if (dot(normals[t], normals[other]) < kCreaseCosine) {
        creases_[t] |= bit;
      }
    }
  }
  markVertices(mesh, rims_);
  markVertices(mesh, creases_);
}

}  // namespace fyd::scene
