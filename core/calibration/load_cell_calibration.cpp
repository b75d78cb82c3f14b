#include "core/calibration/load_cell_calibration.h"

#include <algorithm>
#include <cmath>

#include "core/base/units.h"
#include "core/calibration/fit/cross_validation.h"
#include "core/calibration/fit/least_squares.h"
#include "core/calibration/fit/outliers.h"

namespace fyd::calibration {
namespace {

constexpr double kCellFullScale_N = 7.65;
constexpr double kLeastBridgeNoise_N = 0.002;
constexpr double kLargestValue = 1000.0, kLargestForce_N = 1000.0;
constexpr double kDriftCondition = 50.0;
constexpr double kSureOfLoadCell = 3.0;  // standard errors

struct Line {
  Eigen::MatrixXd design;  // value, 1
  Eigen::VectorXd force;
};

Line lineOf(const LoadCellSamples& s, const std::vector<std::size_t>& rows) {
  Line line{Eigen::MatrixXd(static_cast<Eigen::Index>(rows.size()), 2),
            Eigen::VectorXd(static_cast<Eigen::Index>(rows.size()))};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    line.design.row(static_cast<Eigen::Index>(i)) << s.value_mV_per_V[rows[i]], 1.0;
    line.force[static_cast<Eigen::Index>(i)] = s.force_N[rows[i]];
  }
  return line;
}

std::vector<std::size_t> everyRow(std::size_t count) {
  std::vector<std::size_t> rows(count);
  for (std::size_t i = 0; i < count; ++i) rows[i] = i;
  return rows;
}

/// Residual against order, with the line fitted anew: a drift that rises with the force must not count as slope.
void findDrift(LoadCellCalibration& out, const Line& line) {
  const Eigen::Index count = line.force.size();
  if (count < 5) return;
  Eigen::MatrixXd design(count, 3);
  design.leftCols(2) = line.design;
  design.col(0).array() -= line.design.col(0).mean();
  design.col(2).setLinSpaced(count, -0.5, 0.5);
  const auto fit = fitLinear(design, line.force);
  if (!fit || fit->condition_number > kDriftCondition) return;
  out.drift_N = fit->coefficients[2];
  out.drift_error_N = fit->standardError(2);
}

/// A point belongs to loading when the force rose to it, to unloading when it fell; compared at weights seen both ways.
void findHysteresis(LoadCellCalibration& out, const LoadCellSamples& s, double same_N) {
  struct Seen {
    double force = 0.0, loading = 0.0, unloading = 0.0;
    double loads = 0.0, unloads = 0.0;
  };
  std::vector<Seen> seen;
  for (const double force : distinctValues(s.force_N, same_N)) seen.push_back({.force = force});
  int direction = 0;
  for (std::size_t i = 0; i < s.force_N.size(); ++i) {
    if (i > 0 && std::abs(s.force_N[i] - s.force_N[i - 1]) > same_N) {
      direction = s.force_N[i] > s.force_N[i - 1] ? 1 : -1;
    }
    const auto at = std::find_if(seen.rbegin(), seen.rend(), [&](const Seen& g) { return g.force <= s.force_N[i]; });
    if (at == seen.rend() || direction == 0) continue;
    (direction > 0 ? at->loading : at->unloading) += out.result.residuals[i];
    (direction > 0 ? at->loads : at->unloads) += 1;
  }
  double sum = 0.0, count = 0.0;
  for (const Seen& g : seen) {
    if (g.loads == 0 || g.unloads == 0) continue;
    sum += g.loading / g.loads - g.unloading / g.unloads;
    count += 1;
  }
  if (count >= 2) out.hysteresis_N = sum / count;
}

void findRepeatability(LoadCellCalibration& out, const LoadCellSamples& s, double same_N) {
  double squares = 0.0, freedom = 0.0;
  for (const double force : distinctValues(s.force_N, same_N)) {
    double sum = 0.0, square = 0.0, count = 0.0;
    for (std::size_t i = 0; i < s.force_N.size(); ++i) {
      if (s.force_N[i] < force || s.force_N[i] > force + same_N) continue;
      sum += out.result.residuals[i];
      square += out.result.residuals[i] * out.result.residuals[i];
      count += 1;
    }
    squares += std::max(0.0, square - sum * sum / std::max(1.0, count));
    freedom += std::max(0.0, count - 1);
  }
  if (freedom > 0) out.repeatability_N = std::sqrt(squares / freedom);
}

void pointOut(LoadCellCalibration& out, double span_N, double allowed_percent) {
  const double allowed_N = allowed_percent / 100.0 * span_N;
  if (std::abs(out.drift_N) > std::max(allowed_N, kSureOfLoadCell * out.drift_error_N)) {
    out.result.notes.push_back(
        say("the reading drifts by {:.3f} N over the measurement: let the bridge warm up", out.drift_N));
  }
  if (std::abs(out.hysteresis_N) > allowed_N) {
    out.result.notes.push_back(
        say("loading reads {:.3f} N apart from unloading: look for friction between the cell and its plate",
            out.hysteresis_N));
  }
}

}  // namespace

