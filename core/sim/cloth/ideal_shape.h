// The cloth's shape as the estimator itself assumes it: for sim.cloth = ideal only. No other file of this module may
// include the estimator's membrane (tests/architecture).
#pragma once

#include "core/sensing/membrane.h"

namespace fyd::sim {

class IdealShape {
 public:
  [[nodiscard]] double at(double x_mm, double y_mm, double finger_x_mm, double finger_y_mm) const {
    return membrane_.shape(x_mm, y_mm, finger_x_mm, finger_y_mm);
  }

 private:
  sensing::Membrane membrane_;
};

}  // namespace fyd::sim
