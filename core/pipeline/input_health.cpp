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
  const auto stays = [this, &in](Lack lack, bool bad, double grace_ms) {
    return graceOf(lack).expired(bad, in.now, grace_ms);
  };
#define LACK(name, number, need, of, help, what, remedy, missing)                               \
  if (Need::need != Need::robot || now.needs_robot) {                                           \
    (Need::need == Need::rendering ? out.faults : out.lacks).set(std::size_t{number}, missing); \
  }
#include "core/pipeline/lack_list.h"
#undef LACK
  return out;
}

bool InputHealth::devicesLive(const Lacks& lacks) {
  return !(lacks.test(static_cast<std::size_t>(Lack::motors_stale)) &&
           lacks.test(static_cast<std::size_t>(Lack::ir_stale)) &&
           lacks.test(static_cast<std::size_t>(Lack::bridge_stale)));
}

Lack InputHealth::first(const Lacks& lacks) {
  for (const LackInfo& info : lacksByUrgency()) {
    if (lacks.test(static_cast<std::size_t>(info.lack))) return info.lack;
  }
  return Lack::none;
}

}  // namespace fyd::pipeline
