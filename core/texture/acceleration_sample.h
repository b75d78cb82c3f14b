// One sample of the robot's tri-axial accelerometer, the raw material of texture.
#pragma once

#include "core/base/time.h"
#include "core/base/vec3.h"

namespace fyd::texture {

struct AccelerationSample {
  Instant taken{};      ///< at the sensor, on the touchpad's clock as well as it is known
  Vec3 acceleration_g;  ///< multiples of standard gravity

  template <class Archive>
  void serialize(Archive& archive) {
    archive(taken, acceleration_g);
  }
};

}  // namespace fyd::texture
