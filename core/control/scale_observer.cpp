#include "core/control/scale_observer.h"

#include <algorithm>
#include <cmath>

namespace fyd::control {
namespace {

constexpr double kPriorVariance = 0.25 * 0.25;     // of s
constexpr double kNewTouchVariance = 0.05 * 0.05;  // added at each touch
constexpr double kWanderPerSqrt_s = 0.003;         // q: s drifts as a random walk
constexpr double kUnknownSigma = 0.07;             // of a reading that reports none; limits of what is reported follow
constexpr double kLeastSigma = 0.01;
constexpr double kMostSigma = 1.0;
// Lower bound of v, as a share of the reported variance, which includes errors that averaging cannot reduce.
constexpr double kLeastVarianceShare = 0.35;
constexpr double kMeanTime_s = 0.3;      // time constants: of the running mean of z,
constexpr double kVarianceTime_s = 0.4;  // of v,
constexpr double kMotionTime_s = 0.08;   // of the law's low-pass: the sensors' lag is not known better than this
constexpr double kMostLogScale = 1.5;    // 4.5 times off the calibration: a sensor fault
constexpr double kSignificantFrom = 2.8, kSignificantUntil = 1.0;  // σ, with hysteresis
constexpr double kFade_s = 0.15;                                   // of the correction, in and out

}  // namespace

void ScaleObserver::configure(double correlation_s) {
  if (correlation_s > 0 && std::isfinite(correlation_s)) correlation_s_ = correlation_s;
}

void ScaleObserver::reset() {
  log_scale_ = 0.0;
  variance_ = kPriorVariance;
  reading_variance_ = -1.0;
  slow_known_ = false;
  significant_ = false;
  fade_in_ = 0.0;
}

void ScaleObserver::beginTouch() {
  variance_ = std::max(variance_, std::min(variance_ + kNewTouchVariance, kPriorVariance));
  slow_known_ = false;
}

void ScaleObserver::step(double z, double relative_sigma, double law_log, double dt_s) {
  if (!std::isfinite(z) || !std::isfinite(law_log) || !(dt_s > 0) || !std::isfinite(dt_s)) return;
  const double reported = relative_sigma > 0 && std::isfinite(relative_sigma)
                              ? std::clamp(relative_sigma, kLeastSigma, kMostSigma)
                              : kUnknownSigma;
  const double reading = std::clamp(z, -kMostLogScale, kMostLogScale);
  if (reading_variance_ < 0) {
    reading_variance_ = std::min(reported * reported, kUnknownSigma * kUnknownSigma);
    mean_z_ = reading;
  }
  mean_z_ += (reading - mean_z_) * dt_s / (kMeanTime_s + dt_s);
  // The mean follows correlated noise, which makes the scatter about it too small: the factor corrects for that, and a
  // share of the reported variance is the lower bound.
  const double off = reading - mean_z_;
  const double scatter = off * off * (kMeanTime_s + correlation_s_) / kMeanTime_s;
  reading_variance_ += (scatter - reading_variance_) * dt_s / (kVarianceTime_s + dt_s);
  const double variance = std::max(reading_variance_, kLeastVarianceShare * reported * reported);

  if (!slow_known_) slow_law_log_ = law_log;
  slow_known_ = true;
  slow_law_log_ += (law_log - slow_law_log_) * dt_s / (kMotionTime_s + dt_s);
  const double motion = law_log - slow_law_log_;

  const double density = 2 * correlation_s_ * (variance + motion * motion);  // r
  // Exact for a constant r over dt: inverse variances add.
  const double share = variance_ * dt_s / (density + variance_ * dt_s);
  log_scale_ += share * (reading - log_scale_);
  variance_ = std::min((1 - share) * variance_ + kWanderPerSqrt_s * kWanderPerSqrt_s * dt_s, kPriorVariance);
  significant_ = std::abs(log_scale_) > sigma() * (significant_ ? kSignificantUntil : kSignificantFrom);
  fade_in_ = std::clamp(fade_in_ + (significant_ ? dt_s : -dt_s) / kFade_s, 0.0, 1.0);
}

double ScaleObserver::sigma() const { return std::sqrt(variance_); }

}  // namespace fyd::control
