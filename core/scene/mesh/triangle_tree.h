// The triangles of a mesh in a tree of thin discs, four to a node, for the point of the mesh that is nearest to a
// probe. A disc lies along its patch of surface: for a probe within a body, boxes along the axes would nearly all be as
// near as the nearest.
//
// Discs are stored as floats around the mesh's middle, grown so that they contain their triangles in spite of rounding.
// A disc is skipped only where it is farther than the nearest triangle by more than the rounding error; distances to
// triangles are double. So the answer is that of a search over all triangles, to the last bit.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/api.h"
#include "core/scene/mesh/triangle_distance.h"

namespace fyd::scene {

class FYD_API TriangleTree {
 public:
  explicit TriangleTree(const Mesh& mesh);

  /// Of the whole mesh. NaN, or a place kFarthest_mm from the mesh's middle, gives no triangle.
  /// @param hint a triangle that may be near
  [[nodiscard]] Nearest nearest(const Vec3& probe_mm, std::uint32_t hint = kNoTriangle) const;

  /// Calls each(triangle) for every triangle within `distance_mm` of a segment, and for some that are farther away.
  template <class Each>
  void forEachNear(const Vec3& from_mm, const Vec3& to_mm, double distance_mm, Each each) const {
    visitNear(
        from_mm, to_mm, distance_mm, [](void* with, std::uint32_t t) { (*static_cast<Each*>(with))(t); }, &each);
  }

  [[nodiscard]] const Mesh& mesh() const { return *mesh_; }
  /// Radii up to which balls that touch a triangle from its inside and its outside hold nothing of the triangles that
  /// share no vertex with it (nearest_point.h). Lower bounds.
  [[nodiscard]] std::array<double, 2> emptyBalls_mm(std::uint32_t triangle, double largest_mm) const;
  [[nodiscard]] std::size_t bytes() const { return nodes_.size() * sizeof(Node); }

 private:
  static constexpr std::int32_t kNothing = INT32_MIN;

  /// child ≥ 0: a node; < 0: ~triangle; kNothing: none.
  struct alignas(16) Node {
    float middle[3][4];
    float normal[3][4];
    float radius[4];  ///< across the normal
    float height[4];  ///< to either side along it
    std::int32_t child[4];
  };
  struct Box;
  struct Builder;
  struct Search;
  struct OpenList;
  struct EmptyBalls;

  [[nodiscard]] bool begin(const Vec3& probe_mm, std::uint32_t hint, Search& search) const;
  /// Adds a node's children to the open list if they may hold something nearer than the best so far.
  void pushNearChildren(Search& search, std::int32_t from, OpenList& open) const;
  /// Searches the nodes of the open list until none is left.
  void searchOpen(Search& search, OpenList& open) const;
  /// forEachNear, without a template.
  void visitNear(const Vec3& from_mm, const Vec3& to_mm, double distance_mm, void (*visit)(void*, std::uint32_t),
                 void* with) const;

  const Mesh* mesh_;
  Vec3 middle_mm_;
  double size_mm_ = 0.0;  // half of the mesh's largest extent
  std::vector<Node> nodes_;
};

}  // namespace fyd::scene
