#include "core/control/stiffness_controller.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/portable_math.h"

namespace fyd::control {
namespace {

constexpr double kLongestStep_s = 0.02;  // the step reports a fault after a longer gap (core/pipeline/pipeline.cpp)
// The motors travel while rollers and reference are further apart than this, which is more than friction leaves, and
// for a moment longer, until the last degrees are done.
constexpr double kTravelling_deg = 3.0;
constexpr double kArriving_s = 0.15;
// Low-pass for the place factor: place and depth, measured 10 to 30 times a second, make it vary by a few per cent.
constexpr double kPlaceTime_s = 0.25;
constexpr double kAtLimit_deg = 0.05;       // half an encoder count
constexpr double kClampHysteresis = 0.005;  // relative, so that noise does not toggle the flag
// The thesis' conditions [thesis §4.1.4].
constexpr double kThesisLeastStiffness_N_per_mm = 0.1;
constexpr double kThesisDeadBand_N_per_mm = 0.01;
constexpr PidLimits kNoWindupLimit{-1e6, 1e6, 1e300};  // the printed PI has none
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

bool isTarget(double stiffness_N_per_mm) { return std::isfinite(stiffness_N_per_mm) && stiffness_N_per_mm > 0; }

bool isMeasured(const ControlInput& input) {
  return input.observable && std::isfinite(input.measured_N_per_mm) && input.measured_N_per_mm > 1e-3 &&
         input.measured_N_per_mm < 1e3;
}

/// The error without its first `band` on either side.
double beyond(double error, double band) { return error > band ? error - band : (error < -band ? error + band : 0.0); }

PidGains gainsOf(const ControlParameters& p) { return {p.kp, p.ki_per_s, p.kd_s, p.derivative_filter_s}; }
PidGains thesisGainsOf(const ControlParameters& p) {
  return {p.thesis_kp, p.thesis_ki, p.thesis_kd, p.derivative_filter_s};
}

}  // namespace

StiffnessController::StiffnessController(const ControlParameters& parameters)
    : parameters_(parameters),
      law_(parameters),
      pid_(gainsOf(parameters), {}, kLongestStep_s),
      thesis_pid_(thesisGainsOf(parameters), kNoWindupLimit, 1.0) {
  configure(parameters);
  reset(kNone);
}

void StiffnessController::configure(const ControlParameters& parameters) {
  parameters_ = parameters;
  law_.configure(parameters.law, parameters.law_angle_deg, parameters.law_stiffness_N_per_mm);
  law_.limitTravel(parameters.travel_minimum_deg, parameters.travel_maximum_deg);
  pid_.setGains(gainsOf(parameters));
  thesis_pid_.setGains(thesisGainsOf(parameters));
  lag_.configure(parameters.measurement_delay_s, parameters.measurement_lag_s);
  scale_.configure(parameters.noise_correlation_s);
  trust_.configure(parameters.measurement_bias, parameters.correction_limit, parameters.correction);
}

void StiffnessController::reset(double stretch_angle_deg) {
  const double start = std::isfinite(stretch_angle_deg) ? stretch_angle_deg : parameters_.travel_minimum_deg;
  still_s_ = 0.0;
  reference_deg_ = std::clamp(start, law_.minimumAngle_deg(), law_.maximumAngle_deg());
  pid_.reset();
  thesis_pid_.reset();
  lag_.reset(math::log(law_.stiffness_N_per_mm(reference_deg_).value));
  scale_.reset();
  trust_.reset();
  place_log_ = 0.0;
  clamped_ = place_known_ = rest_known_ = was_enabled_ = was_observable_ = started_ = false;
}

ControlOutput StiffnessController::step(const ControlInput& input) {
  const double dt_s = started_ ? std::clamp(toSeconds(input.now - last_), 0.0, kLongestStep_s) : 0.0;
  started_ = true;
  last_ = input.now;

  const bool angle_known = input.measured_angle_known && std::isfinite(input.measured_angle_deg);
  if (input.enabled && !was_enabled_) {
    if (angle_known) {
      reference_deg_ = std::clamp(input.measured_angle_deg, law_.minimumAngle_deg(), law_.maximumAngle_deg());
    }
    rest_known_ = false;
  }
  was_enabled_ = input.enabled;

  const double angle_deg = angle_known ? input.measured_angle_deg : reference_deg_;
  const double present_log = math::log(law_.stiffness_N_per_mm(angle_deg).value);
  if (input.observable && !was_observable_) {
    lag_.reset(present_log);  // the estimate starts anew with each touch: it has seen no other stretch
    scale_.beginTouch();
  }
  was_observable_ = input.observable;
  followPlace(input, dt_s);
  const double seen_log = lag_.step(present_log, dt_s);
  if (isMeasured(input)) {
    scale_.step(math::log(input.measured_N_per_mm) - place_log_ - seen_log,
                input.measured_sigma_N_per_mm / input.measured_N_per_mm, present_log, dt_s);
  }
  const bool was_contradicted = trust_.contradicted();
  trust_.step(scale_.significantLogScale(), dt_s);

  ControlOutput output;
  output.holding = !input.enabled || !isTarget(input.target_N_per_mm);
  if (!output.holding && dt_s > 0) {
    if (parameters_.mode == ControlMode::thesis) {
      reference_deg_ = desiredThesis(input);
    } else {
      const double reach_deg = parameters_.rate_limit_deg_per_s * dt_s;
      still_s_ = std::abs(angle_deg - reference_deg_) > kTravelling_deg ? 0.0 : std::min(still_s_ + dt_s, kArriving_s);
      const double desired_deg = desiredDefault(input, present_log, dt_s);
      reference_deg_ = std::clamp(desired_deg, reference_deg_ - reach_deg, reference_deg_ + reach_deg);
    }
    reference_deg_ = std::clamp(reference_deg_, law_.minimumAngle_deg(), law_.maximumAngle_deg());
  }
  judgeReach(input.target_N_per_mm, output);
  output.stretch_angle_deg = reference_deg_;
  output.at_limit = reference_deg_ <= law_.minimumAngle_deg() + kAtLimit_deg ||
                    reference_deg_ >= law_.maximumAngle_deg() - kAtLimit_deg;
  output.correction = parameters_.mode == ControlMode::thesis ? thesis_pid_.output() : pid_.output();
  output.cloth_scale = math::exp(trust_.logScale());
  output.measured_scale = math::exp(scale_.significantLogScale());
  output.law_contradicted = parameters_.mode == ControlMode::normal && trust_.contradicted();
  output.contradiction_begins = output.law_contradicted && !was_contradicted;
  return output;
}

void StiffnessController::followPlace(const ControlInput& input, double dt_s) {
  if (!input.observable) place_known_ = false;
  if (!std::isfinite(input.place_factor) || input.place_factor <= 0) return;
  const double seen = math::log(input.place_factor);
  place_log_ = place_known_ ? place_log_ + (seen - place_log_) * dt_s / (kPlaceTime_s + dt_s) : seen;
  place_known_ = input.observable;
}

double StiffnessController::desiredDefault(const ControlInput& input, double present_log, double dt_s) {
  const double target_log = math::log(input.target_N_per_mm) - place_log_;
  pid_.setLimits({math::log(law_.minimumStiffness_N_per_mm()) - target_log,
                  math::log(law_.maximumStiffness_N_per_mm()) - target_log, 1e300});
  const double y = trust_.logScale() + present_log;
  const double error = beyond(target_log - y, parameters_.dead_band_N_per_mm / input.target_N_per_mm);
  const double correction = pid_.step(y + error, y, dt_s, still_s_ >= kArriving_s);
  return law_.angle_deg(math::exp(target_log + correction)).value;
}

double StiffnessController::desiredThesis(const ControlInput& input) {
  if (!rest_known_) {
    rest_known_ = true;
    rest_deg_ = law_.angle_deg(input.target_N_per_mm).value;
    thesis_pid_.reset();
    thesis_next_ = input.now;
    return rest_deg_;
  }
  const Duration period = fromSeconds(parameters_.thesis_period_ms / 1000);
  if (input.now < thesis_next_ && thesis_next_ - input.now <= period) return reference_deg_;
  thesis_next_ = input.now + period;
  const double error = input.target_N_per_mm - input.measured_N_per_mm;
  if (!isMeasured(input) || input.measured_N_per_mm <= kThesisLeastStiffness_N_per_mm ||
      std::abs(error) <= kThesisDeadBand_N_per_mm) {
    return reference_deg_;
  }
  return rest_deg_ + thesis_pid_.step(input.target_N_per_mm, input.measured_N_per_mm, toSeconds(period));
}

void StiffnessController::judgeReach(double target, ControlOutput& output) {
  if (!isTarget(target)) {
    clamped_ = false;
    output.reachable_target_N_per_mm = kNone;
    return;
  }
  const double scale = math::exp(trust_.logScale() + place_log_);
  const double least = scale * law_.minimumStiffness_N_per_mm(), most = scale * law_.maximumStiffness_N_per_mm();
  const double margin = clamped_ ? kClampHysteresis : 0.0;
  clamped_ = target < least * (1 + margin) || target > most * (1 - margin);
  output.target_clamped = clamped_;
  output.reachable_target_N_per_mm = std::clamp(target, least, most);
}

}  // namespace fyd::control
