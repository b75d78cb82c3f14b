// What the haptic point of a scene feels.
#pragma once

#include <cstddef>

#include "core/base/vec3.h"

namespace fyd::scene {

inline constexpr std::size_t kNoBody = static_cast<std::size_t>(-1);

struct SceneTouch {
  bool touching = false;
  Vec3 force_N;   ///< on the haptic point
  Vec3 proxy_mm;  ///< of the body that pushes most; the haptic point if nothing is touched
  Vec3 normal;
  double depth_mm = 0.0;
  double stiffness_N_per_mm = 0.0;  ///< along the force; 0 if nothing is touched
  std::size_t body = kNoBody;       ///< that pushes most

  /// In a scene of `bodies`.
  template <class Archive>
  void serialize(Archive& archive) {
    std::uint64_t number = body;
    archive(touching, force_N, proxy_mm, normal, depth_mm, stiffness_N_per_mm, number);
    body = static_cast<std::size_t>(number);
  }
};

}  // namespace fyd::scene
