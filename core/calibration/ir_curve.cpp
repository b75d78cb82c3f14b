#include "core/calibration/ir_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/tools/minima.hpp>

#include "core/calibration/fit/least_squares.h"
#include "core/calibration/fit/polynomial_basis.h"

namespace fyd::calibration {
namespace {

constexpr double kPlacing_mm = 0.5;  // how well a target is placed by hand
constexpr double kLowestCode = 524, kHighestCode = 3408;

Eigen::VectorXd asVector(std::span<const double> values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void takeErrors(IrCurve& curve, const Eigen::MatrixXd& covariance) {
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) curve.standard_errors.push_back(std::sqrt(covariance(i, i)));
}

/// The fit's coefficients on another basis, as the curve writes them.
void takeMapped(IrCurve& curve, const LinearFit& fit, const Eigen::MatrixXd& map) {
  const LinearImage image = imageOf(fit, map);
  curve.coefficients.assign(image.coefficients.begin(), image.coefficients.end());
  takeErrors(curve, image.covariance);
  curve.condition_number = fit.condition_number;
}

Result<IrCurve> fitPolynomial(IrCurve curve, const IrPoints& points, std::size_t degree) {
  const PolynomialBasis basis(points.volts, degree);
  auto fit = fitLinear(basis.design(points.volts), asVector(points.distance_mm), asVector(points.weight));
  if (!fit) return tl::unexpected(fit.error());
  takeMapped(curve, *fit, basis.toPowers());
  return curve;
}

Result<IrCurve> fitThesisScaled(IrCurve curve, const IrPoints& points) {
  const sensing::IrDistance thesis;
  Eigen::MatrixXd design(static_cast<Eigen::Index>(points.volts.size()), 2);
  for (std::size_t i = 0; i < points.volts.size(); ++i) {
    design.row(static_cast<Eigen::Index>(i)) << thesis.distance_mm(points.volts[i]), 1.0;
  }
  auto fit = fitLinear(design, asVector(points.distance_mm), asVector(points.weight));
  if (!fit) return tl::unexpected(fit.error());
  const std::span<const double> printed = thesis.coefficients();
  Eigen::MatrixXd toCurve = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(printed.size()), 2);
  for (std::size_t i = 0; i < printed.size(); ++i) toCurve(static_cast<Eigen::Index>(i), 0) = printed[i];
  toCurve(0, 1) = 1.0;
  takeMapped(curve, *fit, toCurve);
  return curve;
}

/// For a given b the rest is linear; b itself is searched (variable projection), so there is no starting value to
/// guess.
Result<IrCurve> fitInverse(IrCurve curve, const IrPoints& points) {
  const auto rows = static_cast<Eigen::Index>(points.volts.size());
  const auto [low, high] = std::minmax_element(points.volts.begin(), points.volts.end());
  const double lowest = *low, span = *high - *low;
  const Eigen::VectorXd y = asVector(points.distance_mm), weight = asVector(points.weight), v = asVector(points.volts);
  const auto linearFit = [&](double log_room) {
    Eigen::MatrixXd design(rows, 2);
    design.col(0) = (v.array() - lowest + std::exp(log_room)).inverse();
    design.col(1).setOnes();
    return fitLinear(design, y, weight);
  };
  const auto misfit = [&](double log_room) {
    const auto fit = linearFit(log_room);
    return fit ? (fit->residuals.array().square() * weight.array()).sum() : std::numeric_limits<double>::infinity();
  };
  // Distance from the pole to the lowest voltage: from a thousandth of the span (nearly vertical there) to a hundred
  // spans (nearly a straight line). A coarse search first, because the misfit may have two minima.
  const double first = std::log(1e-3 * span), last = std::log(1e2 * span), step = (last - first) / 40;
  double best = first;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 40; ++i) {
    const double sum = misfit(first + i * step);
    if (sum < least) {
      least = sum;
      best = first + i * step;
    }
  }
  if (!std::isfinite(least)) return fail("the inverse form finds no curve through these points");
  std::uintmax_t most = 60;
  const double log_room = boost::math::tools::brent_find_minima(misfit, best - step, best + step, 40, most).first;
  const auto fit = linearFit(log_room);
  if (!fit) return tl::unexpected(fit.error());
  const double a = fit->coefficients[0], b = std::exp(log_room) - lowest;
  curve.form = sensing::IrCurveForm::inverse;
  curve.coefficients = {a, b, fit->coefficients[1]};
  // All three together, linearised where the fit stands: for the uncertainty and the condition number.
  Eigen::MatrixXd jacobian(rows, 3);
  jacobian.col(0) = (v.array() + b).inverse();
  jacobian.col(1) = -a * (v.array() + b).square().inverse();
  jacobian.col(2).setOnes();
  const auto together = fitLinear(jacobian, fit->residuals, weight);
  if (!together) return tl::unexpected(together.error());
  takeErrors(curve, together->covariance);
  curve.condition_number = together->condition_number;
  return curve;
}

}  // namespace

