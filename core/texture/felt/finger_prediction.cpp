#include "core/texture/felt/finger_prediction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/texture/felt/felt_level.h"

namespace fyd::texture {
namespace {

constexpr double kAveraging_s = 1.0;

signal::BiquadCoefficients clothFilter(double resonance_Hz, double damping, double gain, double rate_Hz) {
  const double w = 2.0 * std::numbers::pi * resonance_Hz;
  const double c = 2.0 * rate_Hz;  // bilinear transform
  const double damping_term = 2.0 * damping * w * c;
  const double a0 = c * c + damping_term + w * w;
  return {.b0 = gain * (damping_term + w * w) / a0,
          .b1 = gain * 2.0 * w * w / a0,
          .b2 = gain * (w * w - damping_term) / a0,
          .a1 = 2.0 * (w * w - c * c) / a0,
          .a2 = (c * c - damping_term + w * w) / a0};
}

}  // namespace

bool inDeadZone(const std::array<double, kFeltMotors>& duty_percent, const FeltPlant& plant) {
  bool any = false;
  for (std::size_t i = 0; i < kFeltMotors; ++i) {
    if (std::abs(duty_percent[i]) >= plant.breakaway_percent[i]) return false;
    any = any || duty_percent[i] != 0.0;
  }
  return any;
}

FingerPrediction::FingerPrediction(const FeltPlant& plant, double sample_rate_Hz) : rate_Hz_(sample_rate_Hz) {
  configure(plant, plant.stretch_deg);
}

void FingerPrediction::configure(const FeltPlant& plant, double stretch_deg) {
  const double resonance_Hz = plant.resonanceAt_Hz(stretch_deg);
  if (resonance_Hz == resonance_Hz_ && plant == plant_) return;
  plant_ = plant;
  resonance_Hz_ = resonance_Hz;
  cloth_.setCoefficients(clothFilter(resonance_Hz, plant.damping, plant.cloth_gain, rate_Hz_));
}

void FingerPrediction::reset() {
  cloth_.reset();
  speed_deg_s_ = angle_deg_ = duty_mean_square_ = {};
  acceleration_g_ = finger_mean_square_ = wanted_mean_square_ = dead_share_ = clipped_share_ = 0.0;
}

void FingerPrediction::step(const std::array<double, kFeltMotors>& duty_percent, double wanted_g, bool clipped) {
  const double T = 1.0 / rate_Hz_;
  const double weight = std::min(1.0, T / kAveraging_s);
  const double tau = plant_.time_constant_ms * 1e-3;
  const double dt_per_tau = T / tau;
  double acceleration = 0.0;
  for (std::size_t i = 0; i < kFeltMotors; ++i) {
    const double friction = plant_.breakaway_percent[i];
    // Within the board's range: a stiff position loop at one integration step per sample would diverge.
    const double drive =
        std::clamp(duty_percent[i] - plant_.position_gain_percent_per_deg * angle_deg_[i], -100.0, 100.0);
    const double before = speed_deg_s_[i];
    // Implicit Euler for the speed-dependent term: stable for any time constant.
    const double driven = (before + dt_per_tau * plant_.free_speed_deg_s * drive / 100.0) / (1.0 + dt_per_tau);
    const double friction_step = dt_per_tau * plant_.free_speed_deg_s * friction / 100.0 / (1.0 + dt_per_tau);
    speed_deg_s_[i] = std::copysign(std::max(std::abs(driven) - friction_step, 0.0), driven);
    angle_deg_[i] += T * speed_deg_s_[i];
    acceleration += (speed_deg_s_[i] - before) / T;
    duty_mean_square_[i] += weight * (duty_percent[i] * duty_percent[i] - duty_mean_square_[i]);
  }
  acceleration_g_ = cloth_.step(acceleration / kFeltMotors / plant_.rollerAccelerationPerG_deg_s2());
  finger_mean_square_ += weight * (acceleration_g_ * acceleration_g_ - finger_mean_square_);
  wanted_mean_square_ += weight * (wanted_g * wanted_g - wanted_mean_square_);
  dead_share_ += weight * ((inDeadZone(duty_percent, plant_) ? 1.0 : 0.0) - dead_share_);
  clipped_share_ += weight * ((clipped ? 1.0 : 0.0) - clipped_share_);
}

FingerFigures FingerPrediction::figures() const {
  const double felt_g = std::sqrt(finger_mean_square_);
  return {.acceleration_g = acceleration_g_,
          .level_dB = feltLevel_dB(felt_g),
          .dead_share = dead_share_,
          .clipped_share = clipped_share_,
          .duty_rms_percent = std::sqrt(std::max(duty_mean_square_[0], duty_mean_square_[1])),
          .out_of_reach = wanted_mean_square_ > kWantedThreshold_g * kWantedThreshold_g && felt_g < kFeltThreshold_g};
}

}  // namespace fyd::texture
