// Contact with the nearest triangle: F = −K·X. The distance to the mesh is exact; the direction of the force jumps from
// facet to facet.
#pragma once

#include "core/scene/contact/contact_push.h"

namespace fyd::scene {

/// If the nearest point is on an edge or a vertex (a concave one, as the probe is within the body), the push is along
/// the line from the probe to it.
[[nodiscard]] inline Push facetPush(const Mesh& mesh, const EdgeKinds& edges, const Vec3& probe_mm,
                                    const Nearest& nearest) {
  const Vec3 to_surface = nearest.point_mm - probe_mm;
  const Vec3 normal = mesh.normalOf(nearest.triangle, nearest.feature);
  const double depth_mm = dot(to_surface, normal);
  if (!(depth_mm > 0.0)) return {};
  if (nearest.feature == Feature::inside) return {depth_mm * normal, nearest.point_mm, normal, depth_mm};
  if (edges.rim(nearest)) {
    return chamferedAtRim({depth_mm * normal, nearest.point_mm, normal, depth_mm}, depth_mm * normal - to_surface);
  }
  const double distance_mm = length(to_surface);
  return {to_surface, nearest.point_mm, (1.0 / distance_mm) * to_surface, distance_mm};
}

}  // namespace fyd::scene
