#include "core/calibration/cloth_calibration.h"

#include <algorithm>
#include <cmath>

#include "core/calibration/cloth_fit.h"
#include "core/calibration/fit/cross_validation.h"
#include "core/sensing/indentation.h"

namespace fyd::calibration {
namespace {

using sensing::ClothEdges;

constexpr std::size_t kMostPresses = 2000;
constexpr double kFreeLimits = 2.0;           // times the uncertainty that is allowed where all edges are held
constexpr double kLeastShareLogSigma = 0.05;  // of the radius share, which depends slightly on depth and place
constexpr double kLeastRatioLogSigma = 0.04;
constexpr double kLeastShareSigma = 0.01;
constexpr double kLeastFreeShareSigma = 0.03;
constexpr double kLeastFreeRatioLogSigma = 0.3;
constexpr double kElsewhere = 1.5;      // a share between the sensors is less certain than over one
constexpr double kClearlyBetter = 1.3;  // times the other edges' error

/// Takes the presses whose sensor under the finger reads; refuses impossible ones. @return whether all are good
bool takePresses(CalibrationResult& result, const ClothSamples& s, const sensing::IndentationParameters& profile,
                 const CalibrationParameters& p, std::vector<ClothPress>& out) {
  const std::size_t sensors = profile.sensors();
  sensing::IndentationEstimator estimator(profile);
  double farthest = 0.0;
  for (std::size_t row = 0; row < s.codes.size(); ++row) {
    const sensing::IndentationEstimate read =
        estimator.once({.codes = s.codes[row], .x_mm = s.x_mm[row], .y_mm = s.y_mm[row]});
    ClothPress press{.contact = {.x_mm = s.x_mm[row], .y_mm = s.y_mm[row], .area_mm2 = s.area_mm2[row]}, .row = row};
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sensors; ++i) {
      press.drops[i] = {
          .drop_mm = profile.ir_offset_mm[i] - read.distance_mm[i], .sigma_mm = kPressNoise_mm, .used = read.valid[i]};
      const double away = std::hypot(s.x_mm[row] - profile.ir_x_mm[i], s.y_mm[row] - profile.ir_y_mm[i]);
      if (away < nearest) {
        nearest = away;
        press.over = i;
      }
    }
    farthest = std::max(farthest, nearest);
    if (nearest > p.cloth_beside_mm || !press.drops[press.over].used) continue;
    out.push_back(press);
  }
  if (out.empty()) {
    refuse(result,
           say("no press is within {:g} mm of a distance sensor that reads: press over each sensor", p.cloth_beside_mm),
           "calibration.cloth_beside_mm");
    return false;
  }
  if (out.size() < s.codes.size()) {
    result.notes.push_back(
        say("{} of {} presses are more than {:g} mm beside a sensor (up to {:.1f} mm), or over one that does "
            "not read; they "
            "tell no depth and were left out",
            s.codes.size() - out.size(), s.codes.size(), p.cloth_beside_mm, farthest));
  }
  return true;
}

/// Of each sensor, whether it reads in any press.
std::vector<bool> readingSensors(const std::vector<ClothPress>& presses, std::size_t sensors) {
  std::vector<bool> reads(sensors, false);
  for (const ClothPress& press : presses) {
    for (std::size_t i = 0; i < sensors; ++i) reads[i] = reads[i] || press.drops[i].used;
  }
  return reads;
}

/// Refuses presses that cannot determine the unknowns. @return whether they can
bool enoughPresses(ClothCalibration& out, const std::vector<ClothPress>& presses, std::size_t sensors,
                   const CalibrationParameters& p) {
  out.sensors.assign(sensors, {});
  const std::vector<bool> reads = readingSensors(presses, sensors);
  for (const ClothPress& press : presses) {
    ClothSensor& sensor = out.sensors[press.over];
    const double depth = press.drops[press.over].drop_mm;
    sensor.presses += 1;
    sensor.shallowest_mm = std::isnan(sensor.shallowest_mm) ? depth : std::min(sensor.shallowest_mm, depth);
    sensor.deepest_mm = std::isnan(sensor.deepest_mm) ? depth : std::max(sensor.deepest_mm, depth);
  }
  CalibrationResult& result = out.result;
  std::size_t pressed = 0;
  for (std::size_t i = 0; i < sensors; ++i) pressed += out.sensors[i].presses > 0 ? 1 : 0;
  for (std::size_t i = 0; i < sensors; ++i) {
    const ClothSensor& sensor = out.sensors[i];
    if (sensor.presses == 0) {
      if (!reads[i] && pressed >= 2) {
        result.notes.push_back(say("distance sensor {} did not read in any press", i + 1));
        continue;
      }
      refuse(result, say("no press over distance sensor {}: press over each sensor, at two depths", i + 1));
      return false;
    }
    if (!(sensor.deepest_mm >= p.cloth_least_depth_mm)) {
      refuse(result,
             say("the deepest press over distance sensor {} is {:.2f} mm; expected at least {:g} mm: "
                 "press deeper there",
                 i + 1, sensor.deepest_mm, p.cloth_least_depth_mm),
             "calibration.cloth_least_depth_mm");
      return false;
    }
    if (!(sensor.shallowest_mm > 0.0) || !(sensor.deepest_mm >= p.cloth_depth_ratio * sensor.shallowest_mm)) {
      refuse(result,
             say("the presses over distance sensor {} are all about equally deep ({:.2f} to {:.2f} mm); "
                 "expected {:g} times as deep at the deepest: press there at two depths",
                 i + 1, sensor.shallowest_mm, sensor.deepest_mm, p.cloth_depth_ratio),
             "calibration.cloth_depth_ratio");
      return false;
    }
  }
  return true;
}

/// Relative uncertainty of the indentation over the cloth, by the calibrated mode itself; the stiffness has the same.
/// @param reads which sensors the mode will have
double doubtOverTheCloth(const sensing::IndentationParameters& calibrated, const ClothSamples& s,
                         const std::vector<bool>& reads) {
  constexpr double kDepth_mm = 4.0;
  double area_mm2 = 0.0;
  for (const double area : s.area_mm2) area_mm2 += area / static_cast<double>(s.area_mm2.size());
  sensing::ContactCloth cloth(calibrated);
  double squares = 0.0;
  int places = 0;
  for (const double x : {-0.5, 0.0, 0.5}) {
    for (const double y : {-0.5, 0.0, 0.5}) {
      const sensing::Contact contact{
          .x_mm = x * calibrated.frame_half_width_mm, .y_mm = y * calibrated.frame_half_depth_mm, .area_mm2 = area_mm2};
      cloth.press(contact, kDepth_mm);
      std::array<sensing::Drop, sensing::kMaximumIrSensors> drops;
      for (std::size_t i = 0; i < reads.size(); ++i) {
        drops[i] = {.drop_mm = cloth.share(i) * kDepth_mm, .sigma_mm = kPressNoise_mm, .used = reads[i]};
      }
      const sensing::ClothDepth depth = cloth.solve(contact, std::span(drops).first(reads.size()));
      squares += depth.variance_mm2 / (depth.indentation_mm * depth.indentation_mm);
      ++places;
    }
  }
  return std::sqrt(squares / places);
}

/// Of what the sensors beside the finger read, for each press.
struct Errors {
  std::vector<double> mm;
  std::vector<double> relative;  ///< to the depth
};

/// Of presses that the fit has not seen; NaN where no fit could be made.
Errors heldOut(const ClothFitter& fitter, const std::vector<ClothPress>& presses, ClothEdges edges) {
  std::vector<std::size_t> folds;
  folds.reserve(presses.size());
  for (const ClothPress& press : presses) folds.push_back(press.over);
  Errors out;
  out.relative.assign(presses.size(), kUnknown);
  out.mm = predictHeldOut(
      folds,
      [&](const std::vector<std::size_t>& learn) {
        std::vector<ClothPress> part;
        part.reserve(learn.size());
        for (const std::size_t i : learn) part.push_back(presses[i]);
        return fitter.fit(part, edges);
      },
      [&](const ClothFit& fit, std::size_t i) {
        const ClothModel::Prediction seen = fitter.model(edges, fit.at).predict(presses[i], fitter.sensors());
        out.relative[i] = seen.error_mm / seen.depth_mm;
        return seen.error_mm;
      });
  return out;
}

}  // namespace

