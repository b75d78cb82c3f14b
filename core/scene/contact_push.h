// What facet and vicinity have in common: which way and how far a probe has to go to be out, and how that ends at the
// rim of an open mesh.
#pragma once

#include "core/scene/edge_kinds.h"
#include "core/scene/vector.h"

namespace fyd::scene {

/// Force by stiffness; nothing if depth_mm is 0.
struct Push {
  Vec3 way_mm;
  Vec3 point_mm;  ///< of the surface
  Vec3 normal;    ///< of unit length, outwards
  double depth_mm = 0.0;
};

/// Below an open mesh and beside its rim by `beside_mm`, the push that was computed below the rim ends as if the rim
/// were chamfered: with t = beside/depth, potential ½ k d² (1 − t²)², from the whole push at the rim to none at 45°. So
/// the force is continuous, and going around the rim gives no work.
[[nodiscard]] inline Push besideRim(Push below, const Vec3& beside_mm) {
  const double side = length(beside_mm);
  if (!(side < below.depth_mm)) return {};
  const double t = side / below.depth_mm, rest = 1.0 - t * t;
  below.way_mm = (rest * (1.0 + t * t)) * below.way_mm + (2.0 * rest) * beside_mm;
  return below;
}

/// Beside the rim: from the nearest point to the probe, without what is along the normal there. Else zero.
[[nodiscard]] inline Vec3 besideRim(const Mesh& mesh, const EdgeKinds& edges, const Vec3& probe_mm,
                                    const Nearest& nearest) {
  if (!edges.rim(nearest)) return {};
  const Vec3 normal = mesh.normalOf(nearest.triangle, nearest.feature), from = probe_mm - nearest.point_mm;
  return from - dot(from, normal) * normal;
}

}  // namespace fyd::scene
