// From the finger on the cloth to the position the robot is sent (thesis §4.2, fact sheet §2).
//
// Relative (default): a new touch takes hold of the robot where it stands, like a clutch; finger travel along the
// cloth becomes robot travel. Absolute (thesis): the robot goes where the finger is, with a jump at each new touch.
// Depth is the indentation in both: pressing is negative z. The position sent never leaves the workspace and never
// moves faster than the speed limit, whatever comes in. A robot that is lost and comes back finds the position as it
// left it: one that started anew would lead an arm that kept its place away, with nobody's finger behind it.
//
// Pictures come 30 times a second, so between two of them the position moves on towards where the last one showed the
// finger, and is neither there nor then. Beside it stands what the picture showed and when it was taken.
#pragma once

#include <cstdint>

#include "core/base/time.h"
#include "core/pipeline/messages.h"

namespace fyd::pipeline {

/// The authors' declared workspace, half widths, mm.
inline constexpr Vec3 kWorkspaceHalf_mm{35.0, 25.0, 70.0};

/// How far the robot is led down by a millimetre of indentation: the authors' 2 · 1.5 (fact sheet §2).
inline constexpr double kRobotTravelForDepth = 3.0;

struct MotionInput {
  Duration elapsed{};    ///< since the last step; ≤ 0 moves nothing
  bool enabled = false;  ///< false: the position stays where it is
  bool contact = false;  ///< a finger is on the cloth and its position is known
  double finger_x_mm = 0.0;
  double finger_y_mm = 0.0;
  double indentation_mm = 0.0;  ///< NaN: unknown, depth stays
  double force_N = 0.0;         ///< NaN: unknown, sent as 0
  Instant finger_taken{};       ///< of the picture that showed x and y
  bool absolute = false;
  double scale = 1.0;        ///< robot travel for finger travel along the cloth
  double depth_scale = 1.0;  ///< robot travel for indentation
  double speed_limit_mm_s = 200.0;
};

class TouchMotion {
 public:
  [[nodiscard]] TouchMessage step(const MotionInput& input);

  static constexpr std::uint16_t kStateVersion = 2;  // 1: without what was seen

  template <class Archive>
  void serialize(Archive& archive) {
    archive(position_mm_, anchor_mm_, touching_, seen_.x_mm, seen_.y_mm, seen_.taken);
  }
  template <class Archive>
  void restore(Archive& archive, std::uint16_t /*version*/) {
    archive(position_mm_, anchor_mm_, touching_);
    seen_ = {.x_mm = position_mm_.x, .y_mm = position_mm_.y};
  }

 private:
  void see(const Vec3& target_mm, const MotionInput& input);

  Vec3 position_mm_;
  Vec3 anchor_mm_;  // position that finger (0, 0) stands for during this touch
  bool touching_ = false;
  SeenFinger seen_;  // during this touch; no faster than the speed limit from picture to picture
};

}  // namespace fyd::pipeline
