// From the finger on the cloth to the position the robot is sent [thesis §4.2] [authors' program].
//
// Relative (default): a new touch takes hold of the robot where it stands, like a clutch; finger travel along the
// cloth becomes robot travel. Absolute (thesis): the robot goes where the finger is, with a jump at each new touch.
// Depth is the indentation in both: pressing is negative z. The position sent never leaves the workspace and never
// moves faster than the speed limit along any axis, whatever comes in: √3 times as fast in space at most. When a lost robot returns, the position is as it left it:
// resetting it would move an arm that kept its place although no finger moved.
//
// Pictures come 30 times a second; between two of them the position moves towards where the last one showed the
// finger. The message therefore also carries the position in that picture and its capture time (TouchMessage::seen).
// Stability: may change
#pragma once

#include <cstdint>

#include "core/base/api.h"
#include "core/base/time.h"
#include "core/pipeline/messages.h"

namespace fyd::pipeline {

/// The authors' declared workspace, half widths, mm.
inline constexpr Vec3 kWorkspaceHalf_mm{35.0, 25.0, 70.0};

/// Robot travel downward per millimetre of indentation: 2 · 1.5 [authors' program].
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

class FYD_API TouchMotion {
 public:
  [[nodiscard]] TouchMessage step(const MotionInput& input);

  static constexpr std::uint16_t kStateVersion = 2;  // 1: without seen_

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
  Vec3 anchor_mm_;  // robot position of the finger position (0, 0) during this touch
  bool touching_ = false;
  SeenFinger seen_;  // newest picture of this touch; the speed limit holds from picture to picture
};

}  // namespace fyd::pipeline
