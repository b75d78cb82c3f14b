// Limits on what an arm is told: workspace, speed and acceleration, whatever is asked for. Pure: time is handed in.
//
// Each axis follows its goal (the target, clamped to the workspace) in steps of h = 1 ms with its share v = V/√3,
// a = A/√3 of the limits, so that the vectors stay within V and A. In units of a·h² an axis at distance
// d = k(k+1)/2 + r (k whole, 0 ≤ r < k+1) moves with speed k + r/(k+1), in units of a·h: the fastest from which
// braking with a ends exactly at the goal. Hence it arrives without overshoot, and never leaves the workspace.
//
// Time that stands still or goes back moves nothing; after a pause at most 20 ms are caught up.
#pragma once

#include <cstdint>

#include "core/base/error.h"
#include "core/base/time.h"
#include "core/base/vec3.h"

namespace fyd::device {

struct MotionLimits {
  Vec3 workspace_mm{35.0, 25.0, 70.0};  ///< ± from the start, each > 0 (the authors' figures; fact sheet §2)
  double speed_mm_s = 250.0;            ///< 1…1000
  double acceleration_mm_s2 = 5000.0;   ///< 10…100 000
};

/// @return an error that names the limit, its value and its range
[[nodiscard]] Result<void> checkLimits(const MotionLimits& limits);

class MotionLimiter {
 public:
  /// @param limits as checkLimits accepts them
  explicit MotionLimiter(const MotionLimits& limits = {});

  /// Stands still at `position_mm`, wherever that is; a position that is not finite changes nothing.
  void reset(const Vec3& position_mm);

  /// The next position to command, mm, always finite. A target that is not finite is refused: the last goal stands.
  const Vec3& apply(const Vec3& target_mm, Instant now);

  [[nodiscard]] const Vec3& position_mm() const { return position_mm_; }
  [[nodiscard]] const Vec3& velocity_mm_s() const { return velocity_mm_s_; }
  /// Targets refused so far.
  [[nodiscard]] std::uint64_t refused() const { return refused_; }

 private:
  void step();
  void stepAxis(double& position, double& velocity, double goal) const;

  MotionLimits limits_;
  double axis_speed_ = 0.0;
  double axis_acceleration_ = 0.0;
  Vec3 goal_mm_;
  Vec3 position_mm_;
  Vec3 velocity_mm_s_;
  std::uint64_t refused_ = 0;
  Duration owed_{};  // time not yet stepped
  Instant last_{};
  bool started_ = false;
};

}  // namespace fyd::device
