// Contact by a proxy: a sphere that stays outside of the mesh and goes, from step to step, to where it is as near to
// the probe as it can be ([Zilles 1995]; with a radius [Ruspini 1997]). The force on the probe is
// F = k (proxy − probe).
//
// The collision test is continuous: at the first triangle that the moving sphere meets from outside it stops. It then
// slides along that triangle, along the edge of two, or stays in the corner of three. So it passes through no wall,
// however thin, in a step of any length. A triangle does not hold a sphere that comes from behind: a probe that starts
// within a body gets out freely.
//
// Friction: the proxy sticks while the tangential force is less than the static coefficient times the normal force.
// Beyond that it slides until the tangential force is the kinetic coefficient times the normal force.
#pragma once

#include <array>
#include <optional>

#include "core/scene/contact/contact_state.h"
#include "core/scene/contact/surface.h"
#include "core/scene/mesh/triangle_tree.h"

namespace fyd::scene {

class ContactProxy {
 public:
  /// Where the sphere ends, and what holds it.
  struct Place {
    Vec3 middle_mm;
    bool held = false;  ///< a wall keeps it from its goal
    std::uint32_t triangle = kNoTriangle;
  };

  ContactProxy(const TriangleTree& tree, double radius_mm);

  /// @return nothing if nothing is touched; state.proxy_mm is the sphere's middle then as well
  [[nodiscard]] std::optional<Contact> step(const Vec3& probe_mm, const Nearest& nearest, const Surface& surface,
                                            ContactState& state) const;

 private:
  struct NearTriangles;
  struct Walls;
  struct Hit {
    double share = 1.0;  ///< of the way
    std::uint32_t triangle = kNoTriangle;
  };

  /// From a place towards a goal, as near to it as the triangles in the way allow.
  [[nodiscard]] Place moveTowards(const Vec3& from_mm, const Vec3& goal_mm, double radius_mm) const;
  /// Advances along a way that begins far away, to where the mesh can first be met.
  [[nodiscard]] Vec3 advanceToMesh(const Vec3& from_mm, const Vec3& goal_mm) const;
  /// The planes that hold the sphere where it is: one for each triangle that it touches from outside.
  [[nodiscard]] Walls wallsAt(const NearTriangles& near_triangles, const Vec3& middle_mm, double radius_mm) const;
  /// The first triangle that the sphere meets from outside on a straight way.
  [[nodiscard]] Hit sweep(const NearTriangles& near_triangles, const Vec3& from_mm, const Vec3& way_mm,
                          double radius_mm) const;

  const TriangleTree* tree_;
  Vec3 middle_mm_;  // of the mesh
  double radius_mm_;
  double smallest_radius_mm_;  // used for a radius of zero: far larger than the rounding error
  double rounding_mm_;         // bound of the rounding error of a position
  double far_mm_;              // from the mesh's middle: farther away the sphere meets nothing
  double near_margin_mm_;      // triangles within this distance of the sphere are looked up at once
};

}  // namespace fyd::scene
