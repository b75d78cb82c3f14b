// One axis that goes to a goal within limits of speed, acceleration and jerk. Pure.
//
// The motion is a function of continuous time whose jerk is +J, 0 or −J: accelerate towards the goal as the limits
// allow, and switch to the fastest stop at the one moment from which that stop ends on the goal. The tick only samples
// this function, so that the limits hold for ticks of any, also of changing, length:
// |Δp|/h ≤ speed, |Δ²p|/h² ≤ acceleration and |Δ³p|/h³ ≤ jerk for positions taken every h (a divided difference is a
// mean of the derivative). A goal that stays is reached exactly and not passed; no position lies beyond the farthest
// of the goals so far and the start.
//
// A moving goal is treated in the frame that moves with it: the limits of acceleration and jerk stay, that of speed
// differs between the two directions.
//
//   speed after the acceleration a has been reduced to 0:  v + a|a|/2J
//   a change of speed by g from the acceleration a:        peak √(J·g + a²/2), at most the limit, held as needed
#pragma once

namespace fyd::device {

/// Any unit of length; each above 0 and finite.
struct AxisLimits {
  double speed = 1.0;
  double acceleration = 1.0;
  double jerk = 1.0;
};

struct AxisState {
  double position = 0.0;
  double velocity = 0.0;
  double acceleration = 0.0;

  [[nodiscard]] bool atRest() const { return velocity == 0.0 && acceleration == 0.0; }
};

/// Where the fastest stop ends.
[[nodiscard]] double restPlace(const AxisState& state, const AxisLimits& limits);
/// The state `tick_s` later on the way to `goal`.
[[nodiscard]] AxisState approach(const AxisState& state, double goal, const AxisLimits& limits, double tick_s);
/// The state `tick_s` later on the way to a goal that moves at constant velocity and is at `goal` then: where the two
/// meet they have the same speed, so that such a goal is followed without lag. Within the same limits.
/// @param velocity of the goal, at most the limit of speed
[[nodiscard]] AxisState meet(const AxisState& state, double goal, double velocity, const AxisLimits& limits,
                             double tick_s);
/// The state `tick_s` later in the fastest stop.
[[nodiscard]] AxisState brake(const AxisState& state, const AxisLimits& limits, double tick_s);

}  // namespace fyd::device
