#include "core/teleop/prediction/linear_forecast.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "core/base/portable_math.h"

namespace fyd::teleop {
namespace {

constexpr double kInitialVelocityDecay_s = 0.060;  // time constant of the initial weights
constexpr double kReversalHorizon_s = 0.100;       // beyond this horizon it is shorter, because a hand reverses
constexpr double kPowerRate = 1.0 / 500.0;         // weight of a message in the running mean of d_0²
constexpr double kLeastPower_mm2 = 1e-6;           // (1 µm)²: sensor noise
constexpr double kLeastExcitation = 1e-4;          // least sum of squared normalised features to learn from
constexpr double kLargestVariance = 1e6;           // of P: above it P has diverged

}  // namespace

void LinearForecast::begin(const ForecastSettings& settings, double step_s) {
  settings_ = settings;
  step_s_ = step_s;
  power_mm2_ = power_count_ = 0.0;
  for (Features& each : weights_) each = {};
  steps_.fill(0);
  beginCovariance();
}

void LinearForecast::beginCovariance() {
  using OrderMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor, kMostOrder, kMostOrder>;
  const auto n = static_cast<Eigen::Index>(settings_.order);
  OrderMatrix information(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const double apart = static_cast<double>(i - k) * step_s_ / settings_.prior_correlation_s;
      information(i, k) = math::exp(-0.5 * apart * apart);
    }
    information(i, i) += settings_.prior_noise + settings_.prior_noise_per_lag * static_cast<double>(i);
  }
  information *= settings_.prior_weight;
  const OrderMatrix inverse = Eigen::LLT<OrderMatrix>(information).solve(OrderMatrix::Identity(n, n));
  std::copy_n(inverse.data(), n * n, covariance_.begin());
}

std::size_t LinearForecast::nearest(const Steps& steps, int step) {
  std::size_t found = kNodes;
  for (std::size_t i = 0; i < kNodes; ++i) {
    if (steps[i] > 0 && (found == kNodes || std::abs(steps[i] - step) < std::abs(steps[found] - step))) found = i;
  }
  return found;
}

void LinearForecast::setNodes(const Steps& steps) {
  const std::array<Features, kNodes> before = weights_;
  for (std::size_t node = 0; node < kNodes; ++node) {
    Features& weights = weights_[node];
    weights = {};
    if (steps[node] <= 0) continue;
    const std::size_t old = nearest(steps_, steps[node]);
    const double horizon_s = steps[node] * step_s_;
    if (old == kNodes) {
      const double far = std::max(1.0, horizon_s / kReversalHorizon_s);
      const double memory_s = kInitialVelocityDecay_s / (far * far);
      weights[0] = memory_s * (1.0 - math::exp(-horizon_s / memory_s)) / step_s_;
    } else {
      weights = before[old];
      for (double& each : weights) each *= static_cast<double>(steps[node]) / steps_[old];
    }
  }
  steps_ = steps;
}

void LinearForecast::updatePower(double newest_d_mm) {
  power_count_ = std::min(power_count_ + 1.0, 1.0 / kPowerRate);
  power_mm2_ += (newest_d_mm * newest_d_mm - power_mm2_) / power_count_;
}

void LinearForecast::learn(const Features& d_mm, const std::array<double, kNodes>& displacement_mm) {
  const std::size_t n = settings_.order;
  const double per_mm = 1.0 / std::sqrt(power_mm2_ + kLeastPower_mm2);
  Features f{};
  double squares = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    f[i] = d_mm[i] * per_mm;
    squares += f[i] * f[i];
  }
  if (!(squares > kLeastExcitation) || !std::isfinite(squares)) return;
  Features pf{};
  double* p = covariance_.data();
  for (std::size_t k = 0; k < n; ++k) {  // P is symmetric: its rows are its columns
    const double* row = p + k * n;
    for (std::size_t i = 0; i < n; ++i) pf[i] += f[k] * row[i];
  }
  double quadratic = settings_.forgetting;
  for (std::size_t i = 0; i < n; ++i) quadratic += f[i] * pf[i];
  const double inflation = 1.0 / settings_.forgetting;
  double largest = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    double* row = p + k * n;
    const double gain = pf[k] / quadratic;
    for (std::size_t i = 0; i < n; ++i) row[i] = (row[i] - gain * pf[i]) * inflation;
    largest = std::max(largest, row[k]);
  }
  for (std::size_t node = 0; node < kNodes; ++node) {
    if (steps_[node] <= 0) continue;
    Features& weights = weights_[node];
    double error = displacement_mm[node] * per_mm;
    for (std::size_t i = 0; i < n; ++i) error -= weights[i] * f[i];
    if (!std::isfinite(error)) continue;
    const double share = error / quadratic;
    for (std::size_t i = 0; i < n; ++i) weights[i] += pf[i] * share;
  }
  if (!(largest < kLargestVariance)) beginCovariance();
}

double LinearForecast::forecast(std::size_t node, const Features& d_mm) const {
  double out = 0.0;
  for (std::size_t i = 0; i < settings_.order; ++i) out += weights_[node][i] * d_mm[i];
  return out;
}

}  // namespace fyd::teleop