LoadCellCalibration calibrateLoadCell(const LoadCellSamples& s, const CalibrationParameters& p) {
  LoadCellCalibration out;
  CalibrationResult& result = out.result;
  result = {.procedure = "load-cell",
            .curve = say("line"),
            .unit = "N",
            .points = s.force_N.size(),
            .samples = {{"value", "mV/V", s.value_mV_per_V}, {"force_N", "N", s.force_N}},
            .valid_unit = "mV/V"};
  if (s.force_N.size() != s.value_mV_per_V.size()) {
    refuse(result, say("{} values and {} forces; expected as many of each", s.value_mV_per_V.size(), s.force_N.size()));
    return out;
  }
  const bool values_good = checkColumn(result, "value", s.value_mV_per_V, -kLargestValue, kLargestValue);
  if (!checkColumn(result, "force_N", s.force_N, -kLargestForce_N, kLargestForce_N) || !values_good) return out;

  const auto [low, high] = std::minmax_element(s.force_N.begin(), s.force_N.end());
  const double span_N = s.force_N.empty() ? 0.0 : *high - *low;
  const double same_N = std::max(1e-9, 1e-3 * span_N);
  const auto loads = distinctValues(s.force_N, same_N);
  const Gap gap = widestGap(loads, 0.0, loads.empty() ? kCellFullScale_N : std::max(kCellFullScale_N, loads.back()));
  const Message advice = say("add weights between {:.3g} and {:.3g} N", gap.from, gap.to);
  if (loads.size() < static_cast<std::size_t>(p.force_fewest_loads)) {
    refuseTooFew(result,
                 say("{} different weights in {} points; expected at least {}: {}", loads.size(), s.force_N.size(),
                     p.force_fewest_loads, advice),
                 "calibration.force_fewest_loads");
    return out;
  }
  if (span_N < p.force_least_span_N) {
    refuseTooFew(
        result, say("the weights span only {:.3g} N; expected at least {:g}: {}", span_N, p.force_least_span_N, advice),
        "calibration.force_least_span_N");
    return out;
  }
  const auto rows = everyRow(s.force_N.size());
  const Line line = lineOf(s, rows);
  // Centred for numerical accuracy: an offset of the values then costs no digits; it is put back below.
  const double centre = line.design.col(0).mean();
  Eigen::MatrixXd centred = line.design;
  centred.col(0).array() -= centre;
  const double width = centred.col(0).cwiseAbs().maxCoeff();
  if (!(width > 1e-9 * std::max(1.0, std::abs(centre)))) {
    refuse(result, say("the value stays at {:.6g} mV/V whatever the weight: check the cell's cable "
                       "and the bridge's channel",
                       centre));
    return out;
  }
  const auto fit = fitLinear(centred, line.force);
  if (!fit) {
    refuse(result, fit.error().message);
    return out;
  }
  const double slope = fit->coefficients[0], offset = fit->coefficients[1] - slope * centre;
  const double offset_variance =
      fit->covariance(1, 1) - 2 * centre * fit->covariance(0, 1) + centre * centre * fit->covariance(0, 0);
  result.coefficients = {{std::string(sentence("slope")), "N/(mV/V)", slope, fit->standardError(0)},
                         {std::string(sentence("offset")), "N", offset, std::sqrt(offset_variance)}};
  result.rmse = fit->rmse;
  result.max_residual = fit->max_residual;
  result.condition_number = fit->condition_number;
  result.residuals.assign(fit->residuals.begin(), fit->residuals.end());
  result.valid_from = line.design.col(0).minCoeff();
  result.valid_to = line.design.col(0).maxCoeff();
  result.outliers = findOutliers(centred, line.force, {.least_sigma = kLeastBridgeNoise_N});

  const auto predicted = predictHeldOut(
      foldsByTarget(s.force_N, same_N, Ends::held_out),
      [&](const std::vector<std::size_t>& learn) {
        Line part = lineOf(s, learn);
        part.design.col(0).array() -= centre;
        return fitLinear(part.design, part.force);
      },
      [&](const LinearFit& part, std::size_t row) {
        return part.coefficients[0] * (s.value_mV_per_V[row] - centre) + part.coefficients[1];
      });
  std::vector<double> held_out;
  for (std::size_t i = 0; i < rows.size(); ++i) held_out.push_back(s.force_N[i] - predicted[i]);
  result.held_out_rmse = rootMeanSquare(held_out);
  findDrift(out, line);
  findHysteresis(out, s, same_N);
  findRepeatability(out, s, same_N);
  pointOut(out, span_N, p.force_hysteresis_percent);

  if (!(result.held_out_rmse <= p.force_held_out_N)) {
    refuse(result,
           say("held-out error {}; expected at most {:g} N: {}", errorWithUnit(result.held_out_rmse, "N"),
               p.force_held_out_N,
               !hasFewOutliers(result) ? say("check the weights, and that nothing rubs on the cell")
                                       : say("the outliers are kept in the fit; measure them again")),
           "calibration.force_held_out_N");
    return out;
  }
  if (!(std::abs(slope) > kSureOfLoadCell * fit->standardError(0)) && fit->sigma > 0) {
    refuse(result, say("the value does not follow the weight: check the cell's cable"));
    return out;
  }
  result.changes = {{"sensing.force_slope_g", fmt::format("{}", slope * 1000.0 / kStandardGravity)},
                    {"sensing.force_offset_g", fmt::format("{}", offset * 1000.0 / kStandardGravity)},
                    {"sensing.force_zero_N", "0"}};
  result.verdict = {.accepted = true,
                    .reason = say("held-out error {} of at most {:g} N over {} weights",
                                  errorWithUnit(result.held_out_rmse, "N"), p.force_held_out_N, loads.size()),
                    .threshold = "calibration.force_held_out_N"};
  return out;
}

}  // namespace fyd::calibration
