// A racket's plate, and how it moves within a step: at constant velocity and constant angular rate about one axis.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/api.h"
#include "core/scene/gesture/gesture.h"

namespace fyd::scene {

enum class RacketShape : std::uint8_t { disc, rectangle };
inline constexpr std::array<std::string_view, 2> kRacketShapes = {"disc", "rectangle"};

/// `normal` and `along` are unit vectors at right angles (orthonormalise).
struct RacketPose {
  Vec3 centre_mm;
  Vec3 normal{0.0, 0.0, 1.0};
  Vec3 along{1.0, 0.0, 0.0};  ///< its width

  template <class Archive>
  void serialize(Archive& archive) {
    archive(centre_mm, normal, along);
  }
};
/// Makes `normal` and `along` orthonormal. @return false if they are parallel, or one of them has no length
[[nodiscard]] FYD_API bool orthonormalise(RacketPose& pose);

struct FYD_API Plate {
  RacketShape shape = RacketShape::disc;
  double half_width_mm = 0.0, half_height_mm = 0.0;  ///< a disc's radius is its half width

  /// The plate's nearest point to p.
  [[nodiscard]] Vec3 nearest(const RacketPose& pose, const Vec3& p) const;
};

class FYD_API RacketMotion {
 public:
  /// A racket whose centre moves faster than `most_mm_per_s`, or that turns by more than 1 rad, has been put at `to`:
  /// it is there from the start of the step and does not move (`teleported`).
  RacketMotion(const RacketPose& from, const RacketPose& to, double dt_s, double most_mm_per_s);

  [[nodiscard]] RacketPose at(double t_s) const;
  [[nodiscard]] bool teleported() const { return teleported_; }
  /// Of its material at p.
  [[nodiscard]] Vec3 velocity(const RacketPose& pose, const Vec3& p) const {
    return velocity_ + cross(turning_, p - pose.centre_mm);
  }
  /// Upper bound of a thing's acceleration in the plate's rotating frame, mm/s².
  /// @param most_mm its largest distance from the centre
  [[nodiscard]] double mostRelativeAcceleration(double acceleration_mm_per_s2, double speed_mm_per_s,
                                                double most_mm) const;
  [[nodiscard]] double speed() const { return length(velocity_); }

 private:
  RacketPose from_;
  Vec3 velocity_, turning_;  ///< mm/s, rad/s
  bool teleported_ = false;
};

}  // namespace fyd::scene
