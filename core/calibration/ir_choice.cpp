#include "core/calibration/ir_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/calibration/fit/cross_validation.h"
#include "core/calibration/fit/outliers.h"
#include "core/calibration/fit/polynomial_basis.h"

namespace fyd::calibration {
namespace {

constexpr double kAsGood = 1.05;

struct Judged {
  IrCurve curve;
  double weighted_held_out = kUnknown;  // in units of the expected noise
};

/// Points that the others contradict, judged by this kind of curve; residuals in units of the expected noise.
std::vector<std::size_t> contradicted(const IrCurve& curve, const IrPoints& points) {
  const auto rows = static_cast<Eigen::Index>(points.volts.size());
  const Eigen::VectorXd volts = Eigen::Map<const Eigen::VectorXd>(points.volts.data(), rows);
  const Eigen::VectorXd distance = Eigen::Map<const Eigen::VectorXd>(points.distance_mm.data(), rows);
  const Eigen::VectorXd root = Eigen::Map<const Eigen::VectorXd>(points.weight.data(), rows).cwiseSqrt();
  Eigen::MatrixXd design;
  if (curve.form == sensing::IrCurveForm::inverse) {
    const Eigen::ArrayXd share = (volts.array() + curve.coefficients[1]).inverse();
    design.resize(rows, 3);
    design << share, share.square(), Eigen::VectorXd::Ones(rows);
  } else if (curve.candidate == IrCandidate::thesis_scaled) {
    design.resize(rows, 2);
    const sensing::IrDistance thesis;
    for (Eigen::Index i = 0; i < rows; ++i) design.row(i) << thesis.distance_mm(volts[i]), 1.0;
  } else {
    design = PolynomialBasis(points.volts, curve.coefficients.size() - 1).design(points.volts);
  }
  return findOutliers(root.asDiagonal() * design, root.cwiseProduct(distance), {.least_sigma = 1.0});
}

Judged judge(const IrCurve& curve, const IrPoints& points, IrAttempt& attempt) {
  const sensing::IrDistance sensor = curve.sensor(0, sensing::kAdcCodes - 1);
  std::vector<double> residual, held_out, weighted;
  const auto folds = foldsByTarget(points.distance_mm, kSameDistance_mm, Ends::kept);
  const auto predicted = predictHeldOut(
      folds, [&](const auto& rows) { return fitIrCurve(curve.candidate, rowsOf(points, rows)); },
      [&](const IrCurve& fitted, std::size_t row) {
        return fitted.sensor(0, sensing::kAdcCodes - 1).distance_mm(points.volts[row]);
      });
  bool complete = true;
  for (std::size_t i = 0; i < points.volts.size(); ++i) {
    residual.push_back(points.distance_mm[i] - sensor.distance_mm(points.volts[i]));
    if (folds[i] == kNeverHeldOut) continue;
    complete = complete && std::isfinite(predicted[i]);
    held_out.push_back(points.distance_mm[i] - predicted[i]);
    weighted.push_back(held_out.back() * std::sqrt(points.weight[i]));
  }
  attempt.rmse_mm = rootMeanSquare(residual);
  attempt.held_out_rmse_mm = complete ? rootMeanSquare(held_out) : kUnknown;
  attempt.condition_number = curve.condition_number;
  return {curve, complete ? rootMeanSquare(weighted) : kUnknown};
}

}  // namespace

std::pair<int, int> codeSpan(const IrPoints& points) {
  const auto [low, high] = std::minmax_element(points.volts.begin(), points.volts.end());
  constexpr double kCodesPerVolt = sensing::kAdcCodes / sensing::kAdcReference_V;
  return {static_cast<int>(std::ceil(*low * kCodesPerVolt - 1e-6)),
          static_cast<int>(std::floor(*high * kCodesPerVolt + 1e-6))};
}

bool fallsAtEveryCode(const IrCurve& curve, int lowest_code, int highest_code) {
  const sensing::IrDistance sensor = curve.sensor(lowest_code, highest_code);
  double before = std::numeric_limits<double>::infinity();
  for (int code = lowest_code; code <= highest_code; ++code) {
    const sensing::IrReading reading = sensor.read(static_cast<std::uint16_t>(code));
    if (!reading.valid || !(reading.distance_mm < before) || !(reading.distance_mm > 0)) return false;
    before = reading.distance_mm;
  }
  return highest_code > lowest_code;
}

IrChoice chooseIrCurve(const IrPoints& all, std::vector<std::size_t> rows, const CalibrationParameters& p) {
  IrChoice choice{.attempts = {}, .rows = std::move(rows), .points = {}, .curve = {}};
  choice.points = rowsOf(all, choice.rows);
  const IrPoints& points = choice.points;
  const std::size_t distances = distinctValues(points.distance_mm, kSameDistance_mm).size();
  const auto [lowest, highest] = codeSpan(points);
  std::vector<Judged> usable;
  double best = std::numeric_limits<double>::infinity();
  for (const IrCandidate candidate : kIrCandidates) {
    IrAttempt attempt{.candidate = candidate, .problem = {}};
    const std::size_t needed = freedomOf(candidate) + 2;
    if (distances < needed) {
      attempt.problem = say("{} distances; needs {}", distances, needed);
    } else if (const auto curve = fitIrCurve(candidate, points); !curve) {
      attempt.problem = curve.error().message;
    } else {
      const Judged judged = judge(*curve, points, attempt);
      if (curve->condition_number > p.condition_limit) {
        attempt.problem = say("condition number {:.3g}", curve->condition_number);
      } else if (!fallsAtEveryCode(*curve, lowest, highest)) {
        attempt.problem = say("does not fall over its whole span");
      } else if (std::isnan(judged.weighted_held_out)) {
        attempt.problem = say("cannot be judged on held-out distances");
      } else {
        best = std::min(best, judged.weighted_held_out);
        usable.push_back(judged);
      }
    }
    choice.attempts.push_back(attempt);
  }
  const auto chosen = std::find_if(usable.begin(), usable.end(),
                                   [&](const Judged& j) { return j.weighted_held_out <= kAsGood * best; });
  if (chosen != usable.end()) choice.curve = chosen->curve;
  return choice;
}

std::vector<std::size_t> rowsWithout(std::size_t count, const std::vector<std::size_t>& left_out) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::binary_search(left_out.begin(), left_out.end(), i)) rows.push_back(i);
  }
  return rows;
}

std::vector<std::size_t> irOutliers(const IrPoints& all, const IrChoice& first, const CalibrationParameters& p) {
  IrChoice choice = first;
  std::vector<std::size_t> outliers;
  // Twice: the first curve may have been chosen because of the very points that are wrong.
  for (int pass = 0; pass < 2; ++pass) {
    if (!choice.curve) {
      const auto cubic = fitIrCurve(IrCandidate::degree3, choice.points);
      if (!cubic) return outliers;
      choice.curve = *cubic;
    }
    outliers = contradicted(*choice.curve, all);
    if (outliers.empty()) return outliers;
    choice = chooseIrCurve(all, rowsWithout(all.volts.size(), outliers), p);
  }
  return outliers;
}

}  // namespace fyd::calibration
