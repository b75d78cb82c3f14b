#include "core/control/loop_prediction.h"

#include <algorithm>
#include <array>
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

constexpr double kMotorSpeed_deg_s = 180.0;

Complex measurement(Complex s, double delay_s, double lag_s) { return math::exp(-s * delay_s) / (s * lag_s + 1.0); }

struct Gains {
  double kp, ki, kd;
  [[nodiscard]] bool any() const { return kp != 0 || ki != 0 || kd != 0; }
};

Gains loopGainsOf(const ControlParameters& p) {
  if (p.mode == ControlMode::thesis) return {p.thesis_kp, p.thesis_ki, p.thesis_kd};
  return {p.kp, p.ki_per_s, p.kd_s};
}

/// Where the law is steepest within its travel.
double steepest_N_per_mm_deg(const ControlParameters& p) {
  constexpr int kPlaces = 64;
  StaticLaw law(p);
  law.limitTravel(p.travel_minimum_deg, p.travel_maximum_deg);
  const double from = law.minimumAngle_deg(), span = law.maximumAngle_deg() - from;
  double steepest = 0.0;
  for (int i = 0; i <= kPlaces; ++i)
    steepest = std::max(steepest, law.slope_N_per_mm_deg(from + span * static_cast<double>(i) / kPlaces));
  return steepest;
}

/// L(s) as the header has it; what does not depend on s is computed once.
class Loop {
 public:
  Loop(const IdentifiedCloth& cloth, const ControlParameters& p, const LoopTiming& timing)
      : cloth_(cloth),
        p_(p),
        gains_(loopGainsOf(p)),
        thesis_(p.mode == ControlMode::thesis),
        dead_s_(timing.deadTime_s()) {
    if (!thesis_) return;
    slope_ = cloth.shape_gain * steepest_N_per_mm_deg(p);
    dead_s_ += 0.5e-3 * p.thesis_period_ms;
  }
  [[nodiscard]] bool any() const { return gains_.any(); }
  [[nodiscard]] Complex at(double omega) const {
    const Complex s(0.0, omega);
    const Complex pid = gains_.kp + gains_.ki / s + gains_.kd * s / (p_.derivative_filter_s * s + 1.0);
    const Complex gear = kMotorLag_s / 2 * s + 1.0;
    const Complex driven = pid * math::exp(-s * dead_s_) / (gear * gear);
    const Complex seen = cloth_.shape_gain * measurement(s, cloth_.delay_s, cloth_.lag_s);
    if (thesis_) return driven * (slope_ / cloth_.shape_gain) * seen;
    const double learning_per_s = 1.0 / (2 * p_.noise_correlation_s);
    const Complex observed = learning_per_s / (s + learning_per_s);
    return driven * (1.0 + (seen - measurement(s, p_.measurement_delay_s, p_.measurement_lag_s)) * observed);
  }

 private:
  const IdentifiedCloth& cloth_;
  const ControlParameters& p_;
  Gains gains_;
  bool thesis_;
  double dead_s_;
  double slope_ = 0.0;
};

/// Gear and position loop as two lags, with the motors' speed limit; the command arrives after the loop's dead time.
class Motors {
 public:
  Motors(double angle_deg, double dead_s)
      : angle_deg_(angle_deg),
        // The run itself holds a command for a step.
        under_way_(static_cast<std::size_t>(std::max(1L, std::lround(dead_s / LoopTiming::kStep_s))), angle_deg) {}
  double angle_deg() const { return angle_deg_; }
  void step(double reference_deg) {
    constexpr double kLag_s = kMotorLag_s / 2, dt_s = LoopTiming::kStep_s;
    under_way_[next_] = reference_deg;
    next_ = (next_ + 1) % under_way_.size();
    const double pull = (under_way_[next_] - angle_deg_) / kLag_s - 2 * speed_deg_s_;
    speed_deg_s_ = std::clamp(speed_deg_s_ + pull / kLag_s * dt_s, -kMotorSpeed_deg_s, kMotorSpeed_deg_s);
    angle_deg_ += speed_deg_s_ * dt_s;
  }

 private:
  double angle_deg_;
  double speed_deg_s_ = 0.0;
  std::vector<double> under_way_;
  std::size_t next_ = 0;
};

/// Noise of the measurement, as a share of it: slow, as the estimate's is, and the same in every run.
double noiseAt(double time_s, double sigma) {
  constexpr std::array kTones_Hz = {0.13, 0.31, 0.53, 0.89, 1.39, 2.23};
  double sum = 0.0;
  for (std::size_t i = 0; i < kTones_Hz.size(); ++i)
    sum += math::sin(2 * std::numbers::pi * kTones_Hz[i] * time_s + 2.4 * static_cast<double>(i));
  return sigma * sum * std::sqrt(2.0 / static_cast<double>(kTones_Hz.size()));
}

/// Swings up or down of at least 1.5°.
class Swings {
 public:
  void see(double angle_deg) {
    constexpr double kSwing_deg = 1.5;
    lowest_ = std::min(lowest_, angle_deg);
    highest_ = std::max(highest_, angle_deg);
    if (direction_ <= 0 && angle_deg > lowest_ + kSwing_deg) {
      direction_ = 1;
      highest_ = angle_deg;
      ++count_;
    } else if (direction_ >= 0 && angle_deg < highest_ - kSwing_deg) {
      direction_ = -1;
      lowest_ = angle_deg;
      ++count_;
    }
  }
  [[nodiscard]] bool many() const { return count_ > 3; }

