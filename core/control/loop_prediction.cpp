#include "core/control/loop_prediction.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "core/control/lag_model.h"
#include "core/control/static_law.h"
#include "core/control/stiffness_controller.h"

namespace fyd::control {
namespace {

using Complex = std::complex<double>;

Complex measurement(Complex s, double delay_s, double lag_s) { return std::exp(-s * delay_s) / (s * lag_s + 1.0); }

Complex loop(double omega, const IdentifiedFabric& fabric, const ControlParameters& p) {
  const Complex s(0.0, omega);
  const Complex pid = p.kp + p.ki_per_s / s + p.kd_s * s / (p.derivative_filter_s * s + 1.0);
  const Complex error = fabric.shape_gain * measurement(s, fabric.delay_s, fabric.lag_s) -
                        measurement(s, p.measurement_delay_s, p.measurement_lag_s);
  const double learning_per_s = 1.0 / (2 * p.noise_correlation_s);
  const Complex observed = learning_per_s / (s + learning_per_s);
  return pid * (1.0 + error * observed) / (kMotorLag_s * s + 1.0);
}

struct Run {
  double overshoot_percent = 0.0;
  double settling_s = std::numeric_limits<double>::quiet_NaN();
};

Run runOnModel(const IdentifiedFabric& fabric, const ControlParameters& parameters) {
  constexpr double kSoftness = 0.7, kStep_s = 0.001, kLongest_s = 10.0, kBand = 0.05;
  ControlParameters p = parameters;
  p.mode = ControlMode::normal;
  StiffnessController controller(p);
  const StaticLaw& law = controller.law();
  const double middle_k = std::sqrt(law.minimumStiffness_N_per_mm() * law.maximumStiffness_N_per_mm());
  const double target = kSoftness * middle_k;
  const auto stiffnessAt = [&](double angle_deg) {
    return target * std::pow(law.stiffness_N_per_mm(angle_deg).value / middle_k, fabric.shape_gain);
  };
  double angle_deg = law.minimumAngle_deg();
  LagModel sensor;
  sensor.configure(fabric.delay_s, fabric.lag_s);
  sensor.reset(stiffnessAt(angle_deg));

  Run run;
  double inside_since_s = std::numeric_limits<double>::quiet_NaN();
  for (int i = 0; i * kStep_s <= kLongest_s; ++i) {
    const double time_s = i * kStep_s;
    const double stiffness = stiffnessAt(angle_deg);
    const ControlOutput output =
        controller.step({.now = instantAt(time_s),
                         .target_N_per_mm = target,
                         .measured_N_per_mm = sensor.step(stiffness, kStep_s),
                         .measured_sigma_N_per_mm = std::max(0.01, fabric.residual_rms_relative) * stiffness,
                         .observable = true,
                         .measured_angle_deg = angle_deg,
                         .measured_angle_known = true,
                         .enabled = true});
    const double reach_deg = p.rate_limit_deg_per_s * kStep_s;
    angle_deg +=
        std::clamp((output.stretch_angle_deg - angle_deg) * kStep_s / (kMotorLag_s + kStep_s), -reach_deg, reach_deg);
    run.overshoot_percent = std::max(run.overshoot_percent, 100 * (stiffness / target - 1));
    if (std::abs(stiffness / target - 1) > kBand) {
      inside_since_s = std::numeric_limits<double>::quiet_NaN();
    } else if (std::isnan(inside_since_s)) {
      inside_since_s = time_s;
    }
  }
  run.settling_s = inside_since_s;
  return run;
}

}  // namespace

LoopMargins loopMargins(const IdentifiedFabric& fabric, const ControlParameters& p) {
  constexpr int kPoints = 800;
  constexpr double kSlowest_rad_s = 1e-2, kFastest_rad_s = 1e3;
  LoopMargins margins{std::numeric_limits<double>::infinity(), 180.0};
  if (p.kp == 0 && p.ki_per_s == 0 && p.kd_s == 0) return margins;  // no loop
  Complex last;
  double phase_deg = 0.0, last_phase_deg = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double omega =
        kSlowest_rad_s * std::pow(kFastest_rad_s / kSlowest_rad_s, static_cast<double>(i) / (kPoints - 1));
    const Complex value = loop(omega, fabric, p);
    phase_deg = i == 0 ? std::arg(value) * 180 / std::numbers::pi
                       : last_phase_deg + std::arg(value / last) * 180 / std::numbers::pi;
    if (i > 0) {
      const bool crosses_phase = std::floor((phase_deg + 180) / 360) != std::floor((last_phase_deg + 180) / 360);
      if (crosses_phase) margins.gain_margin = std::min(margins.gain_margin, 1 / std::abs(value));
      if ((std::abs(value) < 1) != (std::abs(last) < 1)) {
        margins.phase_margin_deg = std::min(margins.phase_margin_deg, 180 + phase_deg);
      }
    }
    last = value;
    last_phase_deg = phase_deg;
  }
  return margins;
}

LoopPrediction predictLoop(const IdentifiedFabric& fabric, const ControlParameters& parameters) {
  const Run run = runOnModel(fabric, parameters);
  LoopPrediction prediction;
  prediction.margins = loopMargins(fabric, parameters);
  prediction.overshoot_percent = run.overshoot_percent;
  prediction.settling_s = run.settling_s;
  prediction.stable =
      prediction.margins.gain_margin > 1 && prediction.margins.phase_margin_deg > 0 && !std::isnan(run.settling_s);
  return prediction;
}

}  // namespace fyd::control
