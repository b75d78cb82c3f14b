// From the finger on the cloth to the position the robot is sent (thesis §4.2, fact sheet §2).
//
// Relative (default): a new touch takes hold of the robot where it stands, like a clutch; finger travel along the
// cloth becomes robot travel. Absolute (thesis): the robot goes where the finger is, with a jump at each new touch.
// Depth is the indentation in both: pressing is negative z. The position sent never leaves the workspace and never
// moves faster than the speed limit, whatever comes in. A robot that is lost and comes back finds the position as it
// left it: one that started anew would lead an arm that kept its place away, with nobody's finger behind it.
#pragma once

#include "core/base/time.h"
#include "core/pipeline/messages.h"

namespace fyd::pipeline {

/// The authors' declared workspace, half widths, mm.
inline constexpr Vec3 kWorkspaceHalf_mm{35.0, 25.0, 70.0};

struct MotionInput {
  Duration elapsed{};    ///< since the last step; ≤ 0 moves nothing
  bool enabled = false;  ///< false: the position stays where it is
  bool contact = false;  ///< a finger is on the cloth and its position is known
  double finger_x_mm = 0.0;
  double finger_y_mm = 0.0;
  double indentation_mm = 0.0;  ///< NaN: unknown, depth stays
  double force_N = 0.0;         ///< NaN: unknown, sent as 0
  bool absolute = false;
  double scale = 1.0;        ///< robot travel for finger travel along the cloth
  double depth_scale = 1.0;  ///< robot travel for indentation
  double speed_limit_mm_s = 200.0;
};

class TouchMotion {
 public:
  [[nodiscard]] TouchMessage step(const MotionInput& input);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(position_mm_, anchor_mm_, touching_);
  }

 private:
  Vec3 position_mm_;
  Vec3 anchor_mm_;  // position that finger (0, 0) stands for during this touch
  bool touching_ = false;
};

}  // namespace fyd::pipeline
