// Contact by a proxy: a sphere that stays outside of the mesh and goes, from step to step, to where it is as near to
// the probe as it can be (Zilles and Salisbury 1995; with a radius, Ruspini 1997). The probe pulls at it with F = k
// (proxy − probe).
//
// Its way is swept: at the first triangle that its sphere meets from outside it stops and goes on along it, along the
// edge of two, or not at all in the corner of three. So no wall is too thin and no step too long. A triangle does not
// hold what comes from behind: a probe that starts within a body gets out freely.
//
// Friction: the proxy stays while the force along the surface is less than static friction times the normal force, else
// follows so far that it is kinetic friction times that, until it is less again.
#pragma once

#include <array>
#include <optional>

#include "core/scene/contact.h"

namespace fyd::scene {

class ContactProxy {
 public:
  /// Where the sphere ends, and what holds it.
  struct Place {
    Vec3 middle_mm;
    bool held = false;  ///< it is not where it should go
    std::uint32_t triangle = kNoTriangle;
  };

  ContactProxy(const TriangleTree& tree, double radius_mm);

  /// @return nothing if nothing is touched; state.proxy_mm is the sphere's middle then as well
  [[nodiscard]] std::optional<Contact> step(const Vec3& probe_mm, const Nearest& nearest, const Surface& surface,
                                            ContactState& state) const;

 private:
  struct Around;
  struct Walls;
  struct Hit {
    double share = 1.0;
    std::uint32_t triangle = kNoTriangle;
  };

  /// From a place towards a goal, as near to it as walls let it.
  [[nodiscard]] Place go(const Vec3& from_mm, const Vec3& goal_mm, double radius_mm) const;
  /// Farther along a way that comes from far away, so far as no wall can be.
  [[nodiscard]] Vec3 nearTheMesh(const Vec3& from_mm, const Vec3& goal_mm) const;
  [[nodiscard]] Walls wallsAt(const Around& around, const Vec3& middle_mm, double radius_mm) const;
  [[nodiscard]] Hit sweep(const Around& around, const Vec3& from_mm, const Vec3& way_mm, double radius_mm) const;

  const TriangleTree* tree_;
  Vec3 middle_mm_;  // of the mesh
  double radius_mm_;
  double least_mm_;   // a radius of zero has this one: far more than rounding
  double lost_mm_;    // more than rounding
  double far_mm_;     // from the mesh's middle: nothing is there, not even with the radius
  double around_mm_;  // triangles are looked up as far around the sphere
};

}  // namespace fyd::scene
