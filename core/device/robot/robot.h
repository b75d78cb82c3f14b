// A robot arm as the robot end sees it: simulated, or a KUKA LWR behind FRI (fri_robot.h).
#pragma once

#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/time.h"
#include "core/base/vec3.h"
#include "core/device/robot/motion_limiter.h"

namespace fyd::device {

/// Frame: x right, y back, z up as the touchpad's; origin where the tool stood when the robot end started.
struct RobotReadings {
  Vec3 position_mm;
  double force_N = 0.0;  ///< normal contact force on the tool, ≥ 0
  Vec3 acceleration_g;   ///< as the sensor gives it, gravity included
  Instant taken{};
  std::optional<Vec3> commanded_mm = std::nullopt;  ///< the commanded position, of an arm that yields to a force
  /// Of what it touches now, if known; 0: it touches nothing. Replaces the probed stiffness.
  std::optional<double> stiffness_N_per_mm = std::nullopt;
};

/// Used by one thread at a time.
class Robot {
 public:
  virtual ~Robot() = default;
  [[nodiscard]] virtual Message description() const = 0;
  /// Whether the times handed to `exchange` are its only clock, so that it may run faster than real time.
  [[nodiscard]] virtual bool inVirtualTime() const { return false; }

  /// Sends the target and reads the state, as one exchange.
  /// @return an error when the target is not finite or the arm did not answer or does not follow; the first exchange
  /// that succeeds again holds the arm where it stands
  [[nodiscard]] virtual Result<RobotReadings> exchange(const Vec3& target_mm, Instant now) = 0;

  /// Velocity of the target of the next exchanges, mm/s, until the next call. Used by an arm that keeps its limits.
  virtual void targetMoves(const Vec3& /*velocity_mm_s*/) {}
  /// Delay of the tool behind the commanded position, as far as known, s.
  [[nodiscard]] virtual double lag_s() const { return 0.0; }

  /// Limits for all commands from now on. An arm that takes its commands in its own ticks, not in the caller's, keeps
  /// them itself. @return false: the caller has to keep them, one exchange being one tick
  virtual bool keepLimits(const MotionLimits& /*limits*/) { return false; }
  /// Of an arm that keeps its limits: brakes within them from the next exchange on, whatever the target.
  virtual void comeToRest() {}
  /// Of an arm that keeps its limits: whether the last command is at rest.
  [[nodiscard]] virtual bool atRest() const { return true; }
};

}  // namespace fyd::device
