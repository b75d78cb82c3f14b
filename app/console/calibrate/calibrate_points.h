// The points that were taken of each part, until they are accepted or discarded.
#pragma once

#include <map>
#include <vector>

#include "app/console/calibrate/calibrate_step.h"

namespace fyd::console {

/// Where points come from, from the most to the least trusted.
enum class PointOrigin : std::uint8_t {
  measured,
  measured_on_simulation,  ///< readings of the simulated touchpad
  simulated,               ///< the simulator's own truth, without a reading
};

class CalibrationPoints {
 public:
  /// @param part index of its step
  [[nodiscard]] const std::vector<CalibrationPoint>& of(int part) const;
  /// Of the least trusted of its points; `measured`: it has none.
  [[nodiscard]] PointOrigin originOf(int part) const;
  /// Whether `part` holds points, and these are `simulated`.
  [[nodiscard]] bool holdsSimulated(int part) const;
  void add(int part, CalibrationPoint point, PointOrigin origin);
  void takeBack(int part);
  void clear(int part) { parts_.erase(part); }
  void clear() { parts_.clear(); }

 private:
  struct Taken {
    std::vector<CalibrationPoint> points;
    PointOrigin origin = PointOrigin::measured;
  };
  std::map<int, Taken> parts_;
};

}  // namespace fyd::console
