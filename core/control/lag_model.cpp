#include "core/control/lag_model.h"

#include <algorithm>
#include <cmath>

namespace fyd::control {

void LagModel::configure(double delay_s, double lag_s) {
  cell_s_ = std::isfinite(delay_s) && delay_s > 0 ? delay_s / kCells : 0.0;
  lag_s_ = std::isfinite(lag_s) && lag_s > 0 ? lag_s : 0.0;
}

void LagModel::reset(double value) {
  if (!std::isfinite(value)) return;
  line_.fill(value);
  value_ = value;
  since_s_ = 0.0;
}

double LagModel::step(double value, double dt_s) {
  if (!std::isfinite(value) || !(dt_s > 0)) return value_;
  double delayed = value;
  if (cell_s_ > 0) {
    since_s_ = std::min(since_s_ + dt_s, cell_s_ * kCells);
    delayed = line_[next_];
    while (since_s_ >= cell_s_) {
      since_s_ -= cell_s_;
      delayed = line_[next_];
      line_[next_] = value;
      next_ = (next_ + 1) % kCells;
    }
  }
  value_ += (delayed - value_) * dt_s / (lag_s_ + dt_s);
  return value_;
}

}  // namespace fyd::control
