#include "core/teleop/prediction/kalman_predictor.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"
#include "core/teleop/prediction/motion_history.h"

namespace fyd::teleop {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

constexpr double kTau = KalmanPredictor::kAccelerationTimeConstant_s;
constexpr double kInitialVelocity_mm_per_s = 100.0;

struct Transition {
  double decay;           // e^(−t/τ): acceleration to acceleration
  double a_to_v, a_to_x;  // its integral and double integral: to velocity and position
};

Transition transition(double t) {
  const double decay = math::exp(-t / kTau);
  return {decay, kTau * (1.0 - decay), kTau * (t - kTau * (1.0 - decay))};
}

/// Adds the process noise over t: three-point Gauss-Legendre quadrature over the moments at which the noise acts, exact
/// enough for steps of a few τ, and positive semidefinite for any t.
void addNoise(Matrix& p, double t) {
  constexpr double kNoiseDensity =
      2.0 * KalmanPredictor::kAccelerationRms_mm_per_s2 * KalmanPredictor::kAccelerationRms_mm_per_s2 / kTau;
  constexpr std::array<double, 3> kAbscissae = {0.1127016653792583, 0.5, 0.8872983346207417};
  constexpr std::array<double, 3> kWeights = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  for (std::size_t i = 0; i < kAbscissae.size(); ++i) {
    const Transition f = transition(t * kAbscissae[i]);
    const std::array<double, 3> effect = {f.a_to_x, f.a_to_v, f.decay};
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) p[r][c] += kNoiseDensity * t * kWeights[i] * effect[r] * effect[c];
    }
  }
}

}  // namespace

KalmanPredictor::State KalmanPredictor::stateAfter(double by_s) const {
  const double t = std::clamp(by_s, 0.0, kSilence_s);
  const Transition f = transition(t);
  State out = state_;
  for (std::size_t i = 0; i < kMostAxes; ++i) {
    out.x[i] += state_.v[i] * t + state_.a[i] * f.a_to_x;
    out.v[i] += state_.a[i] * f.a_to_v;
    out.a[i] *= f.decay;
  }
  return out;
}

void KalmanPredictor::message(double date_s, const Position& position_mm) {
  if (!MotionHistory::valid(date_s, position_mm)) return;
  if (!begun_ || date_s - date_s_ > kSilence_s) {
    begun_ = true;
    state_ = {.x = position_mm, .v = {}, .a = {}};
    covariance_ = {};
    covariance_[0][0] = math::square(kPositionNoise_mm);
    covariance_[1][1] = math::square(kInitialVelocity_mm_per_s);
    covariance_[2][2] = math::square(kAccelerationRms_mm_per_s2);
    date_s_ = date_s;
    return;
  }
  const double t = date_s - date_s_;
  if (!(t > 0.0)) return;
  state_ = stateAfter(t);
  date_s_ = date_s;
  const Transition f = transition(t);
  const Matrix step = {{{1.0, t, f.a_to_x}, {0.0, 1.0, f.a_to_v}, {0.0, 0.0, f.decay}}};
  Matrix half{}, p{};
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k) half[r][c] += step[r][k] * covariance_[k][c];
    }
  }
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t k = 0; k < 3; ++k) p[r][c] += half[r][k] * step[c][k];
    }
  }
  addNoise(p, t);
  const double innovation_variance = p[0][0] + math::square(kPositionNoise_mm);
  const std::array<double, 3> gain = {p[0][0] / innovation_variance, p[1][0] / innovation_variance,
                                      p[2][0] / innovation_variance};
  for (std::size_t i = 0; i < kMostAxes; ++i) {
    const double error = position_mm[i] - state_.x[i];
    state_.x[i] += gain[0] * error;
    state_.v[i] += gain[1] * error;
    state_.a[i] += gain[2] * error;
  }
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) covariance_[r][c] = p[r][c] - gain[r] * p[0][c];
  }
}

Position KalmanPredictor::predict(double time_s) {
  if (!begun_) return {};
  Position out = stateAfter(time_s - date_s_).x;
  for (std::size_t i = 0; i < kMostAxes; ++i) {
    if (!std::isfinite(out[i])) out[i] = state_.x[i];
  }
  return out;
}

Position KalmanPredictor::velocity(double time_s) const {
  const double age_s = time_s - date_s_;
  if (!begun_ || !(age_s >= 0.0 && age_s <= kSilence_s)) return {};  // the prediction is held there
  Position out = stateAfter(age_s).v;
  for (double& each : out) each = std::isfinite(each) ? each : 0.0;
  return out;
}

}  // namespace fyd::teleop
