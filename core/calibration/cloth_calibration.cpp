#include "core/calibration/cloth_calibration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Dense>

#include "core/calibration/cross_validation.h"
#include "core/sensing/indentation.h"

namespace fyd::calibration {
namespace {

using sensing::ClothEdges;

constexpr std::size_t kMostPresses = 2000;
constexpr double kNoise_mm = 0.03;        // of a mean of readings: what makes the weights, not the uncertainty
constexpr double kHeldShareSigma = 0.01;  // likewise of a share of a held cloth
constexpr double kFreeShareSigma = 0.04;  // … of one with free edges, which narrows and wrinkles: no linear membrane
// What is believed before the first press, as logarithms; it counts where the presses say little.
constexpr double kUsualRadiusShare = 0.7, kUsualRadiusSpread = 0.3;
constexpr double kUsualFreeRatio = 12.0, kUsualFreeRatioSpread = 0.25, kUsualRatioSpread = 0.7;
constexpr double kFreeLimits = 2.0;           // times the uncertainty that is allowed where all edges are held
constexpr double kLeastShareLogSigma = 0.05;  // of the radius share: it follows the depth and the place a little
constexpr double kLeastRatioLogSigma = 0.04;
constexpr double kLeastShareSigma = 0.01;
constexpr double kLeastFreeShareSigma = 0.03;
constexpr double kLeastFreeRatioLogSigma = 0.3;
constexpr double kElsewhere = 1.5;      // a share between the sensors is less certain than over one
constexpr double kClearlyBetter = 1.3;  // times the other edges' error
constexpr double kLeastRadiusShare = 0.35, kMostRadiusShare = 1.3;
constexpr double kMostHeldRatio = 4.0;  // either way: held all round, a cloth is stretched both ways
constexpr double kLeastFreeRatio = 2.0, kMostFreeRatio = 15.0;

struct Press {
  sensing::Contact contact;
  std::array<sensing::Drop, sensing::kMaximumIrSensors> drops{};
  std::size_t row = 0;
  std::size_t over = 0;  // the sensor under the finger
};

/// What the fit looks for: logarithms, so that no step makes them negative.
struct Unknowns {
  double log_share = 0.0;
  double log_ratio = 0.0;
};

class Model {
 public:
  Model(const sensing::IndentationParameters& profile, ClothEdges edges, Unknowns at)
      : share_sigma_(edges == ClothEdges::held ? kHeldShareSigma : kFreeShareSigma), cloth_(with(profile, edges, at)) {}

  /// Adds (reading − share·indentation)/σ of each sensor; returns the indentation.
  double residuals(const Press& press, std::size_t sensors, std::vector<double>& out) {
    const double depth = cloth_.solve(press.contact, std::span(press.drops).first(sensors)).indentation_mm;
    for (std::size_t i = 0; i < sensors; ++i) {
      if (!press.drops[i].used) continue;
      const double share = cloth_.share(i);
      const double sigma = std::hypot(kNoise_mm, share_sigma_ * (1.0 - share) * depth);
      out.push_back((press.drops[i].drop_mm - share * depth) / sigma);
    }
    return depth;
  }

  /// What the sensors beside the finger read, foretold by the one under it.
  struct Foretold {
    double depth_mm = 0.0;
    double error_mm = 0.0;  // root mean square over the sensors beside; NaN: none reads
  };
  Foretold foretell(const Press& press, std::size_t sensors) {
    Foretold out{.depth_mm = press.drops[press.over].drop_mm};
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

 private:
  static sensing::IndentationParameters with(sensing::IndentationParameters p, ClothEdges edges, Unknowns at) {
    p.contact_radius_share = std::exp(at.log_share);
    p.contact_radius_share_sigma = 0.2 * p.contact_radius_share;  // the sensor under the finger counts most
    p.cloth_share_sigma = edges == ClothEdges::held ? kHeldShareSigma : kFreeShareSigma;
    p.cloth_tension_ratio = std::exp(at.log_ratio);
    p.cloth_tension_ratio_sigma = 0.2;
    p.cloth_edges = edges;
    return p;
  }

  double share_sigma_;
  sensing::ContactCloth cloth_;
};

struct Fit {
  Unknowns at;
  double cost = 0.0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Constant(kUnknown);
  double condition_number = kUnknown;
  std::vector<double> residuals;
};

class Fitter {
 public:
  Fitter(const sensing::IndentationParameters& profile, std::size_t sensors) : profile_(profile), sensors_(sensors) {}

