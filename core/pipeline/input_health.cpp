#include "core/pipeline/input_health.h"

#include <cmath>

#include "core/pipeline/parameters.h"

namespace fyd::pipeline {
namespace {

template <class T>
bool stale(const Timed<T>& input, Instant now, double maximum_age_ms) {
  return input.freshness(now, fromSeconds(maximum_age_ms * 1e-3)) != Freshness::fresh;
}

}  // namespace

bool InputHealth::Grace::expired(bool now_bad, Instant now, double grace_ms) {
  if (now_bad && !bad) since = now;
  bad = now_bad;
  ever_good = ever_good || !bad;
  if (!ever_good) return true;
  return bad && now - since > fromSeconds(grace_ms * 1e-3);
}

Lacks InputHealth::judge(const Inputs& inputs, const HealthContext& context, const StepParameters& limits) {
  Lacks lacks;
  const auto mark = [&lacks](Lack lack, bool missing) { lacks.set(static_cast<std::size_t>(lack), missing); };
  const bool camera_stale = stale(inputs.finger, inputs.now, limits.finger_maximum_age_ms);
  const bool ir_stale = stale(inputs.ir, inputs.now, limits.ir_maximum_age_ms);
  const bool bridge_stale = stale(inputs.bridge, inputs.now, limits.bridge_maximum_age_ms);

  mark(Lack::motors_stale, stale(inputs.motors, inputs.now, limits.motors_maximum_age_ms));
  mark(Lack::ir_stale, ir_stale);
  mark(Lack::ir_invalid,
       !ir_stale && ir_invalid_.expired(!context.indentation_usable, inputs.now, limits.ir_maximum_age_ms));
  mark(Lack::bridge_stale, bridge_stale);
  mark(Lack::bridge_invalid,
       !bridge_stale && bridge_invalid_.expired(!context.bridge_valid, inputs.now, limits.bridge_maximum_age_ms));
  mark(Lack::camera_stale, camera_stale);
  mark(Lack::camera_blind, !camera_stale && camera_blind_.expired(!showsCloth(inputs.finger.value.reason), inputs.now,
                                                                  limits.finger_maximum_age_ms));
  if (context.needs_robot) {
    const LinkPhase phase = inputs.robot.phase;
    mark(Lack::robot_waiting, phase == LinkPhase::none || phase == LinkPhase::waiting);
    mark(Lack::robot_lost, phase == LinkPhase::lost);
    mark(Lack::robot_closed, phase == LinkPhase::closed);
    mark(Lack::robot_frozen,
         inputs.robot.state.count > 0 && !std::isfinite(inputs.robot.state.value.stiffness_N_per_mm));
  }
  mark(Lack::no_target, !context.target_known);
  return lacks;
}

bool InputHealth::devicesLive(const Lacks& lacks) {
  return !(lacks.test(static_cast<std::size_t>(Lack::motors_stale)) &&
           lacks.test(static_cast<std::size_t>(Lack::ir_stale)) &&
           lacks.test(static_cast<std::size_t>(Lack::bridge_stale)));
}

Lack InputHealth::first(const Lacks& lacks) {
  for (const Lack lack : lacksByUrgency()) {
    if (lacks.test(static_cast<std::size_t>(lack))) return lack;
  }
  return Lack::none;
}

}  // namespace fyd::pipeline
