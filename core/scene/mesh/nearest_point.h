// The point of a mesh that is nearest to a probe which moves little from step to step: a walk over the mesh from the
// last nearest point, and a certificate that the walk's answer is the nearest of the whole mesh. Without a certificate
// the tree is searched.
//
// Certificate. Let f be the nearest point on triangle T, n the unit way from f to the probe, d the distance. Another
// point q of the mesh is nearer exactly when it lies in the ball around the probe that touches T in f:
// |q − f|² < 2 d n·(q − f). Within T, n is T's normal. So for each triangle and each of its sides the smallest
// |q − f|² / (2 n·(q − f)) over all f in T and all q in triangles without a vertex of T is found once: the radius up to
// which a ball that touches T from that side holds none of them. For triangles that share a vertex with T the distance
// from their edge or corner, over the radius, is stored beyond which a ball that touches T holds none of them; where
// the ball touches nearer, these triangles are checked. A foot on an edge belongs to both triangles, and n is between
// their normals: both must certify a ball that is larger by the cosine of half their angle. For a foot on a corner the
// tree is searched.
//
// The answer is that of TriangleTree::nearest, whatever the history, but for what rounding makes of needles: a foot on a
// triangle of the length L and the height h is known to 24·ε·L²/h (nearestOf decides by differences of products, whose
// two terms each carry up to eleven roundings of L⁴). `reset` costs time only.
// Stability: may change
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "core/base/api.h"
#include "core/scene/mesh/triangle_distance.h"
#include "core/scene/mesh/triangle_tree.h"
#include "core/scene/mesh/vertex_fans.h"

namespace fyd::scene {

/// What is known of a mesh for walks over it. Immutable; shared by any number of probes and threads.
class FYD_API WalkableMesh {
 public:
  /// Built by as many threads as the machine runs at a time; the same whatever their number. The tree, and with it the
  /// mesh, must outlive this. Certificates reach ten mean edges, as the time to build them grows with the triangles
  /// within a ball; farther away the tree is searched at each step.
  explicit WalkableMesh(const TriangleTree& tree);

  [[nodiscard]] const TriangleTree& tree() const { return *tree_; }
  [[nodiscard]] const Mesh& mesh() const { return tree_->mesh(); }
  [[nodiscard]] const VertexFans& fans() const { return fans_; }

  /// The certificate of one side of a triangle, in few bytes: on a large mesh memory access takes most of a
  /// step. Lengths are in mean edges.
  struct Side {
    /// A number in logarithmic steps of 2^(1/8), rounded to the safe side (dequantised).
    using Quantised = std::uint8_t;
    Quantised empty = 0;  ///< a ball of this radius that touches it holds nothing of those that share no vertex with it
    // A ball of radius r that touches the triangle in f holds nothing of …
    std::array<Quantised, 3> edge{};  ///< … what lies across the edge 01, 12, 20, if f is this · r away from the edge
    std::array<Quantised, 3> strip{};  ///< … the others at its ends, likewise; or
    std::array<Quantised, 3> disc{};   ///< … those at the corner 0, 1, 2, if f is this · r away from the corner.
    // Distances from an edge are shares of the triangle's height over that edge; those from a corner, of the height of
    // that corner over the opposite edge. Infinite: nothing is known.
  };
  [[nodiscard]] const Side& side(std::uint32_t triangle, bool outside) const {
    return sides_[outside ? 1 : 0][triangle];
  }
  /// 0, 2^(n/8), or infinite.
  [[nodiscard]] static double dequantised(Side::Quantised level) { return kLevels[level]; }
  [[nodiscard]] double emptyBall_mm(std::uint32_t triangle, bool outside) const {
    return dequantised(side(triangle, outside).empty) * mesh().report().mean_edge_mm;
  }

  /// Vertices and neighbours (Mesh) of a triangle, side by side.
  struct Link {
    Triangle corner;
    std::array<std::uint32_t, 3> across;
  };
  [[nodiscard]] const Link& link(std::uint32_t triangle) const { return links_[triangle]; }
  [[nodiscard]] std::size_t bytes() const;

 private:
  static const std::array<float, 256> kLevels;

  const TriangleTree* tree_;
  VertexFans fans_;
  std::vector<Link> links_;
  std::array<std::vector<Side>, 2> sides_;  // inside, outside

  void certify(std::uint32_t triangle);
  void checkVertexNeighbours(std::uint32_t triangle);
};

class FYD_API NearestPoint {
 public:
  explicit NearestPoint(const WalkableMesh& on) : on_(&on) {}

  /// NaN gives no triangle.
  [[nodiscard]] Nearest find(const Vec3& probe_mm);
  void reset() { last_ = kNoTriangle; }

  template <class Archive>
  void serialize(Archive& archive) {
    archive(last_);
    if (last_ != kNoTriangle && last_ >= on_->mesh().triangles().size()) throw std::out_of_range("no such triangle");
  }

 private:
  /// Vertices whose triangles have all been checked.
  struct CheckedVertices;

  [[nodiscard]] Nearest ofTriangle(const Vec3& probe_mm, std::uint32_t triangle) const;
  /// From the last triangle to one over or under which the probe is, or as near to that as the walk gets.
  [[nodiscard]] std::uint32_t walk(const Vec3& probe_mm) const;
  /// Takes the nearest of the triangles at a vertex, if it is nearer than `best`. @return whether one was
  bool improve(const Vec3& probe_mm, std::uint32_t vertex, CheckedVertices& checked, Nearest& best) const;
  /// The same for the triangles around a triangle that its certificate for this distance does not cover.
  bool improveAround(const Vec3& probe_mm, std::uint32_t triangle, const std::array<double, 3>& share,
                     const WalkableMesh::Side& side, double radius, std::size_t on_edge, CheckedVertices& checked,
                     Nearest& best) const;
  /// Moves `best` to nearer triangles around it until none is nearer. @return whether a certificate then proves that it
  /// is the nearest of the whole mesh
  [[nodiscard]] bool improveUntilCertain(const Vec3& probe_mm, Nearest& best) const;

  const WalkableMesh* on_;
  std::uint32_t last_ = kNoTriangle;
};

}  // namespace fyd::scene
