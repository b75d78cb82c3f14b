#include "core/station/readiness.h"

namespace fyd::station {

std::vector<ReadinessLine> readinessOf(const pipeline::FaultSet& faults, bool has_robot) {
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
  std::vector<ReadinessLine> out;
  for (const Line& line : kLines) {
    if (line.part == Part::robot && !has_robot) continue;
    ReadinessLine shown{.what = phrase(line.what), .ok = true};
    for (const pipeline::FaultInfo& info : pipeline::faultsByUrgency()) {
      if (info.part != line.part || !faults.test(static_cast<std::size_t>(info.fault))) continue;
      shown.ok = false;
      shown.why = phrase(info.what);
      shown.remedy = phrase(info.remedy);
      shown.fault = info.fault;
      break;
    }
    out.push_back(std::move(shown));
  }
  return out;
}

}  // namespace fyd::station
