#include "core/calibration/ir_calibration.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/calibration/fit/cross_validation.h"
#include "core/calibration/ir_choice.h"

namespace fyd::calibration {
namespace {

constexpr double kSensorNearest_mm = 40.0, kSensorFarthest_mm = 300.0;
constexpr double kFoldSigmas = 3.0;

/// Below about 4 cm the sensor's voltage falls again: two distances for one code. Names the first such pair, if any.
Message foldIn(const IrSamples& samples, double noise_counts) {
  struct Group {
    double distance = 0.0, sum = 0.0;
    double count = 0.0;
    [[nodiscard]] double mean() const { return sum / count; }
  };
  std::vector<std::size_t> order(samples.adc.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return samples.distance_mm[a] < samples.distance_mm[b]; });
  std::vector<Group> groups;
  for (const std::size_t i : order) {
    if (groups.empty() || samples.distance_mm[i] - groups.back().distance > kSameDistance_mm) {
      groups.push_back({.distance = samples.distance_mm[i]});
    }
    groups.back().sum += samples.adc[i];
    groups.back().count += 1;
  }
  for (std::size_t i = 1; i < groups.size(); ++i) {
    const Group &near = groups[i - 1], &far = groups[i];
    const double allowed = kFoldSigmas * noise_counts * std::sqrt(1 / near.count + 1 / far.count);
    if (far.mean() - near.mean() > allowed) {
      if (near.distance < kSensorNearest_mm) {
        return say(
            "adc rises from {:.0f} at {:g} mm to {:.0f} at {:g} mm, but a farther target must read less: measure both "
            "again, and leave out distances the sensor is too near for",
            near.mean(), near.distance, far.mean(), far.distance);
      }
      return say(
          "adc rises from {:.0f} at {:g} mm to {:.0f} at {:g} mm, but a farther target must read less: measure both "
          "again",
          near.mean(), near.distance, far.mean(), far.distance);
    }
  }
  return {};
}

std::string listOfValues(std::span<const double> values) {
  std::vector<double> list(values.begin(), values.end());
  return fmt::format("[{}]", fmt::join(list, ", "));
}

/// The list of codes with one place changed; sensors before it that have no entry get the standard one.
std::string withEntry(ParameterList list, std::size_t place, int value, double standard) {
  while (list.size() <= place && list.push(standard)) {
  }
  list[place] = value;
  return listOfValues(list.view());
}

void takeCurve(IrCalibration& out, const IrSamples& samples, const IrChoice& choice, const IrOptions& options,
               const sensing::IndentationParameters& present) {
  const IrCurve& curve = out.curve;
  const auto [lowest, highest] = codeSpan(choice.points);
  CalibrationResult& result = out.result;
  result.curve = phrase(toString(curve.candidate));
  result.valid_from = lowest;
  result.valid_to = highest;
  const sensing::IrDistance sensor = curve.sensor(lowest, highest);
  out.valid_from_mm = sensor.read(static_cast<std::uint16_t>(highest)).distance_mm;
  out.valid_to_mm = sensor.read(static_cast<std::uint16_t>(lowest)).distance_mm;
  result.coefficients.clear();
  constexpr std::array<std::string_view, 3> kInverseNames = {"a", "b", "c"}, kInverseUnits = {"mm V", "V", "mm"};
  for (std::size_t i = 0; i < curve.coefficients.size(); ++i) {
    const bool inverse = curve.form == sensing::IrCurveForm::inverse;
    result.coefficients.push_back({inverse ? std::string(kInverseNames[i]) : fmt::format("c{}", i),
                                   inverse  ? std::string(kInverseUnits[i])
                                   : i == 0 ? "mm"
                                            : fmt::format("mm/V^{}", i),
                                   curve.coefficients[i], curve.standard_errors[i]});
  }
  for (std::size_t i = 0; i < samples.adc.size(); ++i) {
    result.residuals.push_back(samples.distance_mm[i] - sensor.distance_mm(sensing::voltsFromCode(samples.adc[i])));
  }
  std::vector<double> fitted;
  for (const std::size_t row : choice.rows) fitted.push_back(result.residuals[row]);
  result.rmse = rootMeanSquare(fitted);
  result.max_residual = 0.0;
  for (const double r : fitted) result.max_residual = std::max(result.max_residual, std::abs(r));

  const std::string id = fmt::format("sensing.ir{}_curve", options.sensor + 1);
  result.changes = {{id + "_form", std::string(sensing::kIrCurveFormNames[static_cast<std::size_t>(curve.form)])},
                    {id + "_mm", listOfValues(curve.coefficients)},
                    {"sensing.ir_lowest_code", withEntry(present.ir_lowest_code, options.sensor, lowest, 524)},
                    {"sensing.ir_highest_code", withEntry(present.ir_highest_code, options.sensor, highest, 3408)}};
}

/// Refuses points that cannot decide a curve. @return true when there are enough of them
bool enoughDistances(CalibrationResult& result, const IrSamples& samples, const CalibrationParameters& p) {
  const auto distinct = distinctValues(samples.distance_mm, kSameDistance_mm);
  const double from = std::min(kSensorNearest_mm, distinct.front());
  const double to = std::max(kSensorFarthest_mm, distinct.back());
  if (distinct.size() < static_cast<std::size_t>(p.ir_fewest_distances)) {
    const Gap gap = widestGap(distinct, from, to);
    refuseTooFew(result,
                 say("{} different distances in {} points; expected at least {}: add points between {:g} and "
                     "{:g} mm (the same distance again tells only the noise)",
                     distinct.size(), samples.adc.size(), p.ir_fewest_distances, gap.from, gap.to),
                 "calibration.ir_fewest_distances");
    return false;
  }
  const double span = distinct.back() - distinct.front();
  if (span < p.ir_least_span_mm) {
    const Gap gap = widestGap(distinct, from, to);
    refuseTooFew(result,
                 say("the distances span only {:.3g} mm, {:g} to {:g}; expected at least {:g}: add points "
                     "between {:g} and {:g} mm",
                     span, distinct.front(), distinct.back(), p.ir_least_span_mm, gap.from, gap.to),
                 "calibration.ir_least_span_mm");
    return false;
  }
  const Gap gap = widestGap(distinct, distinct.front(), distinct.back());
  if (gap.width() > p.widest_gap_percent / 100.0 * span) {
    refuseTooFew(result,
                 say("no point between {:g} and {:g} mm, {:.0f} % of the span: add points between {:g} and {:g} mm",
                     gap.from, gap.to, 100 * gap.width() / span, gap.from, gap.to),
                 "calibration.widest_gap_percent");
    return false;
  }
  return true;
}

}  // namespace

