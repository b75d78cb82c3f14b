#include "core/sensing/stiffness_estimator.h"

#include <algorithm>
#include <cmath>

#include "core/base/message.h"
#include "core/base/portable_math.h"

namespace fyd::sensing {
namespace {

constexpr double kStart_N_per_mm = 0.6;  // middle of the device's range
constexpr double kStartSigma_N_per_mm = 1.0;
constexpr double kLongestStep_s = 1.0;
constexpr double kHuber = 3.0;             // standard deviations beyond which a sample weighs less
constexpr double kLargestTareError = 4.0;  // standard deviations
constexpr double kLargestForce_N = 1e3;
constexpr double kLargestIndentation_mm = 1e3;

}  // namespace

std::string_view toString(StiffnessReason reason) {
  switch (reason) {
    case StiffnessReason::observed: return sentence("observed");
    case StiffnessReason::untouched: return sentence("untouched");
    case StiffnessReason::indentation_unavailable: return sentence("indentation unavailable");
    case StiffnessReason::force_unavailable: return sentence("force unavailable");
    case StiffnessReason::indentation_too_small: return sentence("indentation too small");
    case StiffnessReason::force_too_small: return sentence("force too small");
    case StiffnessReason::uncertain: return sentence("too uncertain");
  }
  return sentence("unknown");
}

StiffnessEstimator::StiffnessEstimator(const StiffnessParameters& parameters) : parameters_(parameters) { reset(); }

void StiffnessEstimator::configure(const StiffnessParameters& parameters) {
  const bool mode_changed = parameters.mode != parameters_.mode;
  parameters_ = parameters;
  if (mode_changed) restart();
}

void StiffnessEstimator::setMaximumAge(Duration force) { maximum_age_ = force; }

void StiffnessEstimator::reset() {
  estimate_ = {};
  restart();
}

void StiffnessEstimator::restart() {
  slope_ = estimate_.known ? estimate_.stiffness_N_per_mm : kStart_N_per_mm;
  intercept_ = 0.0;
  slope_variance_ = kStartSigma_N_per_mm * kStartSigma_N_per_mm;
  covariance_ = 0.0;
  intercept_variance_ = parameters_.tare_sigma_N * parameters_.tare_sigma_N;
  started_ = false;
}

StiffnessEstimate StiffnessEstimator::step(Instant now, const Timed<double>& force_N,
                                           const IndentationEstimate& indentation) {
  estimate_.observable = false;
  const bool finite = std::isfinite(indentation.indentation_mm) && std::isfinite(indentation.sigma_mm);
  if (indentation.available && !indentation.touched) {
    restart();
    estimate_.reason = StiffnessReason::untouched;
  } else if (!indentation.available || !finite) {
    estimate_.reason = StiffnessReason::indentation_unavailable;
  } else if (force_N.freshness(now, maximum_age_) != Freshness::fresh || !(std::abs(force_N.value) < kLargestForce_N)) {
    estimate_.reason = StiffnessReason::force_unavailable;
  } else if (!(indentation.indentation_mm >= parameters_.minimum_indentation_mm)) {
    estimate_.reason = StiffnessReason::indentation_too_small;
  } else if (!(force_N.value >= parameters_.minimum_force_N)) {
    estimate_.reason = StiffnessReason::force_too_small;
  } else {
    observe(force_N, indentation);
  }
  return estimate_;
}

void StiffnessEstimator::observe(const Timed<double>& force_N, const IndentationEstimate& indentation) {
  const double depth = std::min(indentation.indentation_mm, kLargestIndentation_mm);
  const double depth_part = std::min(indentation.sigma_mm, kLargestIndentation_mm) / depth;
  double value = 0.0;
  double variance = 0.0;
  if (parameters_.mode == StiffnessMode::thesis) {
    value = force_N.value / depth;
    variance = math::square(parameters_.force_noise_N / depth);
  } else {
    if (!started_ || force_N.count != last_force_) {
      learn(started_ ? toSeconds(force_N.taken - last_learned_) : 0.0, force_N.value, depth, indentation.sigma_mm);
      last_learned_ = force_N.taken;
      last_force_ = force_N.count;
      started_ = true;
    }
    value = slope_;
    variance = slope_variance_;
  }
  value = std::clamp(value, 0.0, kLargest_N_per_mm);
  const double sigma = std::min(std::sqrt(variance + math::square(value * depth_part)), kLargest_N_per_mm);
  if (parameters_.mode == StiffnessMode::slope && sigma > parameters_.relative_sigma_limit * value) {
    estimate_.reason = StiffnessReason::uncertain;
    return;
  }
  estimate_ = {.stiffness_N_per_mm = value,
               .sigma_N_per_mm = sigma,
               .known = true,
               .observable = true,
               .reason = StiffnessReason::observed};
}

void StiffnessEstimator::learn(double dt_s, double force_N, double depth_mm, double depth_sigma_mm) {
  const double pace = parameters_.pace_N_per_mm_per_sqrt_s;
  slope_variance_ = std::min(slope_variance_ + pace * pace * std::clamp(dt_s, 0.0, kLongestStep_s),
                             kStartSigma_N_per_mm * kStartSigma_N_per_mm);

  const double from_depth = slope_ * depth_sigma_mm;
  double noise = parameters_.force_noise_N * parameters_.force_noise_N + from_depth * from_depth;
  const double innovation = force_N - slope_ * depth_mm - intercept_;
  // P·Hᵀ and H·P·Hᵀ for H = (δ, 1)
  const double to_slope = slope_variance_ * depth_mm + covariance_;
  const double to_intercept = covariance_ * depth_mm + intercept_variance_;
  const double predicted = to_slope * depth_mm + to_intercept;
  const double deviations = std::abs(innovation) / std::sqrt(predicted + noise);
  if (deviations > kHuber) noise = (predicted + noise) * (deviations / kHuber) - predicted;

  const double total = predicted + noise;
  const double gain_slope = to_slope / total;
  const double gain_intercept = to_intercept / total;
  slope_ = std::clamp(slope_ + gain_slope * innovation, 0.0, kLargest_N_per_mm);
  const double furthest = kLargestTareError * parameters_.tare_sigma_N;
  intercept_ = std::clamp(intercept_ + gain_intercept * innovation, -furthest, furthest);
  slope_variance_ = std::max(slope_variance_ - gain_slope * to_slope, 1e-12);
  intercept_variance_ = std::max(intercept_variance_ - gain_intercept * to_intercept, 0.0);
  const double bound = std::sqrt(slope_variance_ * intercept_variance_);
  covariance_ = std::clamp(covariance_ - gain_slope * to_intercept, -bound, bound);
}

}  // namespace fyd::sensing
