// Contact with the smooth surface that is fitted to the mesh: continuous across edges that are no crease.
#pragma once

#include "core/scene/contact/contact_push.h"
#include "core/scene/contact/fitted_foot.h"

namespace fyd::scene {

[[nodiscard]] inline Push vicinityPush(const FittedSurface& surface, const Vec3& probe_mm, const Nearest& nearest) {
  const bool rim = surface.edges().rim(nearest);
  const Vec3 offset_mm = rim ? rimOffset(surface.mesh(), surface.edges(), probe_mm, nearest) : Vec3{};
  const Foot foot = surface.foot(probe_mm - offset_mm, nearest);
  if (!(foot.height_mm < 0.0)) return {};
  const Push push{-foot.height_mm * foot.normal, foot.point_mm, foot.normal, -foot.height_mm};
  return rim ? chamferedAtRim(push, offset_mm) : push;
}

}  // namespace fyd::scene
