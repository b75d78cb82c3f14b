#include "core/control/cloth_identification.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/portable_math.h"
#include "core/control/lag_model.h"
#include "core/control/static_law.h"

namespace fyd::control {
namespace {

constexpr std::size_t kFewestSamples = 100;
constexpr double kShortest_s = 2.0;
constexpr double kLeastExcitation = 0.05;  // relative change of the law's stiffness
constexpr double kLeastExplained = 0.5;    // share of the variance
constexpr double kLongestDelay_s = 0.4;
constexpr double kLongestLag_s = 2.0;
constexpr double kShortestCorrelation_s = 0.02, kLongestCorrelation_s = 2.0;
constexpr double kGridStep_s = 0.01;  // samples closer than this are thinned out

struct Point {
  double dt_s;
  double law_log;
  double measured_log;  // NaN while not observable
};

struct Fit {
  double delay_s = 0.0, lag_s = 0.0;
  double log_scale = 0.0, gain = 1.0;
  double residual = std::numeric_limits<double>::infinity();  // mean square
  double variance = 0.0;                                      // of what was measured
};

Fit fitAt(std::span<const Point> points, double delay_s, double lag_s) {
  LagModel model;
  model.configure(delay_s, lag_s);
  model.reset(points.front().law_log);
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
  for (const Point& point : points) {
    const double x = model.step(point.law_log, point.dt_s);
    const double y = point.measured_log;
    if (std::isnan(y)) continue;
    n += 1;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
    syy += y * y;
  }
  const double vxx = sxx / n - sx * sx / (n * n), vxy = sxy / n - sx * sy / (n * n);
  Fit fit{delay_s, lag_s};
  fit.variance = std::max(0.0, syy / n - sy * sy / (n * n));
  if (!(vxx > 1e-9)) return fit;
  fit.gain = vxy / vxx;
  fit.log_scale = (sy - fit.gain * sx) / n;
  fit.residual = std::max(0.0, fit.variance - fit.gain * vxy);
  return fit;
}

Fit search(std::span<const Point> points) {
  constexpr std::array kLags = {0.0, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.45, 0.7, 1.0, 1.5, kLongestLag_s};
  Fit best;
  const auto consider = [&](double delay_s, double lag_s) {
    const Fit fit = fitAt(points, std::clamp(delay_s, 0.0, kLongestDelay_s), std::clamp(lag_s, 0.0, kLongestLag_s));
    if (fit.residual < best.residual) best = fit;
  };
  constexpr int kDelays = 10;  // counted, so that the longest is among them
  for (int i = 0; i <= kDelays; ++i) {
    for (const double lag_s : kLags) consider(kLongestDelay_s * i / kDelays, lag_s);
  }
  double delay_step_s = 0.02, lag_step_s = std::max(0.02, 0.25 * best.lag_s);
  for (int round = 0; round < 5; ++round) {
    const Fit centre = best;
    for (const int i : {-1, 0, 1}) {
      for (const int j : {-1, 0, 1}) consider(centre.delay_s + i * delay_step_s, centre.lag_s + j * lag_step_s);
    }
    delay_step_s /= 2;
    lag_step_s /= 2;
  }
  return best;
}

/// Integral of the residual's autocorrelation, up to where it first falls below 5 % or the integral reaches the longest
/// that counts.
double correlation_s(std::span<const Point> points, const Fit& fit) {
  LagModel model;
  model.configure(fit.delay_s, fit.lag_s);
  model.reset(points.front().law_log);
  std::vector<double> residual;
  double length_s = 0.0;
  for (const Point& point : points) {
    const double x = model.step(point.law_log, point.dt_s);
    if (std::isnan(point.measured_log)) continue;
    residual.push_back(point.measured_log - fit.log_scale - fit.gain * x);
    length_s += point.dt_s;
  }
  const double step_s = length_s / static_cast<double>(residual.size());
  const auto covariance = [&residual](std::size_t lag) {
    double sum = 0.0;
    for (std::size_t i = lag; i < residual.size(); ++i) sum += residual[i] * residual[i - lag];
    return sum / static_cast<double>(residual.size() - lag);
  };
  const double variance = covariance(0);
  double correlation = 0.5 * step_s;
  for (std::size_t lag = 1; lag < residual.size() / 4; ++lag) {
    const double share = variance > 0 ? covariance(lag) / variance : 0.0;
    if (share < 0.05 || correlation >= kLongestCorrelation_s) break;
    correlation += share * step_s;
  }
  return std::clamp(correlation, kShortestCorrelation_s, kLongestCorrelation_s);
}

}  // namespace

double excitationAngle_deg(double time_s, const ControlParameters& p) {
  // Shares of the travel, 2 s each: steps of different size both ways, so that dead time and lag can be told apart.
  constexpr std::array kStairs = {0.25, 0.75, 0.40, 0.65, 0.30, 0.55};
  constexpr double kStair_s = kExcitation_s / static_cast<double>(kStairs.size());
  StaticLaw law(p);
  law.limitTravel(p.travel_minimum_deg, p.travel_maximum_deg);
  const double low = law.minimumAngle_deg();
  const double span = law.maximumAngle_deg() - low;
  // A stair that is not climbed when the next begins would be jumped: slow motors climb lower ones about the middle.
  constexpr double kHighestStep = 0.5;  // between neighbours of kStairs
  const double rate = p.rate_limit_deg_per_s / 3;
  const double part = std::min(1.0, rate * kStair_s / (kHighestStep * span));
  const auto stairAt = [&](std::size_t i) { return low + (0.5 + part * (kStairs[i] - 0.5)) * span; };
  if (!(time_s >= 0) || !std::isfinite(time_s)) return stairAt(0);
  const double within = std::fmod(time_s, kExcitation_s);
  const auto stair = std::min(static_cast<std::size_t>(within / kStair_s), kStairs.size() - 1);
  const double from = stairAt((stair + kStairs.size() - 1) % kStairs.size());
  const double to = stairAt(stair);
  if (time_s < kStair_s) return to;  // the very first stair has none before it
  const double travelled = rate * (within - static_cast<double>(stair) * kStair_s);
  return from + std::clamp(to - from, -travelled, travelled);
}

Result<IdentifiedCloth> identifyCloth(std::span<const TuneSample> recording, const ControlParameters& parameters) {
  const StaticLaw law(parameters);
  std::vector<Point> points;
  std::size_t observed = 0;
  double least_deg = std::numeric_limits<double>::infinity(), most_deg = -least_deg, last_s = 0.0;
  for (const TuneSample& sample : recording) {
    if (!std::isfinite(sample.time_s) || !std::isfinite(sample.angle_deg)) {
      return fail("excitation at {} s: angle {}°; expected numbers", sample.time_s, sample.angle_deg);
    }
    if (!points.empty() && sample.time_s <= last_s) {
      if (sample.time_s == last_s) continue;
      return fail("excitation: {} s after {} s; expected time to rise", sample.time_s, last_s);
    }
    if (!points.empty() && sample.time_s - last_s < kGridStep_s) continue;
    const bool seen = std::isfinite(sample.stiffness_N_per_mm) && sample.stiffness_N_per_mm > 0;
    points.push_back({points.empty() ? kGridStep_s : sample.time_s - last_s,
                      math::log(law.stiffness_N_per_mm(sample.angle_deg).value),
                      seen ? math::log(sample.stiffness_N_per_mm) : std::numeric_limits<double>::quiet_NaN()});
    observed += seen ? 1 : 0;
    least_deg = std::min(least_deg, sample.angle_deg);
    most_deg = std::max(most_deg, sample.angle_deg);
    last_s = sample.time_s;
  }
  const double length_s = points.empty() ? 0.0 : last_s - recording.front().time_s;
  if (observed < kFewestSamples || length_s < kShortest_s) {
    return fail("excitation: stiffness observable in {} samples over {:.2f} s; expected at least {} over {} s",
                observed, length_s, kFewestSamples, kShortest_s);
  }
  const double least_k = law.stiffness_N_per_mm(least_deg).value, most_k = law.stiffness_N_per_mm(most_deg).value;
  if (most_k / least_k - 1 < kLeastExcitation) {
    return fail("excitation: stretch {:.1f}…{:.1f}° moves the law by {:.1f} %; expected at least {:.0f} %", least_deg,
                most_deg, 100 * (most_k / least_k - 1), 100 * kLeastExcitation);
  }
  const Fit fit = search(points);
  if (!(fit.gain > 0) || !(fit.residual <= (1 - kLeastExplained) * fit.variance)) {
    return fail(
        "excitation: the model explains {:.0f} % of the measured stiffness' changes; expected at least {:.0f} %",
        fit.variance > 0 && fit.gain > 0 ? 100 * (1 - fit.residual / fit.variance) : 0.0, 100 * kLeastExplained);
  }
  IdentifiedCloth cloth;
  cloth.scale = math::exp(fit.log_scale + (fit.gain - 1) * 0.5 * math::log(least_k * most_k));
  cloth.shape_gain = fit.gain;
  cloth.delay_s = fit.delay_s;
  cloth.lag_s = fit.lag_s;
  cloth.slope_N_per_mm_deg = cloth.scale * fit.gain * (most_k - least_k) / (most_deg - least_deg);
  cloth.residual_rms_relative = std::sqrt(fit.residual);
  cloth.noise_correlation_s = correlation_s(points, fit);
  return cloth;
}

}  // namespace fyd::control
