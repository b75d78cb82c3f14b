#include "core/calibration/cloth_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fyd::calibration {
namespace {

using sensing::ClothEdges;

// Model error of a share, for the weights. A cloth with free edges narrows and wrinkles and is no linear membrane.
constexpr double kHeldShareSigma = 0.01;
constexpr double kFreeShareSigma = 0.04;
// Prior: means, and standard deviations of the logarithms; the mean ratio of a held cloth is 1. It counts where the
// presses contain little information.
constexpr double kPriorRadiusShare = 0.7, kPriorRadiusShareSigma = 0.3;
constexpr double kPriorFreeRatio = 12.0, kPriorFreeRatioSigma = 0.25, kPriorHeldRatioSigma = 0.7;
// Limits of the fit.
constexpr double kLeastRadiusShare = 0.35, kMostRadiusShare = 1.3;
constexpr double kMostHeldRatio = 4.0;  // or its inverse: a cloth held all round is stretched both ways
constexpr double kLeastFreeRatio = 2.0, kMostFreeRatio = 15.0;

double shareSigma(ClothEdges edges) { return edges == ClothEdges::held ? kHeldShareSigma : kFreeShareSigma; }

sensing::IndentationParameters parametersOf(sensing::IndentationParameters p, ClothEdges edges, ClothUnknowns at) {
  p.contact_radius_share = std::exp(at.log_share);
  p.contact_radius_share_sigma = 0.2 * p.contact_radius_share;  // the sensor under the finger counts most
  p.cloth_share_sigma = shareSigma(edges);
  p.cloth_tension_ratio = std::exp(at.log_ratio);
  p.cloth_tension_ratio_sigma = 0.2;
  p.cloth_edges = edges;
  return p;
}

/// Covariance and condition of a fit whose last normal matrix this is.
void setUncertainty(ClothFit& fit, const Eigen::Matrix2d& normal, std::size_t presses) {
  // Readings (residuals less the two of the prior) less unknowns (one depth a press, share and ratio).
  const double degrees_of_freedom = static_cast<double>(fit.residuals.size() - presses) - 4.0;
  if (!(degrees_of_freedom > 0.0)) return;
  fit.covariance = normal.inverse() * (fit.cost / degrees_of_freedom);
  // Scaled to ones on its diagonal, a matrix of two rows has the eigenvalues 1 ± the correlation.
  const double correlation = std::abs(normal(0, 1)) / std::sqrt(normal(0, 0) * normal(1, 1));
  fit.condition_number = correlation < 1.0 ? std::sqrt((1.0 + correlation) / (1.0 - correlation))
                                           : std::numeric_limits<double>::infinity();
}

}  // namespace

ClothModel::ClothModel(const sensing::IndentationParameters& profile, ClothEdges edges, ClothUnknowns at)
    : share_sigma_(shareSigma(edges)), cloth_(parametersOf(profile, edges, at)) {}

void ClothModel::residuals(const ClothPress& press, std::size_t sensors, std::vector<double>& out) {
  const double depth = cloth_.solve(press.contact, std::span(press.drops).first(sensors)).indentation_mm;
  for (std::size_t i = 0; i < sensors; ++i) {
    if (!press.drops[i].used) continue;
    const double share = cloth_.share(i);
    const double sigma = std::hypot(kPressNoise_mm, share_sigma_ * (1.0 - share) * depth);
    out.push_back((press.drops[i].drop_mm - share * depth) / sigma);
  }
}

ClothModel::Prediction ClothModel::predict(const ClothPress& press, std::size_t sensors) {
  Prediction out{.depth_mm = press.drops[press.over].drop_mm};
  for (int round = 0; round < 3; ++round) {
    cloth_.press(press.contact, out.depth_mm);
    out.depth_mm = press.drops[press.over].drop_mm / cloth_.share(press.over);
  }
  std::vector<double> errors;
  for (std::size_t i = 0; i < sensors; ++i) {
    if (i == press.over || !press.drops[i].used) continue;
    errors.push_back(press.drops[i].drop_mm - cloth_.share(i) * out.depth_mm);
  }
  out.error_mm = rootMeanSquare(errors);
  return out;
}

