// From the touchpad's touch to the robot's target, in the touchpad's frame (thesis §4.2):
//   goal = (s_xy·x, s_xy·y, s_z·z),   target ← w·target + (1 − w)·goal   for each touch received.
// x = y = 0 holds x and y; z > 0 with x and y both non-zero is ignored altogether, as the authors' robot does.
// The authors smooth in 16-bit integers, which sticks up to 4 mm (x, y) and 9 mm (z) short of the goal; here the
// target is a double and arrives.
#pragma once

#include "core/base/vec3.h"
#include "core/pipeline/messages.h"

namespace fyd::protocol {

struct TouchMappingSettings {
  double scale_xy = 1.0;
  double scale_z = 3.0;  ///< the authors' 2 · 1.5
  double keep_xy = 0.8;  ///< w of x and y
  double keep_z = 0.9;   ///< w of z
};

class TouchMapping {
 public:
  explicit TouchMapping(const TouchMappingSettings& settings = {}) : settings_(settings) {}

  /// Starts from where the robot stands.
  void reset(const Vec3& target_mm);
  /// @return the new target, mm; always finite. A touch that is not finite changes nothing.
  const Vec3& apply(const pipeline::TouchMessage& touch);
  [[nodiscard]] const Vec3& target() const { return target_mm_; }

 private:
  TouchMappingSettings settings_;
  Vec3 target_mm_;
};

}  // namespace fyd::protocol
