// The readiness list: what must hold before arming, in the operator's words.
#include "core/station/station_impl.h"

namespace fyd::station {

std::vector<ReadinessLine> Station::readiness() const {
  using pipeline::Part;
  struct Line {
    Part part;
    std::string_view what;
  };
  static constexpr std::array kLines = {
      Line{Part::motors, sentence("Motors answer")},
      Line{Part::distances, sentence("Distance sensors measure")},
      Line{Part::load_cell, sentence("Load cell measures")},
      Line{Part::camera, sentence("Camera sees")},
      Line{Part::robot, sentence("Robot connected")},
      Line{Part::target, sentence("Stiffness target known")},
  };
  const pipeline::Lacks lacks(impl_->lacks.load(std::memory_order_relaxed));
  std::vector<ReadinessLine> out;
  for (const Line& line : kLines) {
    if (line.part == Part::robot && !impl_->link) continue;
    ReadinessLine shown{.what = phrase(line.what), .ok = true};
    for (const pipeline::LackInfo& info : pipeline::lacksByUrgency()) {
      if (info.part != line.part || !lacks.test(static_cast<std::size_t>(info.lack))) continue;
      shown.ok = false;
      shown.why = phrase(info.what);
      shown.remedy = phrase(info.remedy);
      shown.lack = info.lack;
      break;
    }
    out.push_back(std::move(shown));
  }
  return out;
}

}  // namespace fyd::station
