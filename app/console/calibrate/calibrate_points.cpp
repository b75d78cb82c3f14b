#include "app/console/calibrate/calibrate_points.h"

#include <algorithm>

namespace fyd::console {

const std::vector<CalibrationPoint>& CalibrationPoints::of(int part) const {
  static const std::vector<CalibrationPoint> kNone;
  const auto found = parts_.find(part);
  return found == parts_.end() ? kNone : found->second.points;
}

PointOrigin CalibrationPoints::originOf(int part) const {
  const auto found = parts_.find(part);
  return found == parts_.end() ? PointOrigin::measured : found->second.origin;
}

bool CalibrationPoints::holdsSimulated(int part) const {
  return !of(part).empty() && originOf(part) == PointOrigin::simulated;
}

void CalibrationPoints::add(int part, CalibrationPoint point, PointOrigin origin) {
  Taken& taken = parts_[part];
  taken.points.push_back(std::move(point));
  taken.origin = std::max(taken.origin, origin);
}

void CalibrationPoints::takeBack(int part) {
  const auto found = parts_.find(part);
  if (found == parts_.end()) return;
  found->second.points.pop_back();
  if (found->second.points.empty()) parts_.erase(found);  // and where they came from
}

}  // namespace fyd::console