std::vector<double> ClothFitter::residuals(const std::vector<ClothPress>& presses, ClothEdges edges,
                                           ClothUnknowns at) const {
  std::vector<double> out;
  ClothModel model(profile_, edges, at);
  for (const ClothPress& press : presses) model.residuals(press, sensors_, out);
  out.push_back((at.log_share - std::log(kPriorRadiusShare)) / kPriorRadiusShareSigma);
  out.push_back(edges == ClothEdges::held ? at.log_ratio / kPriorHeldRatioSigma
                                          : (at.log_ratio - std::log(kPriorFreeRatio)) / kPriorFreeRatioSigma);
  return out;
}

std::optional<ClothFit> ClothFitter::fit(const std::vector<ClothPress>& presses, ClothEdges edges) const {
  ClothFit best;
  best.cost = std::numeric_limits<double>::infinity();
  for (const double ratio : {0.3, 0.6, 1.0, 1.7, 3.0, 6.0, 10.0}) {
    for (const double share : {0.6, 0.9}) takeIfBetter(best, presses, edges, {std::log(share), std::log(ratio)});
  }
  if (best.residuals.size() < presses.size() + 5 || !std::isfinite(best.cost)) return std::nullopt;
  double damping = 1e-3;
  for (int round = 0; round < 30; ++round) {
    const Eigen::MatrixX2d derivatives = jacobian(presses, edges, best.at);
    const Eigen::Map<const Eigen::VectorXd> r(best.residuals.data(), static_cast<Eigen::Index>(best.residuals.size()));
    Eigen::Matrix2d normal = derivatives.transpose() * derivatives;
    setUncertainty(best, normal, presses.size());
    normal.diagonal() *= 1.0 + damping;
    const Eigen::Vector2d step = -normal.ldlt().solve(derivatives.transpose() * r);
    if (!step.allFinite()) break;
    const double before = best.cost;
    takeIfBetter(best, presses, edges, {best.at.log_share + step[0], best.at.log_ratio + step[1]});
    if (best.cost < before) {
      damping *= 0.2;
      if (before - best.cost < 1e-9 * before) break;
    } else {
      damping *= 10.0;
      if (damping > 1e6 || step.norm() < 1e-7) break;
    }
  }
  return best;
}

void ClothFitter::takeIfBetter(ClothFit& best, const std::vector<ClothPress>& presses, ClothEdges edges,
                               ClothUnknowns at) const {
  at.log_share = std::clamp(at.log_share, std::log(kLeastRadiusShare), std::log(kMostRadiusShare));
  at.log_ratio = edges == ClothEdges::held
                     ? std::clamp(at.log_ratio, -std::log(kMostHeldRatio), std::log(kMostHeldRatio))
                     : std::clamp(at.log_ratio, std::log(kLeastFreeRatio), std::log(kMostFreeRatio));
  auto r = residuals(presses, edges, at);
  double cost = 0.0;
  for (const double each : r) cost += each * each;
  if (!(cost < best.cost)) return;
  best.at = at;
  best.cost = cost;
  best.residuals = std::move(r);
}

Eigen::MatrixX2d ClothFitter::jacobian(const std::vector<ClothPress>& presses, ClothEdges edges,
                                       ClothUnknowns at) const {
  constexpr double kStep = 0.01;
  Eigen::MatrixX2d out;
  for (int column = 0; column < 2; ++column) {
    ClothUnknowns low = at, high = at;
    (column == 0 ? low.log_share : low.log_ratio) -= kStep;
    (column == 0 ? high.log_share : high.log_ratio) += kStep;
    const auto below = residuals(presses, edges, low), above = residuals(presses, edges, high);
    out.conservativeResize(static_cast<Eigen::Index>(below.size()), 2);
    for (std::size_t i = 0; i < below.size(); ++i) {
      out(static_cast<Eigen::Index>(i), column) = (above[i] - below[i]) / (2 * kStep);
    }
  }
  return out;
}

}  // namespace fyd::calibration
