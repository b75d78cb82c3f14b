#include "core/control/loop_prediction.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "core/base/portable_math.h"
#include "core/control/lag_model.h"
#include "core/control/static_law.h"
#include "core/control/stiffness_controller.h"

namespace fyd::control {
namespace {

using Complex = std::complex<double>;

Complex measurement(Complex s, double delay_s, double lag_s) { return math::exp(-s * delay_s) / (s * lag_s + 1.0); }

Complex loop(double omega, const IdentifiedCloth& cloth, const ControlParameters& p) {
  const Complex s(0.0, omega);
  const Complex pid = p.kp + p.ki_per_s / s + p.kd_s * s / (p.derivative_filter_s * s + 1.0);
  const Complex error = cloth.shape_gain * measurement(s, cloth.delay_s, cloth.lag_s) -
                        measurement(s, p.measurement_delay_s, p.measurement_lag_s);
  const double learning_per_s = 1.0 / (2 * p.noise_correlation_s);
  const Complex observed = learning_per_s / (s + learning_per_s);
  return pid * (1.0 + error * observed) / (kMotorLag_s * s + 1.0);
}

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep_s = 0.001, kLongest_s = 10.0, kBand = 0.05, kSteady_s = 2.0;

struct Run {
  double rise_s = kNever;
  double overshoot_percent = 0.0;
  double settling_s = kNever;
  double steady_error_percent = 0.0;
};

/// @param relative the stiffness at every step, as a share of the target
Run judge(const std::vector<double>& relative) {
  Run run;
  const double way = 1.0 - relative.front();
  double tenth_s = kNever;
  const auto steady_from = relative.size() - static_cast<std::size_t>(kSteady_s / kStep_s);
  for (std::size_t i = 0; i < relative.size(); ++i) {
    const double time_s = static_cast<double>(i) * kStep_s;
    const double gone = way != 0 ? (relative[i] - relative.front()) / way : 1.0;
    if (std::isnan(tenth_s) && gone >= 0.1) tenth_s = time_s;
    if (std::isnan(run.rise_s) && gone >= 0.9) run.rise_s = time_s - tenth_s;
    run.overshoot_percent = std::max(run.overshoot_percent, 100 * (relative[i] - 1));
    const double off = std::abs(relative[i] - 1);
    if (!(off <= kBand)) {
      run.settling_s = kNever;
    } else if (std::isnan(run.settling_s)) {
      run.settling_s = time_s;
    }
    if (i >= steady_from) run.steady_error_percent += 100 * off / static_cast<double>(relative.size() - steady_from);
  }
  return run;
}

Run runOnModel(const IdentifiedCloth& cloth, const ControlParameters& parameters, std::vector<LoopPoint>* course) {
  constexpr double kSoftness = 0.7;
  constexpr int kThin = 10;
  ControlParameters p = parameters;
  p.measurement_bias = 0.0;  // the model's measurement has no lasting error, and gains do not affect one
  p.mode = ControlMode::normal;
  StiffnessController controller(p);
  const StaticLaw& law = controller.law();
  const double middle_k = std::sqrt(law.minimumStiffness_N_per_mm() * law.maximumStiffness_N_per_mm());
  const double target = kSoftness * middle_k;
  const auto stiffnessAt = [&](double angle_deg) {
    return target * math::pow(law.stiffness_N_per_mm(angle_deg).value / middle_k, cloth.shape_gain);
  };
  double angle_deg = law.minimumAngle_deg();
  LagModel sensor;
  sensor.configure(cloth.delay_s, cloth.lag_s);
  sensor.reset(stiffnessAt(angle_deg));

  std::vector<double> relative;
  relative.reserve(static_cast<std::size_t>(kLongest_s / kStep_s) + 1);
  if (course != nullptr) course->clear();
  for (int i = 0; i * kStep_s <= kLongest_s; ++i) {
    const double time_s = i * kStep_s;
    const double stiffness = stiffnessAt(angle_deg);
    relative.push_back(stiffness / target);
    if (course != nullptr && i % kThin == 0) course->push_back({time_s, relative.back(), angle_deg});
    const ControlOutput output =
        controller.step({.now = instantAt(time_s),
                         .target_N_per_mm = target,
                         .measured_N_per_mm = sensor.step(stiffness, kStep_s),
                         .measured_sigma_N_per_mm = std::max(0.01, cloth.residual_rms_relative) * stiffness,
                         .observable = true,
                         .measured_angle_deg = angle_deg,
                         .measured_angle_known = true,
                         .enabled = true});
    const double reach_deg = p.rate_limit_deg_per_s * kStep_s;
    angle_deg +=
        std::clamp((output.stretch_angle_deg - angle_deg) * kStep_s / (kMotorLag_s + kStep_s), -reach_deg, reach_deg);
  }
  return judge(relative);
}

}  // namespace

LoopMargins loopMargins(const IdentifiedCloth& cloth, const ControlParameters& p) {
  constexpr int kPoints = 800;
  constexpr double kSlowest_rad_s = 1e-2, kFastest_rad_s = 1e3;
  LoopMargins margins{std::numeric_limits<double>::infinity(), 180.0};
  if (p.kp == 0 && p.ki_per_s == 0 && p.kd_s == 0) return margins;  // no loop
  Complex last;
  double phase_deg = 0.0, last_phase_deg = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double omega =
        kSlowest_rad_s * math::pow(kFastest_rad_s / kSlowest_rad_s, static_cast<double>(i) / (kPoints - 1));
    const Complex value = loop(omega, cloth, p);
    phase_deg = i == 0 ? math::arg(value) * 180 / std::numbers::pi
                       : last_phase_deg + math::arg(value / last) * 180 / std::numbers::pi;
    if (i > 0) {
      const bool crosses_phase = std::floor((phase_deg + 180) / 360) != std::floor((last_phase_deg + 180) / 360);
      if (crosses_phase) margins.gain_margin = std::min(margins.gain_margin, 1 / math::abs(value));
      if ((math::abs(value) < 1) != (math::abs(last) < 1)) {
        margins.phase_margin_deg = std::min(margins.phase_margin_deg, 180 + phase_deg);
      }
    }
    last = value;
    last_phase_deg = phase_deg;
  }
  return margins;
}

LoopPrediction predictLoop(const IdentifiedCloth& cloth, const ControlParameters& parameters,
                           std::vector<LoopPoint>* course) {
  const Run run = runOnModel(cloth, parameters, course);
  LoopPrediction prediction;
  prediction.margins = loopMargins(cloth, parameters);
  prediction.rise_s = run.rise_s;
  prediction.overshoot_percent = run.overshoot_percent;
  prediction.settling_s = run.settling_s;
  prediction.steady_error_percent = run.steady_error_percent;
  prediction.stable =
      prediction.margins.gain_margin > 1 && prediction.margins.phase_margin_deg > 0 && !std::isnan(run.settling_s);
  return prediction;
}

IdentifiedCloth assumedCloth(const ControlParameters& p) {
  return {.delay_s = p.measurement_delay_s, .lag_s = p.measurement_lag_s, .noise_correlation_s = p.noise_correlation_s};
}

}  // namespace fyd::control
