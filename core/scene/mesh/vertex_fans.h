// The triangles around each vertex of a mesh.
// Stability: may change
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene/mesh/mesh.h"

namespace fyd::scene {

class VertexFans {
 public:
  explicit VertexFans(const Mesh& mesh) : first_(mesh.vertices().size() + 1) {
    for (const Triangle& t : mesh.triangles()) {
      for (const std::uint32_t v : t) ++first_[v + 1];
    }
    for (std::size_t v = 1; v < first_.size(); ++v) first_[v] += first_[v - 1];
    triangles_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
      for (const std::uint32_t v : mesh.triangles()[t]) triangles_[next[v]++] = t;
    }
  }

  /// In ascending order.
  [[nodiscard]] std::span<const std::uint32_t> operator[](std::uint32_t vertex) const {
    return std::span(triangles_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }
  [[nodiscard]] std::size_t bytes() const { return sizeof(std::uint32_t) * (first_.size() + triangles_.size()); }

 private:
  std::vector<std::uint32_t> first_;  // of each vertex, in triangles_
  std::vector<std::uint32_t> triangles_;
};

}  // namespace fyd::scene
