// The force of a soft body at 1 kHz where the body itself is stepped slower, on another thread.
//
// The body publishes a SoftTouch: a plain value, to be handed over whole. Between two of
// them the body is a spring that only pushes. A change of the spring under a pressing hand could give energy, so its
// energy is limited to the hand's work since it touched: f²/2S ≤ paid. So over any path, whatever is published and
// however late, the hand gets back no more than it gave (a step's work is that of the force at its end).
// Stability: may change
#pragma once

#include "core/base/api.h"
#include "core/base/vec3.h"

namespace fyd::scene {

/// What a soft body's slower step hands over.
struct SoftTouch {
  double date_s = 0.0;              ///< of the body's step
  bool near = false;                ///< there is a surface that can be touched
  Vec3 surface_mm;                  ///< where the force is zero: the touched point moved out by force/stiffness
  Vec3 normal;                      ///< outwards, unit length
  double stiffness_N_per_mm = 0.0;  ///< of a slow press there
  double reach_mm = 0.0;            ///< deeper than this, nothing is felt: the point is beneath another place
};

/// The 1 kHz side. One thread's own.
class FYD_API SoftTouchForce {
 public:
  /// On the hand. NaN feels nothing.
  [[nodiscard]] Vec3 step(const Vec3& hand_mm, const SoftTouch& touch);
  /// Work of the hand since it touched, less what it got back. ≥ 0.
  [[nodiscard]] double paid_mJ() const { return paid_mJ_; }
  void reset() { *this = {}; }

 private:
  Vec3 hand_mm_;
  bool known_ = false;
  double force_N_ = 0.0, paid_mJ_ = 0.0;
};

}  // namespace fyd::scene
