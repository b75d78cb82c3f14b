#include "core/teleop/prediction/plain_predictors.h"

#include <algorithm>
#include <cmath>

namespace fyd::teleop {

namespace {

constexpr double kSameDate_s = 1e-6;  // doubles resolve dates of 1e9 s to 1e-7 s

}  // namespace

Position newestSlope(const MotionHistory& history, double window_s) {
  if (history.size() < 2) return {};
  const DatedPosition& newest = history.newest();
  const double longest_s = window_s + kSameDate_s;
  std::size_t count = 0;
  double sum_t = 0.0, sum_tt = 0.0;
  Position sum_x{}, sum_tx{};
  for (; count < history.size(); ++count) {
    const DatedPosition& each = history.back(count);
    const double t = each.date_s - newest.date_s;
    if (-t > longest_s) break;
    sum_t += t;
    sum_tt += t * t;
    for (std::size_t a = 0; a < kMostAxes; ++a) {
      const double x = each.position_mm[a] - newest.position_mm[a];
      sum_x[a] += x;
      sum_tx[a] += t * x;
    }
  }
  const double n = static_cast<double>(count);
  const double spread = sum_tt - sum_t * sum_t / n;
  Position slope{};
  if (!(spread > 0.0)) return slope;
  for (std::size_t a = 0; a < kMostAxes; ++a) {
    const double each = (sum_tx[a] - sum_t * sum_x[a] / n) / spread;
    if (std::isfinite(each)) slope[a] = each;
  }
  return slope;
}

double newestSpacing(const MotionHistory& history) {
  return history.size() < 2 ? 0.0 : history.newest().date_s - history.back(1).date_s;
}

void PlainPredictor::message(double date_s, const Position& position_mm) {
  if (!MotionHistory::valid(date_s, position_mm)) return;
  if (!history_.empty() && date_s - history_.newest().date_s > kSilence_s) endMotion();
  if (history_.insert(date_s, position_mm) == MotionHistory::Insertion::refused || slope_factor_ == 0.0) return;
  const double period_s = period_s_ > 0.0 ? period_s_ : newestSpacing(history_);
  slope_mm_per_s_ = newestSlope(history_, std::max(kSlopeWindow_s, period_s));
}

Position PlainPredictor::predict(double time_s) {
  if (history_.empty()) return {};
  const DatedPosition& newest = history_.newest();
  Position out = newest.position_mm;
  for (std::size_t a = 0; a < kMostAxes; ++a) {
    const double moved = out[a] + slope_factor_ * slope_mm_per_s_[a] * (time_s - newest.date_s);
    if (std::isfinite(moved)) out[a] = moved;
  }
  return out;
}

Position PlainPredictor::velocity(double) const {
  Position out = slope_mm_per_s_;
  for (double& each : out) each *= slope_factor_;
  return out;
}

void PlainPredictor::endMotion() {
  history_.clear();
  slope_mm_per_s_ = {};
}

}  // namespace fyd::teleop