  [[nodiscard]] std::vector<double> residuals(const std::vector<Press>& presses, ClothEdges edges, Unknowns at) const {
    std::vector<double> out;
    Model model(profile_, edges, at);
    for (const Press& press : presses) model.residuals(press, sensors_, out);
    out.push_back((at.log_share - std::log(kUsualRadiusShare)) / kUsualRadiusSpread);
    out.push_back(edges == ClothEdges::held ? at.log_ratio / kUsualRatioSpread
                                            : (at.log_ratio - std::log(kUsualFreeRatio)) / kUsualFreeRatioSpread);
    return out;
  }

  /// @return none when the presses have fewer readings than unknowns
  [[nodiscard]] std::optional<Fit> fit(const std::vector<Press>& presses, ClothEdges edges) const {
    Fit best;
    best.cost = std::numeric_limits<double>::infinity();
    for (const double ratio : {0.3, 0.6, 1.0, 1.7, 3.0, 6.0, 10.0}) {
      for (const double share : {0.6, 0.9}) start(best, presses, edges, {std::log(share), std::log(ratio)});
    }
    if (best.residuals.size() < presses.size() + 5 || !std::isfinite(best.cost)) return std::nullopt;
    double damping = 1e-3;
    for (int round = 0; round < 30; ++round) {
      const Eigen::MatrixX2d slope = jacobian(presses, edges, best.at);
      const Eigen::Map<const Eigen::VectorXd> r(best.residuals.data(),
                                                static_cast<Eigen::Index>(best.residuals.size()));
      Eigen::Matrix2d normal = slope.transpose() * slope;
      finish(best, normal, presses.size());
      normal.diagonal() *= 1.0 + damping;
      const Eigen::Vector2d step = -normal.ldlt().solve(slope.transpose() * r);
      if (!step.allFinite()) break;
      const double before = best.cost;
      start(best, presses, edges, {best.at.log_share + step[0], best.at.log_ratio + step[1]});
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

  [[nodiscard]] Model model(ClothEdges edges, Unknowns at) const { return {profile_, edges, at}; }
  [[nodiscard]] std::size_t sensors() const { return sensors_; }

 private:
  /// Takes a place when it is better than the best so far.
  void start(Fit& best, const std::vector<Press>& presses, ClothEdges edges, Unknowns at) const {
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

  [[nodiscard]] Eigen::MatrixX2d jacobian(const std::vector<Press>& presses, ClothEdges edges, Unknowns at) const {
    constexpr double kStep = 0.01;
    Eigen::MatrixX2d out;
    for (int column = 0; column < 2; ++column) {
      Unknowns low = at, high = at;
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

  static void finish(Fit& fit, const Eigen::Matrix2d& normal, std::size_t presses) {
    const double freedom = static_cast<double>(fit.residuals.size() - presses) - 4.0;
    if (!(freedom > 0.0)) return;
    fit.covariance = normal.inverse() * (fit.cost / freedom);
    const Eigen::Vector2d scale = normal.diagonal().cwiseSqrt().cwiseInverse();
    const Eigen::Vector2d values =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scale.asDiagonal() * normal * scale.asDiagonal()).eigenvalues();
    fit.condition_number = values[0] > 0.0 ? std::sqrt(values[1] / values[0]) : std::numeric_limits<double>::infinity();
  }

  const sensing::IndentationParameters& profile_;
  std::size_t sensors_;
};

/// The presses whose sensor under the finger reads; refuses what can be none. @return whether all is well
bool takePresses(CalibrationResult& result, const ClothSamples& s, const sensing::IndentationParameters& profile,
                 const CalibrationParameters& p, std::vector<Press>& out) {
  const std::size_t sensors = std::min(profile.ir_x_mm.size(), profile.ir_y_mm.size());
  sensing::IndentationEstimator estimator(profile);
  double farthest = 0.0;
  for (std::size_t row = 0; row < s.codes.size(); ++row) {
    const sensing::IndentationEstimate read =
        estimator.once({.codes = s.codes[row], .x_mm = s.x_mm[row], .y_mm = s.y_mm[row]});
    Press press{.contact = {.x_mm = s.x_mm[row], .y_mm = s.y_mm[row], .area_mm2 = s.area_mm2[row]}, .row = row};
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < sensors; ++i) {
      press.drops[i] = {
          .drop_mm = profile.ir_offset_mm[i] - read.distance_mm[i], .sigma_mm = kNoise_mm, .used = read.valid[i]};
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
    result = refused(
        std::move(result),
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

/// Refuses presses that cannot tell the unknowns. @return whether all is well
bool enoughPresses(ClothCalibration& out, const std::vector<Press>& presses, std::size_t sensors,
                   const CalibrationParameters& p) {
  out.sensors.assign(sensors, {});
  std::vector<bool> reads(sensors, false);
  for (const Press& press : presses) {
    ClothSensor& sensor = out.sensors[press.over];
    const double depth = press.drops[press.over].drop_mm;
    sensor.presses += 1;
    sensor.shallowest_mm = std::isnan(sensor.shallowest_mm) ? depth : std::min(sensor.shallowest_mm, depth);
    sensor.deepest_mm = std::isnan(sensor.deepest_mm) ? depth : std::max(sensor.deepest_mm, depth);
    for (std::size_t i = 0; i < sensors; ++i) reads[i] = reads[i] || press.drops[i].used;
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
      result = refused(std::move(result),
                       say("no press over distance sensor {}: press over each sensor, at two depths", i + 1));
      return false;
    }
    if (!(sensor.deepest_mm >= p.cloth_least_depth_mm)) {
      result = refused(std::move(result),
                       say("the deepest press over distance sensor {} is {:.2f} mm; expected at least {:g} mm: "
                           "press deeper there",
                           i + 1, sensor.deepest_mm, p.cloth_least_depth_mm),
                       "calibration.cloth_least_depth_mm");
      return false;
    }
    if (!(sensor.shallowest_mm > 0.0) || !(sensor.deepest_mm >= p.cloth_depth_ratio * sensor.shallowest_mm)) {
      result = refused(std::move(result),
                       say("the presses over distance sensor {} are all about equally deep ({:.2f} to {:.2f} mm); "
                           "expected {:g} times as deep at the deepest: press there at two depths",
                           i + 1, sensor.shallowest_mm, sensor.deepest_mm, p.cloth_depth_ratio),
                       "calibration.cloth_depth_ratio");
      return false;
    }
  }
  return true;
}

/// Errors of what the sensors beside the finger read, of presses that the fit has not seen; NaN where no fit could be
/// made.
std::vector<double> heldOut(const Fitter& fitter, const std::vector<Press>& presses, ClothEdges edges) {
  std::vector<std::size_t> folds;
  for (const Press& press : presses) folds.push_back(press.over);
  return predictHeldOut(
      folds,
      [&](const std::vector<std::size_t>& learn) {
        std::vector<Press> part;
        for (const std::size_t i : learn) part.push_back(presses[i]);
        return fitter.fit(part, edges);
      },
      [&](const Fit& fit, std::size_t i) {
        return fitter.model(edges, fit.at).foretell(presses[i], fitter.sensors()).error_mm;
      });
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
  const std::size_t sensors = std::min(profile.ir_x_mm.size(), profile.ir_y_mm.size());
  if (s.x_mm.size() != s.codes.size() || s.y_mm.size() != s.codes.size() || s.area_mm2.size() != s.codes.size()) {
    result = refused(std::move(result), say("the columns differ in length"));
    return out;
  }
  if (s.codes.size() > kMostPresses) {
    result = refused(std::move(result),
                     say("{} presses; at most {}: take the mean of each press", s.codes.size(), kMostPresses));
    return out;
  }
  if (profile.ir_offset_mm.size() < sensors) {
    result = refused(std::move(result), say("sensing.ir_offset_mm has {} values for {} sensors: tare first",
                                            profile.ir_offset_mm.size(), sensors));
    return out;
  }
  bool good = checkColumn(result, "x_mm", s.x_mm, -profile.frame_half_width_mm, profile.frame_half_width_mm);
  good = checkColumn(result, "y_mm", s.y_mm, -profile.frame_half_depth_mm, profile.frame_half_depth_mm) && good;
  if (!checkColumn(result, "area_mm2", s.area_mm2, 0.1, 10'000) || !good) return out;
  std::vector<Press> presses;
  if (!takePresses(result, s, profile, p, presses) || !enoughPresses(out, presses, sensors, p)) return out;

  const Fitter fitter(profile, sensors);
  const auto held = fitter.fit(presses, ClothEdges::held), rollers = fitter.fit(presses, ClothEdges::rollers);
  if (!held || !rollers) {
    result = refused(std::move(result),
                     say("too few readings beside the finger: at least two sensors must read in each press"));
    return out;
  }
  struct Errors {
    std::vector<double> mm, relative;
  };
  const auto errorsOf = [&](ClothEdges edges, const Fit& fit) {
    Errors errors;
    Model model = fitter.model(edges, fit.at);
    for (const Press& press : presses) {
      const Model::Foretold foretold = model.foretell(press, sensors);
      errors.mm.push_back(foretold.error_mm);
      errors.relative.push_back(foretold.error_mm / foretold.depth_mm);
    }
    return errors;
  };
  const Errors of_held = errorsOf(ClothEdges::held, *held), of_rollers = errorsOf(ClothEdges::rollers, *rollers);
  const bool free = rootMeanSquare(of_rollers.mm) < rootMeanSquare(of_held.mm);
  out.edges = free ? ClothEdges::rollers : ClothEdges::held;
  const Fit& fit = free ? *rollers : *held;
  const Errors& errors = free ? of_rollers : of_held;
  const Unknowns at = fit.at;
  out.other_edges_rmse = rootMeanSquare(free ? of_held.mm : of_rollers.mm);
  result.rmse = rootMeanSquare(errors.mm);
  result.max_residual = *std::max_element(errors.mm.begin(), errors.mm.end());
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
  result.coefficients = {{"radius share", "1", share, share * share_part},
                         {"tension ratio", "1", ratio, ratio * ratio_part}};
  result.held_out_rmse = rootMeanSquare(heldOut(fitter, presses, out.edges));

  const double share_limit = p.cloth_share_percent * (free ? kFreeLimits : 1.0);
  const double ratio_limit = p.cloth_ratio_percent * (free ? kFreeLimits : 1.0);
  if (!(100.0 * share_part <= share_limit) || !(100.0 * ratio_part <= ratio_limit)) {
    result = refused(
        std::move(result),
        say("the radius share {:.2f} is known only to {:.0f} % and the tension ratio {:.2f} to {:.0f} %; expected "
            "at most {:g} % and {:g} %: hold each press longer, so that its mean has less noise, and press deeper",
            share, 100.0 * share_part, ratio, 100.0 * ratio_part, share_limit, ratio_limit),
        "calibration.cloth_share_percent");
    return out;
  }
  if (!(result.held_out_rmse <= p.cloth_held_out_mm)) {
    result = refused(std::move(result),
                     say("held-out error {:.2f} mm; expected at most {:g} mm: tare, and press straight down over "
                         "the middle of each sensor",
                         result.held_out_rmse, p.cloth_held_out_mm),
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
  result.verdict = {
      .accepted = true,
      .reason =
          free
              ? say("held-out error {:.2f} mm of at most {:g} mm; radius share {:.3f} ± {:.3f}, tension ratio {:.2f} ± "
                    "{:.2f}; front and back edges are free: this cloth cannot be known better from such presses "
                    "(about 0.6 mm and 20 % of stiffness)",
                    result.held_out_rmse, p.cloth_held_out_mm, share, share * share_part, ratio, ratio * ratio_part)
              : say("held-out error {:.2f} mm of at most {:g} mm; radius share {:.3f} ± {:.3f}, tension ratio {:.2f} ± "
                    "{:.2f}; all edges are held",
                    result.held_out_rmse, p.cloth_held_out_mm, share, share * share_part, ratio, ratio * ratio_part),
      .threshold = "calibration.cloth_held_out_mm"};
  return out;
}

}  // namespace fyd::calibration
