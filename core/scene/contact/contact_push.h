// What facet and vicinity share: direction and depth of the push out of a body, and how it fades at the rim (boundary)
// of an open mesh.
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

/// The push of a probe that is below an open mesh and outside its rim.
/// @param below the push as computed straight below the rim
/// @param offset_mm from there to the probe (rimOffset)
/// The push fades as if the rim were chamfered: with t = |offset|/depth, potential ½ k d² (1 − t²)², from the whole
/// push at the rim to none at 45°. So the force is continuous, and a closed path around the rim gives no work.
[[nodiscard]] inline Push chamferedAtRim(Push below, const Vec3& offset_mm) {
  const double offset = length(offset_mm);
  if (!(offset < below.depth_mm)) return {};
  const double t = offset / below.depth_mm, fade = 1.0 - t * t;
  below.force_over_stiffness_mm = (fade * (1.0 + t * t)) * below.force_over_stiffness_mm + (2.0 * fade) * offset_mm;
  return below;
}

/// If the nearest point is on a rim: the tangential part of the vector from it to the probe. Else zero.
[[nodiscard]] inline Vec3 rimOffset(const Mesh& mesh, const EdgeKinds& edges, const Vec3& probe_mm,
                                    const Nearest& nearest) {
  if (!edges.rim(nearest)) return {};
  const Vec3 normal = mesh.normalOf(nearest.triangle, nearest.feature), from = probe_mm - nearest.point_mm;
  return from - dot(from, normal) * normal;
}

}  // namespace fyd::scene