std::string_view toString(IrCandidate candidate) {
  switch (candidate) {
    case IrCandidate::thesis_scaled: return sentence("thesis polynomial, scaled and shifted");
    case IrCandidate::inverse: return sentence("inverse, a/(v + b) + c");
    case IrCandidate::degree2: return sentence("polynomial of degree 2");
    case IrCandidate::degree3: return sentence("polynomial of degree 3");
    case IrCandidate::degree4: return sentence("polynomial of degree 4");
    case IrCandidate::degree5: return sentence("polynomial of degree 5");
  }
  return sentence("unknown");
}

std::size_t freedomOf(IrCandidate candidate) {
  switch (candidate) {
    case IrCandidate::thesis_scaled: return 2;
    case IrCandidate::inverse:
    case IrCandidate::degree2: return 3;
    case IrCandidate::degree3: return 4;
    case IrCandidate::degree4: return 5;
    case IrCandidate::degree5: return 6;
  }
  return 6;
}

sensing::IrDistance IrCurve::sensor(int lowest_code, int highest_code) const {
  return {coefficients, lowest_code, highest_code, form};
}

IrPoints irPoints(std::span<const double> adc, std::span<const double> distance_mm, double noise_mV) {
  const sensing::IrDistance thesis;
  IrPoints points;
  for (std::size_t i = 0; i < adc.size(); ++i) {
    const double inside = std::clamp(adc[i], kLowestCode, kHighestCode);
    const double slope = thesis.read(static_cast<std::uint16_t>(std::lround(inside))).slope_mm_per_V;
    const double noise_mm = slope * noise_mV / 1000.0;
    points.volts.push_back(sensing::voltsFromCode(adc[i]));
    points.distance_mm.push_back(distance_mm[i]);
    points.weight.push_back(1.0 / (kPlacing_mm * kPlacing_mm + noise_mm * noise_mm));
  }
  return points;
}

IrPoints rowsOf(const IrPoints& points, std::span<const std::size_t> rows) {
  IrPoints out;
  for (const std::size_t row : rows) {
    out.volts.push_back(points.volts[row]);
    out.distance_mm.push_back(points.distance_mm[row]);
    out.weight.push_back(points.weight[row]);
  }
  return out;
}

Result<IrCurve> fitIrCurve(IrCandidate candidate, const IrPoints& points) {
  IrCurve curve{.candidate = candidate, .coefficients = {}, .standard_errors = {}};
  if (points.volts.size() < freedomOf(candidate)) {
    return fail("{} points for a {}; expected at least {}", points.volts.size(), phrase(toString(candidate)),
                freedomOf(candidate));
  }
  const auto [low, high] = std::minmax_element(points.volts.begin(), points.volts.end());
  if (!(*high > *low)) return fail("all points at {} V", *low);
  if (candidate == IrCandidate::thesis_scaled) return fitThesisScaled(curve, points);
  if (candidate == IrCandidate::inverse) return fitInverse(curve, points);
  return fitPolynomial(curve, points, freedomOf(candidate) - 1);
}

}  // namespace fyd::calibration
