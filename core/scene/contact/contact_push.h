// What facet and vicinity have in common: direction and depth of the push out of a body, and how it fades at the rim of
// an open mesh.
#pragma once

#include "core/scene/mesh/edge_kinds.h"
#include "core/scene/mesh/vector.h"

namespace fyd::scene {

/// A contact without its stiffness; nothing is touched if depth_mm is 0.
struct Push {
  Vec3 force_over_stiffness_mm;  ///< force divided by stiffness
  Vec3 point_mm;                 ///< of the surface
  Vec3 normal;                   ///< of unit length, outwards
  double depth_mm = 0.0;
};

/// The push of a probe below an open mesh that is beside the rim by `beside_mm`, from the push computed below the rim.
/// It fades as if the rim were chamfered: with t = beside/depth, potential ½ k d² (1 − t²)², from the whole push at the
/// rim to none at 45°. So the force is continuous, and a path around the rim gives no work.
[[nodiscard]] inline Push besideRim(Push below, const Vec3& beside_mm) {
  const double side = length(beside_mm);
  if (!(side < below.depth_mm)) return {};
  const double t = side / below.depth_mm, rest = 1.0 - t * t;
  below.force_over_stiffness_mm = (rest * (1.0 + t * t)) * below.force_over_stiffness_mm + (2.0 * rest) * beside_mm;
  return below;
}

/// Beside a rim: the part across the normal of the vector from the nearest point to the probe. Else zero.
[[nodiscard]] inline Vec3 besideRim(const Mesh& mesh, const EdgeKinds& edges, const Vec3& probe_mm,
                                    const Nearest& nearest) {
  if (!edges.rim(nearest)) return {};
  const Vec3 normal = mesh.normalOf(nearest.triangle, nearest.feature), from = probe_mm - nearest.point_mm;
  return from - dot(from, normal) * normal;
}

}  // namespace fyd::scene
