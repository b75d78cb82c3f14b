// What a contact gives at a step, and what it remembers until the next.
// Stability: may change
#pragma once

#include <cstdint>

#include "core/scene/mesh/mesh.h"
#include "core/scene/mesh/triangle_distance.h"

namespace fyd::scene {

struct Contact {
  bool touching = false;
  Vec3 force_N;   ///< on the probe
  Vec3 proxy_mm;  ///< the point of the surface that is touched (proxy: the middle of its sphere); the probe if none is
  Vec3 normal;    ///< of unit length, outwards; zero if nothing is touched
  double depth_mm = 0.0;
  double stiffness_N_per_mm = 0.0;  ///< at the contact; 0 if nothing is touched
  std::uint32_t triangle = kNoTriangle;
};

/// All that a model remembers from step to step.
struct ContactState {
  template <class Archive>
  void serialize(Archive& archive) {
    archive(proxy_mm, free_mm, radius_mm, placed, touching, sliding);
  }

  Vec3 proxy_mm;
  Vec3 free_mm;            ///< where the proxy would be without friction
  double radius_mm = 0.0;  ///< of the sphere: as much of the finger's radius as fitted where it was placed
  bool placed = false;     ///< proxy_mm has a value
  bool touching = false;
  bool sliding = false;
};

}  // namespace fyd::scene