ClothCalibration calibrateCloth(const ClothSamples& s, const sensing::IndentationParameters& profile,
                                const CalibrationParameters& p) {
  ClothCalibration out;
  CalibrationResult& result = out.result;
  result = {.procedure = "cloth",
            .curve = say("membrane: radius share and tension ratio"),
            .unit = "mm",
            .points = s.codes.size(),
            .valid_unit = "mm"};
  const std::size_t sensors = profile.sensors();
  for (std::size_t sensor = 0; sensor < sensors; ++sensor) {
    SampleColumn& column = result.samples.emplace_back();
    column = {.name = fmt::format("adc{}", sensor + 1), .unit = "counts"};
    for (const auto& press : s.codes) column.values.push_back(sensor < press.size() ? press[sensor] : kUnknown);
  }
  result.samples.insert(result.samples.end(),
                        {{"x_mm", "mm", s.x_mm}, {"y_mm", "mm", s.y_mm}, {"area_mm2", "mm²", s.area_mm2}});
  if (s.x_mm.size() != s.codes.size() || s.y_mm.size() != s.codes.size() || s.area_mm2.size() != s.codes.size()) {
    refuse(result, say("the columns differ in length"));
    return out;
  }
  if (s.codes.size() > kMostPresses) {
    refuse(result, say("{} presses; at most {}: take the mean of each press", s.codes.size(), kMostPresses));
    return out;
  }
  if (profile.ir_offset_mm.size() < sensors) {
    refuse(result,
           say("sensing.ir_offset_mm has {} values for {} sensors: tare first", profile.ir_offset_mm.size(), sensors));
    return out;
  }
  bool good = checkColumn(result, "x_mm", s.x_mm, -profile.frame_half_width_mm, profile.frame_half_width_mm);
  good = checkColumn(result, "y_mm", s.y_mm, -profile.frame_half_depth_mm, profile.frame_half_depth_mm) && good;
  if (!checkColumn(result, "area_mm2", s.area_mm2, 0.1, 10'000) || !good) return out;
  std::vector<ClothPress> presses;
  if (!takePresses(result, s, profile, p, presses) || !enoughPresses(out, presses, sensors, p)) return out;

  const ClothFitter fitter(profile, sensors);
  const auto held = fitter.fit(presses, ClothEdges::held), rollers = fitter.fit(presses, ClothEdges::rollers);
  if (!held || !rollers) {
    refuse(result, say("too few readings beside the finger: at least two sensors must read in each press"));
    return out;
  }
  const auto errorsOf = [&](ClothEdges edges, const ClothFit& fit) {
    Errors errors;
    ClothModel model = fitter.model(edges, fit.at);
    for (const ClothPress& press : presses) {
      const ClothModel::Prediction prediction = model.predict(press, sensors);
      errors.mm.push_back(prediction.error_mm);
      errors.relative.push_back(prediction.error_mm / prediction.depth_mm);
    }
    return errors;
  };
  const Errors of_held = errorsOf(ClothEdges::held, *held), of_rollers = errorsOf(ClothEdges::rollers, *rollers);
  const bool free = rootMeanSquare(of_rollers.mm) < rootMeanSquare(of_held.mm);
  out.edges = free ? ClothEdges::rollers : ClothEdges::held;
  const ClothFit& fit = free ? *rollers : *held;
  const Errors& errors = free ? of_rollers : of_held;
  const ClothUnknowns at = fit.at;
  out.other_edges_rmse = rootMeanSquare(free ? of_held.mm : of_rollers.mm);
  result.rmse = rootMeanSquare(errors.mm);
  for (const double error : errors.mm)
    result.max_residual = std::fmax(result.max_residual, error);  // NaN is passed over
  result.residuals.assign(s.codes.size(), kUnknown);
  result.valid_from = std::numeric_limits<double>::infinity();
  result.valid_to = 0.0;
  for (std::size_t i = 0; i < presses.size(); ++i) {
    result.residuals[presses[i].row] = errors.mm[i];
    const double depth = presses[i].drops[presses[i].over].drop_mm;
    result.valid_from = std::min(result.valid_from, depth);
    result.valid_to = std::max(result.valid_to, depth);
  }
  result.condition_number = fit.condition_number;
  const double share = std::exp(at.log_share), ratio = std::exp(at.log_ratio);
  const double share_part = std::sqrt(std::max(fit.covariance(0, 0), 0.0));
  const double ratio_part = std::sqrt(std::max(fit.covariance(1, 1), 0.0));
  result.coefficients = {{std::string(sentence("radius share")), "1", share, share * share_part},
                         {std::string(sentence("tension ratio")), "1", ratio, ratio * ratio_part}};
  const Errors held_out = heldOut(fitter, presses, out.edges);
  result.held_out_rmse = rootMeanSquare(held_out.mm);

  const double share_limit = p.cloth_share_percent * (free ? kFreeLimits : 1.0);
  const double ratio_limit = p.cloth_ratio_percent * (free ? kFreeLimits : 1.0);
  if (!(100.0 * share_part <= share_limit) || !(100.0 * ratio_part <= ratio_limit)) {
    refuse(result,
           say("the radius share {:.2f} is known only to {:.0f} % and the tension ratio {:.2f} to {:.0f} %; expected "
               "at most {:g} % and {:g} %: hold each press longer, so that its mean has less noise, and press deeper",
               share, 100.0 * share_part, ratio, 100.0 * ratio_part, share_limit, ratio_limit),
           "calibration.cloth_share_percent");
    return out;
  }
  if (!(result.held_out_rmse <= p.cloth_held_out_mm)) {
    refuse(result,
           say("held-out error {}; expected at most {:g} mm: tare, and press straight down over "
               "the middle of each sensor",
               errorWithUnit(result.held_out_rmse, "mm"), p.cloth_held_out_mm),
           "calibration.cloth_held_out_mm");
    return out;
  }
  if (out.other_edges_rmse < kClearlyBetter * result.rmse) {
    result.notes.push_back(
        say("held and free edges fit nearly alike (error {:.2f} and {:.2f} mm): the edges are not proven", result.rmse,
            out.other_edges_rmse));
  }
  out.share_sigma =
      std::max(free ? kLeastFreeShareSigma : kLeastShareSigma, kElsewhere * rootMeanSquare(errors.relative));
  result.changes = {
      {"sensing.indentation_mode", "contact"},
      {"sensing.contact_radius_share", fmt::format("{:.6g}", std::min(share, 1.3))},
      {"sensing.contact_radius_share_sigma",
       fmt::format("{:.6g}", share * std::hypot(share_part, kLeastShareLogSigma))},
      {"sensing.cloth_edges", std::string(sensing::kClothEdgesNames[static_cast<std::size_t>(out.edges)])},
      {"sensing.cloth_tension_ratio", fmt::format("{:.6g}", ratio)},
      {"sensing.cloth_tension_ratio_sigma",
       fmt::format("{:.6g}", std::hypot(ratio_part, free ? kLeastFreeRatioLogSigma : kLeastRatioLogSigma))},
      {"sensing.cloth_share_sigma", fmt::format("{:.6g}", std::min(out.share_sigma, 0.5))}};
  sensing::IndentationParameters calibrated = profile;
  if (const auto applied = applyChanges(bindParameters(calibrated), result.changes); !applied) {
    refuse(result, applied.error().message);
    return out;
  }
  out.stiffness_error = std::max({doubtOverTheCloth(calibrated, s, readingSensors(presses, sensors)),
                                  rootMeanSquare(errors.relative), rootMeanSquare(held_out.relative)});
  // The loop needs a bound, not one standard deviation.
  result.changes.push_back(
      {"control.measurement_bias", fmt::format("{:.3g}", std::min(2.0 * out.stiffness_error, 1.0))});
  result.verdict = {
      .accepted = true,
      .reason = free ? say("held-out error {} of at most {:g} mm; radius share {:.3f} ± {:.3f}, tension ratio {:.2f} ± "
                           "{:.2f}; front and back edges are free: this cloth cannot be known better from such presses "
                           "(about 0.7 mm and 20 % of stiffness)",
                           errorWithUnit(result.held_out_rmse, "mm"), p.cloth_held_out_mm, share, share * share_part,
                           ratio, ratio * ratio_part)
                     : say("held-out error {} of at most {:g} mm; radius share {:.3f} ± {:.3f}, tension ratio {:.2f} ± "
                           "{:.2f}; all edges are held",
                           errorWithUnit(result.held_out_rmse, "mm"), p.cloth_held_out_mm, share, share * share_part,
                           ratio, ratio * ratio_part),
      .threshold = "calibration.cloth_held_out_mm"};
  return out;
}

}  // namespace fyd::calibration
