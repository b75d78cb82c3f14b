#include "core/teleop/coupling/surface_estimator.h"

#include <algorithm>
#include <cmath>

#include "core/teleop/coupling/coupling.h"

namespace fyd::teleop {
namespace {

constexpr double kMost_N = 1e4;         // of a measurement
constexpr double kSmoothing = 0.1;      // the same for position and force, so that their relation stays
constexpr double kSlow_m_per_s = 0.06;  // above this speed damping and inertia contribute too
constexpr double kDistinct_m = 2e-5, kDistinct_N = 0.03;
constexpr double kLeastSpeeds = 1e-6;  // (m/s)²: with a smaller variance of the speed no damping is estimated
constexpr std::size_t kLeastPoints = 8;
constexpr double kLeastSpread_N = 0.15;
constexpr double kMisfit_N = 0.4, kMisfit = 0.15;
constexpr int kMisfitSteps = 60;
constexpr int kAirSteps = 30;

}  // namespace

void SurfaceEstimator::step(double position_m, double velocity_m_per_s, double force_N) {
  const bool sound = std::abs(position_m) <= kFurthest_m && std::abs(velocity_m_per_s) <= kFastest_m_per_s &&
                     std::abs(force_N) <= kMost_N;
  if (!sound) return;
  if (!smoothing_) {
    smoothing_ = true;
    smooth_m_ = position_m;
    smooth_m_per_s_ = velocity_m_per_s;
    smooth_N_ = force_N;
  }
  smooth_m_ += kSmoothing * (position_m - smooth_m_);
  smooth_m_per_s_ += kSmoothing * (velocity_m_per_s - smooth_m_per_s_);
  smooth_N_ += kSmoothing * (force_N - smooth_N_);
  touching_ = smooth_N_ > (touching_ ? kNoContact_N : kContact_N);
  if (!touching_) {
    misfit_steps_ = 0;
    air_steps_ = known_ && smooth_m_ > surface_m_ + kBeyond_m + kContact_N / stiffness_ ? air_steps_ + 1 : 0;
    if (air_steps_ >= kAirSteps) {
      known_ = false;
      count_ = next_ = 0;
    }
    return;
  }
  air_steps_ = 0;
  if (std::abs(velocity_m_per_s) > kSlow_m_per_s) return;
  if (known_) {
    const double misfit_N = std::abs(smooth_N_ - stiffness_ * (smooth_m_ - surface_m_));
    misfit_steps_ = misfit_N > std::max(kMisfit_N, kMisfit * smooth_N_) ? misfit_steps_ + 1 : 0;
    if (misfit_steps_ >= kMisfitSteps) {
      misfit_steps_ = 0;
      count_ = next_ = 0;
      surface_m_ = smooth_m_ - smooth_N_ / stiffness_;
    }
  }
  if (smooth_N_ < kContact_N) return;
  const Point& last = points_[(next_ + kPoints - 1) % kPoints];
  const bool same = count_ > 0 && (std::abs(last.position_m - smooth_m_) < kDistinct_m ||
                                   std::abs(last.force_N - smooth_N_) < kDistinct_N);
  if (same) return;
  points_[next_] = {smooth_m_, smooth_m_per_s_, smooth_N_};
  next_ = (next_ + 1) % kPoints;
  count_ = std::min(count_ + 1, kPoints);
  fit();
}

void SurfaceEstimator::fit() {
  if (count_ < kLeastPoints) return;
  double x = 0.0, v = 0.0, f = 0.0, least = points_[0].force_N, most = least;
  for (std::size_t i = 0; i < count_; ++i) {
    x += points_[i].position_m;
    v += points_[i].velocity_m_per_s;
    f += points_[i].force_N;
    least = std::min(least, points_[i].force_N);
    most = std::max(most, points_[i].force_N);
  }
  if (most - least < kLeastSpread_N) return;
  const double n = static_cast<double>(count_);
  x /= n;
  v /= n;
  f /= n;
  double xx = 0.0, xv = 0.0, vv = kLeastSpeeds * n, xf = 0.0, vf = 0.0;
  for (std::size_t i = 0; i < count_; ++i) {
    const double dx = points_[i].position_m - x, dv = points_[i].velocity_m_per_s - v, df = points_[i].force_N - f;
    xx += dx * dx;
    xv += dx * dv;
    vv += dv * dv;
    xf += dx * df;
    vf += dv * df;
  }
  const double determinant = xx * vv - xv * xv;
  if (!(determinant > 0.0)) return;
  const double stiffness = (xf * vv - vf * xv) / determinant;
  const double damping = (vf * xx - xf * xv) / determinant;
  if (!(stiffness > 0.0)) return;
  stiffness_ = std::clamp(stiffness, kLeast_N_per_m, kMost_N_per_m);
  surface_m_ = x - (f - damping * v) / stiffness_;
  known_ = true;
}

}  // namespace fyd::teleop
