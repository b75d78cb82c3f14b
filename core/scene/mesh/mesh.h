// A triangle mesh that can be touched: vertices, triangles, what lies across each edge, and normals.
//
// Millimetres. Outside is the side from which a triangle's vertices turn counter-clockwise. The sign of a distance
// comes from the normal of the nearest feature: a vertex' is the sum of its triangles' normals weighted by their
// angles, an edge's the sum of both (Bærentzen and Aanæs 2005).
// Stability: stable since 0.1
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/base/vec3.h"

namespace fyd::scene {

using Triangle = std::array<std::uint32_t, 3>;

/// Vertices and triangles as a file has them, unchecked.
struct TriangleSoup {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// What was found and mended.
struct MeshReport {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t not_finite = 0;  ///< vertices that are no number, or beyond kFarthest_mm; their triangles were left out
  std::size_t duplicate_vertices = 0;    ///< merged
  std::size_t degenerate_triangles = 0;  ///< without an area, left out
  std::size_t duplicate_triangles = 0;   ///< of the same three vertices, left out
  std::size_t flipped_triangles = 0;     ///< turned to the orientation of most triangles of their piece
  std::size_t non_manifold_edges = 0;    ///< of more than two triangles, which are not neighbours across it
  std::size_t holes = 0;                 ///< closed loops of edges with one triangle
  std::size_t rim_edges = 0;             ///< edges with one triangle
  std::size_t pieces = 0;                ///< not connected by edges of two triangles
  std::size_t inside_out = 0;            ///< closed pieces whose normals point inwards: not mended
  Vec3 lowest_mm, highest_mm;
  double shortest_edge_mm = 0.0, mean_edge_mm = 0.0, longest_edge_mm = 0.0;
  double area_mm2 = 0.0;
  double volume_mm3 = 0.0;  ///< of closed pieces
};

inline constexpr std::size_t kMostTriangles = 20'000'000;
inline constexpr std::uint32_t kNoTriangle = 0xffffffff;

enum class Feature : std::uint8_t { vertex_0, vertex_1, vertex_2, edge_01, edge_12, edge_20, inside };

class FYD_API Mesh {
 public:
  /// Mends what can be mended (MeshReport). @return an error when no triangle is left
  [[nodiscard]] static Result<Mesh> build(TriangleSoup soup);

  [[nodiscard]] std::span<const Vec3> vertices() const { return vertices_; }
  [[nodiscard]] std::span<const Triangle> triangles() const { return triangles_; }
  [[nodiscard]] const MeshReport& report() const { return report_; }
  /// Across the edges 01, 12 and 20; kNoTriangle at a rim and at an edge of more than two triangles.
  [[nodiscard]] const std::array<std::uint32_t, 3>& neighbours(std::uint32_t triangle) const {
    return neighbours_[triangle];
  }
  [[nodiscard]] const Vec3& vertexNormal(std::uint32_t vertex) const { return vertex_normals_[vertex]; }
  /// Of unit length. Outwards.
  [[nodiscard]] Vec3 triangleNormal(std::uint32_t triangle) const;
  /// Normal of a feature: gives the side of a point whose nearest feature it is. Of unit length.
  [[nodiscard]] Vec3 normalOf(std::uint32_t triangle, Feature feature) const;
  [[nodiscard]] std::size_t bytes() const;

 private:
  void findNeighbours();
  void orientConsistently();
  [[nodiscard]] bool closes(std::span<const std::uint32_t> piece) const;
  void measure();

  std::vector<Vec3> vertices_;
  std::vector<Triangle> triangles_;
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
  std::vector<Vec3> vertex_normals_;
  MeshReport report_;
};

}  // namespace fyd::scene