 private:
  double lowest_ = std::numeric_limits<double>::infinity(), highest_ = -lowest_;
  int direction_ = 0, count_ = 0;
};

constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
constexpr double kStep_s = LoopTiming::kStep_s, kLongest_s = 10.0, kBand = 0.05, kSteady_s = 2.0;

struct Run {
  double rise_s = kNever;
  double overshoot_percent = 0.0;
  double settling_s = kNever;
  double steady_error_percent = 0.0;
  bool swings_early = false;  ///< in the first half
  bool swings_late = false;
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

Run runOnModel(const IdentifiedCloth& cloth, const ControlParameters& parameters, const LoopTiming& timing,
               std::vector<LoopPoint>* course) {
  constexpr double kSoftness = 0.7;
  constexpr int kThin = 10;
  constexpr double kLeastNoise = 0.015;  // of the simulated touchpad's stiffness, as a share
  ControlParameters p = parameters;
  p.measurement_bias = 0.0;                 // the model's measurement has no lasting error, and gains do not affect one
  p.correction_limit = kNoCorrectionLimit;  // the model's cloth is softer than its law on purpose: no contradiction
  StiffnessController controller(p);
  const StaticLaw& law = controller.law();
  const double middle_k = std::sqrt(law.minimumStiffness_N_per_mm() * law.maximumStiffness_N_per_mm());
  const double target = kSoftness * middle_k;
  const auto stiffnessAt = [&](double angle_deg) {
    return target * math::pow(law.stiffness_N_per_mm(angle_deg).value / middle_k, cloth.shape_gain);
  };
  Motors motors(law.minimumAngle_deg(), timing.deadTime_s());
  LagModel sensor;
  sensor.configure(cloth.delay_s, cloth.lag_s);
  sensor.reset(stiffnessAt(motors.angle_deg()));
  Swings early, late;
  // Mode default keeps noise out of the stretch by its observer; mode thesis acts on it.
  const double noise = p.mode == ControlMode::thesis ? std::max(kLeastNoise, cloth.residual_rms_relative) : 0.0;

  std::vector<double> relative;
  relative.reserve(static_cast<std::size_t>(kLongest_s / kStep_s) + 1);
  if (course != nullptr) course->clear();
  for (int i = 0; i * kStep_s <= kLongest_s; ++i) {
    const double time_s = i * kStep_s;
    const double angle_deg = motors.angle_deg();
    const double stiffness = stiffnessAt(angle_deg);
    (time_s < kLongest_s / 2 ? early : late).see(angle_deg);
    relative.push_back(stiffness / target);
    if (course != nullptr && i % kThin == 0) course->push_back({time_s, relative.back(), angle_deg});
    const ControlOutput output =
        controller.step({.now = instantAt(time_s),
                         .target_N_per_mm = target,
                         .measured_N_per_mm = sensor.step(stiffness, kStep_s) * (1 + noiseAt(time_s, noise)),
                         .measured_sigma_N_per_mm = std::max(0.01, cloth.residual_rms_relative) * stiffness,
                         .observable = true,
                         .measured_angle_deg = angle_deg,
                         .measured_angle_known = true,
                         .enabled = true});
    motors.step(output.stretch_angle_deg);
  }
  Run run = judge(relative);
  run.swings_early = early.many();
  run.swings_late = late.many();
  return run;
}

}  // namespace

LoopMargins loopMargins(const IdentifiedCloth& cloth, const ControlParameters& p, const LoopTiming& timing) {
  constexpr int kPoints = 1000;
  constexpr double kSlowest_rad_s = 1e-2, kFastest_rad_s = std::numbers::pi / kStep_s;  // faster than a step is nothing
  LoopMargins margins{std::numeric_limits<double>::infinity(), 180.0};
  const Loop loop(cloth, p, timing);
  if (!loop.any()) return margins;
  Complex last;
  double phase_deg = 0.0, last_phase_deg = 0.0;
  for (int i = 0; i < kPoints; ++i) {
    const double omega =
        kSlowest_rad_s * math::pow(kFastest_rad_s / kSlowest_rad_s, static_cast<double>(i) / (kPoints - 1));
    const Complex value = loop.at(omega);
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
  // A loop that keeps its phase up to the step's own limit is bounded by what it does there.
  margins.gain_margin = std::min(margins.gain_margin, 1 / math::abs(last));
  return margins;
}

LoopPrediction predictLoop(const IdentifiedCloth& cloth, const ControlParameters& parameters, const LoopTiming& timing,
                           std::vector<LoopPoint>* course) {
  const Run run = runOnModel(cloth, parameters, timing, course);
  LoopPrediction prediction;
  prediction.margins = loopMargins(cloth, parameters, timing);
  prediction.rise_s = run.rise_s;
  prediction.overshoot_percent = run.overshoot_percent;
  prediction.settling_s = run.settling_s;
  prediction.steady_error_percent = run.steady_error_percent;
  if (prediction.margins.gain_margin <= 1 || prediction.margins.phase_margin_deg <= 0 || run.swings_late) {
    prediction.verdict = LoopVerdict::unstable;
    prediction.settling_s = kNever;  // a swing that ends inside the band by chance settles nothing
  } else if (!std::isnan(run.settling_s)) {
    prediction.verdict = run.swings_early ? LoopVerdict::rings : LoopVerdict::settles;
  }
  return prediction;
}

IdentifiedCloth assumedCloth(const ControlParameters& p) {
  return {.delay_s = p.measurement_delay_s, .lag_s = p.measurement_lag_s, .noise_correlation_s = p.noise_correlation_s};
}

}  // namespace fyd::control
