#include "core/device/robot/axis_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace fyd::device {
namespace {

constexpr int kHalvings = 60;  // of a tick, until the moment of switching is known to the last bit

/// The fastest change to `speed`, which is then kept.
struct Ramp {
  std::array<double, 3> jerk{};
  std::array<double, 3> duration_s{};
  double speed = 0.0;
};

Ramp rampTo(const AxisState& state, double speed, const AxisLimits& limits) {
  const double j = limits.jerk;
  const double coasting = state.velocity + state.acceleration * std::abs(state.acceleration) / (2.0 * j);
  const double side = speed >= coasting ? 1.0 : -1.0;
  const double gain = side * (speed - state.velocity);
  const double a = side * state.acceleration;
  double peak = std::sqrt(std::max(j * gain + 0.5 * a * a, 0.0));
  double held_s = 0.0;
  if (peak > limits.acceleration) {
    peak = limits.acceleration;
    held_s = std::max((gain - (2.0 * peak * peak - a * a) / (2.0 * j)) / peak, 0.0);
  }
  return {.jerk = {side * j, 0.0, -side * j},
          .duration_s = {std::max((peak - a) / j, 0.0), held_s, peak / j},
          .speed = speed};
}

AxisState moved(const AxisState& from, double j, double t) {
  return {.position = from.position + t * (from.velocity + t * (from.acceleration / 2.0 + t * j / 6.0)),
          .velocity = from.velocity + t * (from.acceleration + t * j / 2.0),
          .acceleration = from.acceleration + t * j};
}

AxisState along(AxisState state, const Ramp& ramp, double time_s) {
  for (std::size_t i = 0; i < ramp.jerk.size(); ++i) {
    if (time_s < ramp.duration_s[i]) return moved(state, ramp.jerk[i], time_s);
    state = moved(state, ramp.jerk[i], ramp.duration_s[i]);
    time_s -= ramp.duration_s[i];
  }
  // Exactly the speed asked for, without rounding errors.
  return {.position = state.position + time_s * ramp.speed, .velocity = ramp.speed};
}

/// @param back, forth the speeds on the way to a goal that lies below and above, back ≤ 0 ≤ forth
AxisState towards(const AxisState& state, double goal, double back, double forth, const AxisLimits& limits,
                  double tick_s) {
  const double missing = goal - restPlace(state, limits);
  if (missing == 0.0) return brake(state, limits, tick_s);
  const Ramp ramp = rampTo(state, missing > 0.0 ? forth : back, limits);
  // The longer it accelerates, the farther on it comes to rest.
  const auto passes = [&](const AxisState& there) {
    const double beyond = restPlace(there, limits) - goal;
    return missing > 0.0 ? beyond > 0.0 : beyond < 0.0;
  };
  const AxisState there = along(state, ramp, tick_s);
  if (!passes(there)) return there;
  double before_s = 0.0;
  double after_s = tick_s;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle_s = 0.5 * (before_s + after_s);
    (passes(along(state, ramp, middle_s)) ? after_s : before_s) = middle_s;
  }
  return brake(along(state, ramp, before_s), limits, tick_s - before_s);
}

}  // namespace

double restPlace(const AxisState& state, const AxisLimits& limits) {
  const Ramp stop = rampTo(state, 0.0, limits);
  AxisState there = state;
  for (std::size_t i = 0; i < stop.jerk.size(); ++i) there = moved(there, stop.jerk[i], stop.duration_s[i]);
  return there.position;
}

AxisState brake(const AxisState& state, const AxisLimits& limits, double tick_s) {
  return along(state, rampTo(state, 0.0, limits), tick_s);
}

AxisState approach(const AxisState& state, double goal, const AxisLimits& limits, double tick_s) {
  return towards(state, goal, -limits.speed, limits.speed, limits, tick_s);
}

AxisState meet(const AxisState& state, double goal, double velocity, const AxisLimits& limits, double tick_s) {
  AxisState seen = state;  // in the goal's frame
  seen.position -= goal - velocity * tick_s;
  seen.velocity -= velocity;
  AxisState there = towards(seen, 0.0, -limits.speed - velocity, limits.speed - velocity, limits, tick_s);
  there.position += goal;
  there.velocity += velocity;
  return there;
}

}  // namespace fyd::device
