#include "core/teleop/prediction/gesture_filter.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace fyd::teleop {

Position EmissionFilter::step(double time_s, const Position& position_mm) {
  if (history_.insert(time_s, position_mm) != MotionHistory::Insertion::newest) return last_mm_;
  last_mm_ = position_mm;
  if (!(window_s_ > 0.0)) return last_mm_;
  double n = 0.0, sum_t = 0.0, sum_tt = 0.0;
  Position sum_x{}, sum_tx{};
  for (std::size_t i = 0; i < history_.size(); ++i) {
    const DatedPosition& each = history_.back(i);
    const double t = each.date_s - time_s;
    if (-t > window_s_) break;
    n += 1.0;
    sum_t += t;
    sum_tt += t * t;
    for (std::size_t a = 0; a < kMostAxes; ++a) {
      sum_x[a] += each.position_mm[a] - position_mm[a];
      sum_tx[a] += t * (each.position_mm[a] - position_mm[a]);
    }
  }
  const double spread = n * sum_tt - sum_t * sum_t;
  if (!(spread > 0.0)) return last_mm_;
  for (std::size_t a = 0; a < kMostAxes; ++a) {  // the line at t = 0
    last_mm_[a] = position_mm[a] + (sum_tt * sum_x[a] - sum_t * sum_tx[a]) / spread;
  }
  return last_mm_;
}

std::optional<Position> ReceptionFilter::step(double time_s) {
  if (history_.empty() || !std::isfinite(time_s)) return std::nullopt;
  const Position target = history_.at(time_s - hold_s_);
  const double dt = begun_ ? std::max(0.0, time_s - time_s_) : 0.0;
  time_s_ = time_s;
  if (!begun_ || !(tau_s_ > 0.0)) {
    begun_ = true;
    position_mm_ = target_mm_ = target;
    return position_mm_;
  }
  if (dt > 0.0) {
    // The low-passed speed as feed-forward, and the remaining distance closed as by a first-order system: a motion at
    // constant speed is passed on without lag.
    const double share = 1.0 - math::exp(-dt / tau_s_);
    for (std::size_t a = 0; a < kMostAxes; ++a) {
      speed_mm_per_s_[a] += share * ((target[a] - target_mm_[a]) / dt - speed_mm_per_s_[a]);
      position_mm_[a] += speed_mm_per_s_[a] * dt;
      position_mm_[a] += 0.5 * share * (target[a] - position_mm_[a]);
    }
    target_mm_ = target;
  }
  return position_mm_;
}

void ReceptionFilter::reset() {
  history_.clear();
  begun_ = false;
  speed_mm_per_s_ = {};
}

}  // namespace fyd::teleop
