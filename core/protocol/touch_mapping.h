// From the touchpad's touch to the robot's target, in the touchpad's frame [thesis §4.2]:
//   goal = (s_xy·x, s_xy·y, s_z·z),   target ← w·target + (1 − w)·goal   for each touch received.
// Out of contact, or with x = y = 0, x and y are held; z > 0 with x and y both non-zero is ignored altogether, as the
// authors' robot does.
//
// After an interruption (a touchpad that connects or was silent, an arm that follows again) touch and arm need not fit
// together: the touchpad may have started anew, or the arm may have been moved. The target then stays where the arm
// stands until a finger leads it, or until the touch moves without one (it is lifted), which both happen in an active
// session only; and a touch without a finger leads only once it was as high as the arm, so that the arm does not go
// down to it.
#pragma once

#include <optional>

#include "core/base/vec3.h"
#include "core/pipeline/messages.h"
#include "core/pipeline/touch_motion.h"

namespace fyd::protocol {

struct TouchMappingSettings {
  double scale_xy = 1.0;
  double scale_z = pipeline::kRobotTravelForDepth;
  double keep_xy = 0.8;  ///< w of x and y
  double keep_z = 0.9;   ///< w of z
};

/// What a touch asks of the arm.
struct TouchGoal {
  Vec3 position_mm;    ///< by the scales
  bool along = false;  ///< x and y are to be followed
  bool depth = false;  ///< z is
};

class TouchMapping {
 public:
  explicit TouchMapping(const TouchMappingSettings& settings = {}) : settings_(settings) {}

  /// Starts from where the robot stands.
  void reset(const Vec3& target_mm);
  /// Starts from where the robot stands, after an interruption.
  void resume(const Vec3& target_mm);
  /// Where the touch leads, without smoothing. Nothing is to be followed of one that is not finite, that the rules
  /// above ignore, or that waits after an interruption.
  [[nodiscard]] TouchGoal goal(const pipeline::TouchMessage& touch);
  /// @return the new target, mm; always finite. A touch that is not finite changes nothing.
  const Vec3& apply(const pipeline::TouchMessage& touch);
  [[nodiscard]] const Vec3& target() const { return target_mm_; }

 private:
  bool waits(const pipeline::TouchMessage& touch);

  TouchMappingSettings settings_;
  Vec3 target_mm_;
  bool interrupted_ = false;
  std::optional<Vec3> first_;  // touch after the interruption
  bool moved_ = false;         // it has, since then
  bool level_ = false;         // it was as high as the arm, since then
};

}  // namespace fyd::protocol
