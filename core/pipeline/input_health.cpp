#include "core/pipeline/input_health.h"

#include <cmath>

#include "core/pipeline/parameters.h"

namespace fyd::pipeline {
bool InputHealth::Grace::expired(bool now_bad, Instant now, double grace_ms) {
  if (now_bad && !bad) since = now;
  bad = now_bad;
  ever_good = ever_good || !bad;
  if (!ever_good) return true;
  return bad && now - since > fromSeconds(grace_ms * 1e-3);
}

Judgement InputHealth::judge(const Inputs& in, const HealthContext& now, const StepParameters& limits) {
  Judgement out;
  const auto stale = [&in](const auto& input, double maximum_age_ms) {
    return input.freshness(in.now, fromSeconds(maximum_age_ms * 1e-3)) != Freshness::fresh;
  };
  const auto stays = [this, &in](Fault fault, bool bad, double grace_ms) {
    return graceOf(fault).expired(bad, in.now, grace_ms);
  };
#define FAULT(name, number, need, of, help, what, remedy, missing)                                      \
  if (Need::need != Need::robot || now.needs_robot) {                                                   \
    (Need::need == Need::rendering ? out.interruptions : out.faults).set(std::size_t{number}, missing); \
  }
#include "core/pipeline/fault_list.h"
#undef FAULT
  return out;
}

bool InputHealth::devicesLive(const FaultSet& faults) {
  return !(faults.test(static_cast<std::size_t>(Fault::motors_stale)) &&
           faults.test(static_cast<std::size_t>(Fault::ir_stale)) &&
           faults.test(static_cast<std::size_t>(Fault::bridge_stale)));
}

Fault InputHealth::first(const FaultSet& faults) {
  for (const FaultInfo& info : faultsByUrgency()) {
    if (faults.test(static_cast<std::size_t>(info.fault))) return info.fault;
  }
  return Fault::none;
}

}  // namespace fyd::pipeline
