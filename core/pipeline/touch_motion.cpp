#include "core/pipeline/touch_motion.h"

#include <algorithm>
#include <cmath>

namespace fyd::pipeline {
namespace {

double approach(double from, double to, double furthest) { return from + std::clamp(to - from, -furthest, furthest); }

}  // namespace

TouchMessage TouchMotion::step(const MotionInput& input) {
  const bool contact =
      input.enabled && input.contact && std::isfinite(input.finger_x_mm) && std::isfinite(input.finger_y_mm);
  const double furthest = std::max(0.0, toSeconds(input.elapsed)) * input.speed_limit_mm_s;
  if (contact) {
    const Vec3 finger{input.scale * input.finger_x_mm, input.scale * input.finger_y_mm, 0.0};
    if (input.absolute) {
      anchor_mm_ = {};
    } else if (!touching_) {
      anchor_mm_ = position_mm_ - finger;
    }
    const Vec3 wanted = anchor_mm_ + finger;
    const Vec3 target{std::clamp(wanted.x, -kWorkspaceHalf_mm.x, kWorkspaceHalf_mm.x),
                      std::clamp(wanted.y, -kWorkspaceHalf_mm.y, kWorkspaceHalf_mm.y), 0.0};
    // At the workspace's edge the anchor follows the finger, so that turning back moves the robot at once.
    if (!input.absolute) anchor_mm_ = target - finger;
    see(target, input);
    position_mm_.x = approach(position_mm_.x, target.x, furthest);
    position_mm_.y = approach(position_mm_.y, target.y, furthest);
  }
  touching_ = contact;
  const bool depth_known = contact ? std::isfinite(input.indentation_mm) : !input.contact;
  if (input.enabled && depth_known) {
    const double depth = contact ? std::max(0.0, input.indentation_mm) * input.depth_scale : 0.0;
    position_mm_.z = approach(position_mm_.z, -std::min(depth, kWorkspaceHalf_mm.z), furthest);
  }
  return {.position_mm = position_mm_,
          .in_contact = contact,
          .force_N = contact && std::isfinite(input.force_N) ? std::max(0.0, input.force_N) : 0.0,
          .seen = contact ? std::optional(seen_) : std::nullopt};
}

void TouchMotion::see(const Vec3& target_mm, const MotionInput& input) {
  if (!touching_) {
    seen_ = {.x_mm = position_mm_.x, .y_mm = position_mm_.y, .taken = input.finger_taken};
    return;
  }
  if (input.finger_taken <= seen_.taken) return;
  const double furthest = std::max(0.0, toSeconds(input.finger_taken - seen_.taken)) * input.speed_limit_mm_s;
  seen_ = {.x_mm = approach(seen_.x_mm, target_mm.x, furthest),
           .y_mm = approach(seen_.y_mm, target_mm.y, furthest),
           .taken = input.finger_taken};
}

}  // namespace fyd::pipeline
