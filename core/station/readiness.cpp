// The readiness list: what must hold before arming, in the operator's words.
#include "core/station/station_impl.h"

namespace fyd::station {

std::vector<ReadinessLine> Station::readiness() const {
  using pipeline::Lack;
  struct Line {
    const char* what;
    std::vector<Lack> lacks;
    bool of_robot = false;  // left out when none is wanted
  };
  static const std::vector<Line> kLines = {
      {"Motors answer", {Lack::motors_stale}},
      {"Distance sensors measure", {Lack::ir_stale, Lack::ir_invalid}},
      {"Load cell measures", {Lack::bridge_stale, Lack::bridge_invalid}},
      {"Camera sees", {Lack::camera_stale, Lack::camera_blind}},
      {"Robot connected", {Lack::robot_waiting, Lack::robot_lost, Lack::robot_closed, Lack::robot_frozen}, true},
      {"Stiffness target known", {Lack::no_target}},
  };
  const pipeline::Lacks lacks(impl_->lacks.load(std::memory_order_relaxed));
  std::vector<ReadinessLine> out;
  for (const Line& line : kLines) {
    if (line.of_robot && !impl_->link) continue;
    ReadinessLine shown{.what = line.what, .ok = true};
    for (const Lack lack : line.lacks) {
      if (!lacks.test(static_cast<std::size_t>(lack)) || !shown.ok) continue;
      shown.ok = false;
      shown.why = pipeline::toString(lack);
      shown.remedy = pipeline::remedy(lack);
      shown.lack = lack;
    }
    out.push_back(std::move(shown));
  }
  return out;
}

}  // namespace fyd::station