IrCalibration calibrateIr(const IrSamples& samples, const sensing::IndentationParameters& present,
                          const CalibrationParameters& p, const IrOptions& options) {
  IrCalibration out;
  CalibrationResult& result = out.result;
  result = {.procedure = "ir",
            .curve = {},
            .unit = "mm",
            .points = samples.adc.size(),
            .samples = {{"adc", "counts", samples.adc}, {"distance_mm", "mm", samples.distance_mm}},
            .valid_unit = "adc"};
  if (options.sensor >= sensing::kMaximumIrSensors || samples.distance_mm.size() != samples.adc.size()) {
    refuse(result, say("sensor {} with {} codes and {} distances; expected 1 to {} and as many of each",
                       options.sensor + 1, samples.adc.size(), samples.distance_mm.size(), sensing::kMaximumIrSensors));
    return out;
  }
  const bool codes_good = checkColumn(result, "adc", samples.adc, 0, sensing::kAdcCodes - 1);
  if (!checkColumn(result, "distance_mm", samples.distance_mm, 1, 1000) || !codes_good) return out;
  if (samples.adc.empty()) {
    refuse(result, say("no points: add points between 40 and 300 mm"));
    return out;
  }
  if (!enoughDistances(result, samples, p)) return out;

  const IrPoints all = irPoints(samples.adc, samples.distance_mm, present.ir_noise_mV);
  IrChoice choice = chooseIrCurve(all, rowsWithout(samples.adc.size(), {}), p);
  result.outliers = irOutliers(all, choice, p);
  if (options.without_outliers && !result.outliers.empty()) {
    choice = chooseIrCurve(all, rowsWithout(samples.adc.size(), result.outliers), p);
  }
  IrSamples kept;
  for (const std::size_t row : choice.rows) {
    kept.adc.push_back(samples.adc[row]);
    kept.distance_mm.push_back(samples.distance_mm[row]);
  }
  if (!enoughDistances(result, kept, p)) return out;
  out.attempts = choice.attempts;
  const double counts_per_mV = sensing::kAdcCodes / (1000.0 * sensing::kAdcReference_V);
  if (Message fold = foldIn(kept, present.ir_noise_mV * counts_per_mV); !fold.empty()) {
    refuse(result, std::move(fold));
    return out;
  }
  if (!choice.curve) {
    std::vector<Message> problems;
    for (const IrAttempt& a : out.attempts) problems.push_back(about(phrase(toString(a.candidate)), a.problem));
    refuse(result, say("no curve can be used ({}): add points, spread over 40 to 300 mm", listed(std::move(problems))));
    return out;
  }
  out.curve = *choice.curve;
  result.condition_number = out.curve.condition_number;
  takeCurve(out, samples, choice, options, present);
  for (const IrAttempt& attempt : out.attempts) {
    if (attempt.candidate == out.curve.candidate) result.held_out_rmse = attempt.held_out_rmse_mm;
  }
  if (out.valid_from_mm > kSensorNearest_mm + 30 || out.valid_to_mm < 150) {
    result.notes.push_back(
        say("outside {:.0f} to {:.0f} mm the sensor will count as invalid: the cloth rests at "
            "about 100 mm",
            out.valid_from_mm, out.valid_to_mm));
  }
  if (!(result.held_out_rmse <= p.ir_held_out_mm)) {
    refuse(result,
           say("held-out error {}; expected at most {:g} mm: {}", errorWithUnit(result.held_out_rmse, "mm"),
               p.ir_held_out_mm,
               !hasFewOutliers(result) ? say("average more readings at each distance, target square to the sensor")
                                       : say("measure the outliers again, or leave them out")),
           "calibration.ir_held_out_mm");
    return out;
  }
  result.verdict = {
      .accepted = true,
      .reason = say("{}: held-out error {} of at most {:g} mm, falls at every code from {:.0f} to {:.0f}", result.curve,
                    errorWithUnit(result.held_out_rmse, "mm"), p.ir_held_out_mm, result.valid_from, result.valid_to),
      .threshold = "calibration.ir_held_out_mm"};
  return out;
}

}  // namespace fyd::calibration
