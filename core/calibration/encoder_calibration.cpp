#include "core/calibration/encoder_calibration.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/fit/cross_validation.h"
#include "core/calibration/fit/least_squares.h"

namespace fyd::calibration {
namespace {

constexpr double kTurn = control::kEncoderCountsPerTurn;
constexpr std::array<std::string_view, control::kMotorCount> kNames = {sentence("first"), sentence("second")};
constexpr std::array<std::string_view, control::kMotorCount> kScales = {sentence("first scale"),
                                                                        sentence("second scale")};
constexpr std::array<std::string_view, control::kMotorCount> kZeros = {sentence("first zero"), sentence("second zero")};

std::vector<double> unwrapped(const std::vector<double>& counts) {
  std::vector<double> out;
  out.reserve(counts.size());
  for (const double count : counts) {
    out.push_back(out.empty() ? count : out.back() + std::remainder(count - out.back(), kTurn));
  }
  return out;
}

struct Sweep {
  Eigen::MatrixXd design;  // command, 1
  Eigen::VectorXd counts;
};

Sweep rowsOf(const std::vector<double>& command, const std::vector<double>& counts, std::span<const std::size_t> rows) {
  Sweep out{Eigen::MatrixXd(static_cast<Eigen::Index>(rows.size()), 2),
            Eigen::VectorXd(static_cast<Eigen::Index>(rows.size()))};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out.design.row(static_cast<Eigen::Index>(i)) << command[rows[i]], 1.0;
    out.counts[static_cast<Eigen::Index>(i)] = counts[rows[i]];
  }
  return out;
}

struct Problem {
  Message words;  ///< what is wrong with this encoder; empty when nothing is
  std::string_view threshold;
  bool too_few = false;
};

Problem calibrateOne(std::size_t motor, const EncoderSamples& s, const CalibrationParameters& p,
                     EncoderCalibration& out, std::vector<double>& held_out) {
  const std::vector<double>& command = s.command_deg[motor];
  EncoderFinding& found = out.encoders[motor];
  const auto [low, high] = std::minmax_element(command.begin(), command.end());
  found.from_deg = *low;
  found.to_deg = *high;
  if (found.to_deg - found.from_deg < p.encoder_least_sweep_deg || command.size() < 5) {
    return {say("{} encoder: {} points over {:.3g} deg; expected at least 5 over {:g} deg: sweep farther",
                phrase(kNames[motor]), command.size(), found.to_deg - found.from_deg, p.encoder_least_sweep_deg),
            "calibration.encoder_least_sweep_deg", true};
  }
  const std::vector<double> counts = unwrapped(s.counts[motor]);
  std::vector<std::size_t> rows(command.size());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = i;
  const Sweep sweep = rowsOf(command, counts, rows);
  const auto fit = fitLinear(sweep.design, sweep.counts);
  if (!fit) return {say("{} encoder: {}", phrase(kNames[motor]), fit.error().message), {}};
  found.counts_per_deg = fit->coefficients[0];
  found.inverted = found.counts_per_deg < 0;
  const double zero = fit->coefficients[1] - kTurn * std::floor(fit->coefficients[1] / kTurn);
  found.zero_counts = static_cast<int>(std::lround(zero)) % control::kEncoderCountsPerTurn;
  CalibrationResult& result = out.result;
  result.coefficients.push_back(
      {std::string(kScales[motor]), "counts/deg", found.counts_per_deg, fit->standardError(0)});
  result.coefficients.push_back({std::string(kZeros[motor]), "counts", zero, fit->standardError(1)});
  result.condition_number = std::fmax(result.condition_number, fit->condition_number);
  for (const double residual : fit->residuals) result.residuals.push_back(residual / control::kEncoderCountsPerDegree);
  const auto predicted = predictHeldOut(
      foldsByOrder(rows.size()),
      [&](const std::vector<std::size_t>& learn) {
        const Sweep part = rowsOf(command, counts, learn);
        return fitLinear(part.design, part.counts);
      },
      [&](const LinearFit& part, std::size_t row) {
        return part.coefficients[0] * command[row] + part.coefficients[1];
      });
  for (const std::size_t row : rows)
    held_out.push_back((counts[row] - predicted[row]) / control::kEncoderCountsPerDegree);
  const double departure = 100.0 * (std::abs(found.counts_per_deg) / control::kEncoderCountsPerDegree - 1.0);
  if (!(std::abs(departure) <= p.encoder_scale_percent)) {
    return {say("{} encoder turns {:.1f} % {} than commanded; expected within {:g} %: check that the motor is "
                "free, and that both are wired to the same roller",
                phrase(kNames[motor]), std::abs(departure), departure < 0 ? say("less") : say("more"),
                p.encoder_scale_percent),
            "calibration.encoder_scale_percent"};
  }
  return {};
}

}  // namespace

