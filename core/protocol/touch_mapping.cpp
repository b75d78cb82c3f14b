#include "core/protocol/touch_mapping.h"

#include <cmath>

namespace fyd::protocol {
namespace {

constexpr double kSameHeight_mm = 1.0;  // what smoothing and whole millimetres leave

}  // namespace

void TouchMapping::reset(const Vec3& target_mm) {
  if (target_mm.finite()) target_mm_ = target_mm;
  interrupted_ = false;
}

void TouchMapping::resume(const Vec3& target_mm) {
  reset(target_mm);
  interrupted_ = true;
  first_.reset();
  moved_ = level_ = false;
}

bool TouchMapping::waits(const pipeline::TouchMessage& touch) {
  if (!interrupted_) return false;
  if (!first_) first_ = touch.position_mm;
  moved_ = moved_ || touch.position_mm != *first_;
  level_ = level_ || settings_.scale_z * touch.position_mm.z >= target_mm_.z - kSameHeight_mm;
  interrupted_ = !touch.in_contact && !(moved_ && level_);
  return interrupted_;
}

TouchGoal TouchMapping::goal(const pipeline::TouchMessage& touch) {
  const Vec3& p = touch.position_mm;
  TouchGoal out{.position_mm = {settings_.scale_xy * p.x, settings_.scale_xy * p.y, settings_.scale_z * p.z}};
  if (!p.finite() || !out.position_mm.finite()) return out;
  if (p.z > 0.0 && p.x != 0.0 && p.y != 0.0) return out;
  if (waits(touch)) return out;
  out.along = touch.in_contact && !(p.x == 0.0 && p.y == 0.0);
  out.depth = true;
  return out;
}

const Vec3& TouchMapping::apply(const pipeline::TouchMessage& touch) {
  const TouchGoal to = goal(touch);
  Vec3 next = target_mm_;
  if (to.along) {
    next.x = settings_.keep_xy * next.x + (1.0 - settings_.keep_xy) * to.position_mm.x;
    next.y = settings_.keep_xy * next.y + (1.0 - settings_.keep_xy) * to.position_mm.y;
  }
  if (to.depth) next.z = settings_.keep_z * next.z + (1.0 - settings_.keep_z) * to.position_mm.z;
  if (next.finite()) target_mm_ = next;
  return target_mm_;
}

}  // namespace fyd::protocol
