// One sample of the robot's tri-axial accelerometer, the input of texture rendering.
// Stability: stable since 0.1
#pragma once

#include <cmath>

#include "core/base/fields.h"
#include "core/base/vec3.h"

namespace fyd::texture {

inline constexpr double kLargestAcceleration_g = 1000.0;  ///< on each axis, either way; more is no reading of a sensor
/// @return false for NaN, too
[[nodiscard]] inline bool plausible(const Vec3& a_g) {
  const auto within = [](double axis_g) { return std::abs(axis_g) <= kLargestAcceleration_g; };
  return within(a_g.x) && within(a_g.y) && within(a_g.z);
}

struct AccelerationSample {
  Instant taken{};
  Vec3 acceleration_g;

  static constexpr auto fields() {
    using A = AccelerationSample;
    return std::tuple(
        Field("taken_ns", "ns", "at the sensor, on the touchpad's clock as well as it is known", &A::taken),
        Field("x_g", "g", "x, in multiples of standard gravity", inside(&A::acceleration_g, &Vec3::x)),
        Field("y_g", "g", "y, in multiples of standard gravity", inside(&A::acceleration_g, &Vec3::y)),
        Field("z_g", "g", "z, in multiples of standard gravity", inside(&A::acceleration_g, &Vec3::z)));
  }
  template <class Archive>
  void serialize(Archive& archive) {
    archive(taken, acceleration_g);
  }
};

}  // namespace fyd::texture
