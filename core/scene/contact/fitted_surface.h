// A smooth surface through the vertices of a mesh: at each vertex a normal and a curvature, fitted to the vertices
// around it; between vertices, both are blended.
//
// Fit: in the frame of the mean normal the heights of the vertices up to two edges away are fitted by a polynomial of
// third order through the vertex (second order or none where there are too few). The fit is made twice, the second time
// in the frame of the first fit's normal. An edge folded by more than 40° is a crease: nothing is fitted across it, and
// a vertex on it has one normal for each side. So a cube keeps its flat faces.
//
// Blend: with φ the signed distance to the surface, at a vertex i φ = 0, ∇φ = n_i, ∇∇φ = −K_i. At a point q of a
// triangle, with barycentric shares b_i and e_i = q − v_i, by Taylor terms made smaller so that the blend gains an
// order [Guessab 2006]:
//   φ(q) = Σ b_i (2/3 n_i·e_i − 1/6 e_i·K_i e_i),   ∇φ(q) = Σ b_i (n_i − 1/2 K_i e_i),   K(q) = Σ b_i K_i
// Both are continuous across edges that are no crease.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/scene/mesh/edge_kinds.h"

namespace fyd::scene {

/// The point of the fitted surface that is nearest to a probe.
struct Foot {
  Vec3 point_mm;
  Vec3 normal;             ///< of unit length, outwards
  double height_mm = 0.0;  ///< of the probe above it; negative within the body
};

class FittedSurface {
 public:
  explicit FittedSurface(const Mesh& mesh);

  /// @param nearest the point of the mesh that is nearest to the probe. The foot is that of the surface's quadratic
  /// there, at most the triangle's size away. At a crease it stays on the crease; the normal then points along the
  /// way to the probe, on the side where it is.
  [[nodiscard]] Foot foot(const Vec3& probe_mm, const Nearest& nearest) const;

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
  [[nodiscard]] const EdgeKinds& edges() const { return edges_; }
  [[nodiscard]] std::size_t bytes() const;
  /// Vertices by what was fitted there: third order, second, none (the mean normal). A vertex on a crease counts for
  /// each of its sides.
  [[nodiscard]] const std::array<std::size_t, 3>& fitted() const { return fitted_; }

 private:
  /// A vertex on one side of its creases.
  struct Corner {
    Vec3 point_mm;
    Vec3 normal;
    std::array<double, 6> curvature{};  // 1/mm: xx xy xz yy yz zz
  };
  struct Fitter;

  [[nodiscard]] Foot creaseFoot(const Vec3& probe_mm, const Nearest& nearest, const Vec3& to_probe,
                                const Vec3& normal) const;

  const Mesh* mesh_;
  std::vector<Corner> corners_;
  std::vector<Triangle> triangles_;  // of corners
  EdgeKinds edges_;
  std::array<std::size_t, 3> fitted_{};
};

}  // namespace fyd::scene