EncoderCalibration calibrateEncoders(const EncoderSamples& s, const CalibrationParameters& p) {
  EncoderCalibration out;
  CalibrationResult& result = out.result;
  result = {.procedure = "encoders",
            .curve = say("a line for each encoder"),
            .unit = "deg",
            .points = s.counts[0].size(),
            .samples = {{"first_deg", "deg", s.command_deg[0]},
                        {"first_counts", "counts", s.counts[0]},
                        {"second_deg", "deg", s.command_deg[1]},
                        {"second_counts", "counts", s.counts[1]}},
            .valid_unit = "deg"};
  bool good = true;
  for (std::size_t motor = 0; motor < control::kMotorCount; ++motor) {
    if (s.command_deg[motor].size() != s.counts[0].size() || s.counts[motor].size() != s.counts[0].size() ||
        s.counts[0].empty()) {
      refuse(result, say("commands and counts differ in number, or there are none"));
      return out;
    }
    good = checkColumn(result, fmt::format("{}_deg", kNames[motor]), s.command_deg[motor], -3600, 3600) && good;
    good = checkColumn(result, fmt::format("{}_counts", kNames[motor]), s.counts[motor], 0, kTurn - 1) && good;
  }
  if (!good) return out;
  std::vector<double> held_out;
  Problem problem;
  for (std::size_t motor = 0; motor < control::kMotorCount; ++motor) {
    Problem found = calibrateOne(motor, s, p, out, held_out);
    if (problem.words.empty()) problem = std::move(found);
  }
  result.rmse = rootMeanSquare(result.residuals);
  result.held_out_rmse = rootMeanSquare(held_out);
  result.max_residual = 0.0;
  for (const double r : result.residuals) result.max_residual = std::max(result.max_residual, std::abs(r));
  result.valid_from = std::max(out.encoders[0].from_deg, out.encoders[1].from_deg);
  result.valid_to = std::min(out.encoders[0].to_deg, out.encoders[1].to_deg);
  if (!problem.words.empty()) {
    if (problem.too_few) {
      refuseTooFew(result, problem.words, problem.threshold);
    } else {
      refuse(result, problem.words, problem.threshold);
    }
    return out;
  }
  if (!(result.held_out_rmse <= p.encoder_held_out_deg)) {
    refuse(result,
           say("held-out error {}; expected at most {:g}: sweep slower, and wait at each angle",
               errorWithUnit(result.held_out_rmse, "deg"), p.encoder_held_out_deg),
           "calibration.encoder_held_out_deg");
    return out;
  }
  for (std::size_t motor = 0; motor < control::kMotorCount; ++motor) {
    result.changes.push_back({fmt::format("control.encoder_zero_{}_counts", kNames[motor]),
                              fmt::format("{}", out.encoders[motor].zero_counts)});
    result.changes.push_back(
        {fmt::format("control.encoder_{}_inverted", kNames[motor]), out.encoders[motor].inverted ? "true" : "false"});
  }
  result.verdict = {.accepted = true,
                    .reason = say("held-out error {} of at most {:g} deg", errorWithUnit(result.held_out_rmse, "deg"),
                                  p.encoder_held_out_deg),
                    .threshold = "calibration.encoder_held_out_deg"};
  return out;
}

}  // namespace fyd::calibration
