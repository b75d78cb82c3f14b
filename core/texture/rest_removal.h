// Takes away the acceleration at rest (gravity and the sensor's offset) as the thesis does: the first reading after
// connecting counts as rest and is subtracted from every one.
// Stability: may change
#pragma once

#include "core/base/vec3.h"

namespace fyd::texture {

class RestRemoval {
 public:
  /// @param acceleration_g finite
  [[nodiscard]] Vec3 step(const Vec3& acceleration_g) {
    if (!known_) rest_g_ = acceleration_g;
    known_ = true;
    return acceleration_g - rest_g_;
  }
  void reset() { known_ = false; }

 private:
  bool known_ = false;
  Vec3 rest_g_;
};

}  // namespace fyd::texture
