#include "core/teleop/prediction/smooth_output.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace fyd::teleop {
namespace {

bool finite(const Position& p) {
  return std::ranges::all_of(p, [](double x) { return std::isfinite(x); });
}

constexpr double kShortest_s = 0.015, kPeriodOffset_s = 0.010;
constexpr double kLongest_s = 0.055, kLongestPerDelay = 0.15, kLargestDelay_s = 0.5;

}  // namespace

double defaultSmoothing_s(double period_s, double delay_s) {
  const double most_s =
      kLongest_s + kLongestPerDelay * std::clamp(std::isfinite(delay_s) ? delay_s : 0.0, 0.0, kLargestDelay_s);
  return std::min(kShortest_s + std::max(0.0, period_s - kPeriodOffset_s), most_s);
}

Position SmoothOutput::step(double time_s, const Position& predicted_mm, const Position& velocity_mm_per_s) {
  if (!std::isfinite(time_s) || !finite(predicted_mm) || !finite(velocity_mm_per_s)) return position_mm_;
  const double dt = begun_ ? std::max(0.0, time_s - time_s_) : 0.0;
  time_s_ = time_s;
  if (!begun_ || !(tau_s_ > 0.0)) {
    begun_ = true;
    position_mm_ = predicted_mm;
    velocity_mm_per_s_ = velocity_mm_per_s;
    return position_mm_;
  }
  const double decay = math::exp(-dt / tau_s_);
  for (std::size_t a = 0; a < kMostAxes; ++a) {
    const double error = position_mm_[a] - (predicted_mm[a] - velocity_mm_per_s[a] * dt);
    const double error_velocity = velocity_mm_per_s_[a] - velocity_mm_per_s[a];
    const double error_slope = error_velocity + error / tau_s_;  // e(t) = (error + error_slope·t)·exp(−t/τ)
    position_mm_[a] = predicted_mm[a] + (error + error_slope * dt) * decay;
    velocity_mm_per_s_[a] = velocity_mm_per_s[a] + (error_slope - (error + error_slope * dt) / tau_s_) * decay;
  }
  return position_mm_;
}

}  // namespace fyd::teleop
