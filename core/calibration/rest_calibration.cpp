#include "core/calibration/rest_calibration.h"

#include <algorithm>
#include <cmath>

#include "core/texture/acceleration_sample.h"

namespace fyd::calibration {
namespace {

constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
constexpr std::array<std::string_view, 3> kMeans = {sentence("mean x"), sentence("mean y"), sentence("mean z")};

Message nextAction(sensing::TareState state) {
  using sensing::TareState;
  switch (state) {
    case TareState::touched: return say("take the hand away and start again");
    case TareState::invalid_sensor: return say("look at the distance sensors' curves and at the load cell's cable");
    case TareState::unsteady: return say("let the motors and the cloth come to rest, and start again");
    case TareState::too_slow: return say("check the touchpad's connection");
    case TareState::idle: return say("start it");
    case TareState::running: return say("wait until it is done");
    case TareState::done: break;
  }
  return {};
}

}  // namespace

RestCalibration calibrateRest(const RestSamples& s, const CalibrationParameters& p) {
  RestCalibration out;
  CalibrationResult& result = out.result;
  const std::size_t count = s.axis_g[0].size();
  result = {.procedure = "rest",
            .curve = say("mean"),
            .unit = "g",
            .points = count,
            .samples = {{"x_g", "g", s.axis_g[0]}, {"y_g", "g", s.axis_g[1]}, {"z_g", "g", s.axis_g[2]}},
            .valid_unit = "g"};
  bool good = true;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (s.axis_g[axis].size() != count) {
      refuse(result, say("the three axes differ in length"));
      return out;
    }
    good = checkColumn(result, fmt::format("{}_g", kAxes[axis]), s.axis_g[axis], -texture::kLargestAcceleration_g,
                       texture::kLargestAcceleration_g) &&
           good;
  }
  if (!good) return out;
  if (count < static_cast<std::size_t>(p.rest_fewest_samples)) {
    refuseTooFew(result, say("{} samples; expected at least {}: wait longer", count, p.rest_fewest_samples),
                 "calibration.rest_fewest_samples");
    return out;
  }
  const auto n = static_cast<double>(count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double sum = 0.0, squares = 0.0;
    for (const double a : s.axis_g[axis]) sum += a;
    out.mean_g[axis] = sum / n;
    for (const double a : s.axis_g[axis]) squares += (a - out.mean_g[axis]) * (a - out.mean_g[axis]);
    out.sigma_g[axis] = std::sqrt(squares / (n - 1));
    result.coefficients.push_back({std::string(kMeans[axis]), "g", out.mean_g[axis], out.sigma_g[axis] / std::sqrt(n)});
  }
  for (std::size_t i = 0; i < count; ++i) {
    result.residuals.push_back(
        std::hypot(s.axis_g[0][i] - out.mean_g[0], s.axis_g[1][i] - out.mean_g[1], s.axis_g[2][i] - out.mean_g[2]));
  }
  result.rmse = rootMeanSquare(result.residuals);
  result.max_residual = *std::max_element(result.residuals.begin(), result.residuals.end());
  out.magnitude_g = std::hypot(out.mean_g[0], out.mean_g[1], out.mean_g[2]);
  const double widest = *std::max_element(out.sigma_g.begin(), out.sigma_g.end());
  if (widest > p.rest_sigma_g) {
    refuse(result,
           say("an axis spreads by {:.3f} g; expected at most {:g}: it moves: put the robot to rest", widest,
               p.rest_sigma_g),
           "calibration.rest_sigma_g");
    return out;
  }
  if (out.magnitude_g <= p.rest_magnitude_g && widest > 0.0) {
    result.notes.push_back(
        say("the robot's end has taken rest away before it sends: whether 1 g is 1 g is not seen here"));
    result.verdict = {.accepted = true,
                      .reason = say("at rest {:.4f} g, spread {:.4f} g", out.magnitude_g, widest),
                      .threshold = "calibration.rest_magnitude_g"};
    return out;
  }
  if (!(std::abs(out.magnitude_g - 1.0) <= p.rest_magnitude_g)) {
    refuse(result,
           say("at rest it measures {:.3f} g; expected 1 within {:g}: check the counts per g of the sensor",
               out.magnitude_g, p.rest_magnitude_g),
           "calibration.rest_magnitude_g");
    return out;
  }
  result.verdict = {.accepted = true,
                    .reason = say("at rest {:.4f} g, spread {:.4f} g", out.magnitude_g, widest),
                    .threshold = "calibration.rest_magnitude_g"};
  return out;
}

CalibrationResult judgeTare(sensing::TareState state, const sensing::TareResult& tare, double zero_N) {
  CalibrationResult result{.procedure = "no-touch", .curve = say("mean"), .unit = "mm", .valid_unit = "mm"};
  if (state != sensing::TareState::done) {
    refuse(result, about(phrase(sensing::toString(state)), nextAction(state)));
    return result;
  }
  std::vector<double> offsets, spreads;
  for (std::size_t i = 0; i < tare.sensors; ++i) {
    offsets.push_back(tare.offset_mm[i]);
    spreads.push_back(tare.spread_mm[i]);
    result.coefficients.push_back({fmt::format("offset {}", i + 1), "mm", tare.offset_mm[i], kUnknown});
  }
  result.points = tare.sensors;
  result.rmse = rootMeanSquare(spreads);
  result.changes = {{"sensing.ir_offset_mm", fmt::format("[{}]", fmt::join(offsets, ", "))},
                    {"sensing.force_zero_N", fmt::format("{}", zero_N + tare.force_N)}};
  result.verdict = {.accepted = true,
                    .reason = say("distances to the untouched cloth {} mm, spread {:.2f} mm; force {:.3f} N",
                                  fmt::format("{:.1f}", fmt::join(offsets, ", ")), result.rmse, tare.force_N),
                    .threshold = {}};
  return result;
}

}  // namespace fyd::calibration
