// The finger's speed from successive centroids.
//
//   raw = |p_n − p_(n−1)| / (t_n − t_(n−1)),   speed_n = 0.5·speed_(n−1) + 0.5·raw
//
// Pictures come at 10 to 30 Hz, so the speed is held between them, and falls to zero linearly from 100 ms to 200 ms
// after the last picture (a finger whose pictures stopped is not known to move). The first picture of a touch gives 0.
// Stability: may change
#pragma once

#include "core/base/api.h"
#include "core/base/time.h"

namespace fyd::texture {

class FYD_API FingerSpeed {
 public:
  /// A new picture's centroid, in mm. Not finite, or not later than the last one: ignored.
  void observe(double x_mm, double y_mm, Instant taken);
  /// The finger left the cloth.
  void lift();
  /// mm/s, finite, ≥ 0, at most kFastest_mm_s.
  [[nodiscard]] double at(Instant now) const;

  /// No hand strokes a 10 cm cloth faster; a larger value is a jump of the detector.
  static constexpr double kFastest_mm_s = 1000.0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(seen_, x_mm_, y_mm_, taken_, speed_mm_s_);
  }

 private:
  bool seen_ = false;
  double x_mm_ = 0.0;
  double y_mm_ = 0.0;
  Instant taken_{};
  double speed_mm_s_ = 0.0;
};

}  // namespace fyd::texture
