#include "core/scene/soft/soft_touch.h"

#include <algorithm>
#include <cmath>

#include "core/scene/mesh/vector.h"

namespace fyd::scene {

Vec3 SoftTouchForce::step(const Vec3& hand, const SoftTouch& touch) {
  const double s = touch.stiffness_N_per_mm;
  const double depth = dot(touch.normal, touch.surface_mm - hand);
  if (!touch.near || !(s > 0.0) || !(depth > 0.0 && depth <= touch.reach_mm) || !hand.finite()) {
    force_N_ = paid_mJ_ = 0.0;
    known_ = hand.finite();
    hand_mm_ = known_ ? hand : Vec3{};
    return {};
  }
  const double wanted = s * depth;
  const double moved = known_ ? dot(touch.normal, hand_mm_ - hand) : 0.0;  // inwards, along this step's force
  // Largest force f with f²/2S ≤ paid + f·moved: the root of a parabola.
  const double budget = s * (moved + std::sqrt(moved * moved + 2.0 * paid_mJ_ / s));
  force_N_ = std::clamp(wanted, 0.0, std::max(0.0, budget));
  paid_mJ_ = std::max(0.0, paid_mJ_ + force_N_ * moved);
  known_ = true;
  hand_mm_ = hand;
  return force_N_ * touch.normal;
}

}  // namespace fyd::scene
