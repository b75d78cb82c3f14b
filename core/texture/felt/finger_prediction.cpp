#include "core/texture/felt/finger_prediction.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"

namespace fyd::texture {
namespace {

constexpr double kMean_s = 1.0;
constexpr double kFaintest = 1e-6;  // of the threshold: −120 dB

signal::BiquadCoefficients clothFilter(double resonance_Hz, double damping, double gain, double rate_Hz) {
  const double w = 2.0 * std::numbers::pi * resonance_Hz;
  const double c = 2.0 * rate_Hz;  // bilinear
  const double across = 2.0 * damping * w * c;
  const double a0 = c * c + across + w * w;
  return {.b0 = gain * (across + w * w) / a0,
          .b1 = gain * 2.0 * w * w / a0,
          .b2 = gain * (w * w - across) / a0,
          .a1 = 2.0 * (w * w - c * c) / a0,
          .a2 = (c * c - across + w * w) / a0};
}

}  // namespace

bool isDead(const std::array<double, kFeltMotors>& duty_percent, const FeltPlant& plant) {
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
  if (resonance_Hz == tuned_Hz_ && plant == plant_) return;
  plant_ = plant;
  tuned_Hz_ = resonance_Hz;
  cloth_.setCoefficients(clothFilter(resonance_Hz, plant.damping, plant.cloth_gain, rate_Hz_));
}

void FingerPrediction::reset() {
  cloth_.reset();
  speed_deg_s_ = angle_deg_ = heat_ = {};
  newest_g_ = felt_ = wanted_ = dead_ = clipped_ = 0.0;
}

void FingerPrediction::step(const std::array<double, kFeltMotors>& duty_percent, double wanted_g, bool clipped) {
  const double T = 1.0 / rate_Hz_;
  const double share = std::min(1.0, T / kMean_s);
  const double tau = plant_.time_constant_ms * 1e-3;
  const double slows = T / tau;
  double acceleration = 0.0;
  for (std::size_t i = 0; i < kFeltMotors; ++i) {
    const double friction = plant_.breakaway_percent[i];
    const double drive = duty_percent[i] - plant_.position_gain_percent_per_deg * angle_deg_[i];
    const double before = speed_deg_s_[i];
    // Implicit in the speed's own drag, so that no time constant makes it unstable.
    const double pushed = (before + slows * plant_.free_speed_deg_s * drive / 100.0) / (1.0 + slows);
    const double stops = slows * plant_.free_speed_deg_s * friction / 100.0 / (1.0 + slows);
    speed_deg_s_[i] = std::copysign(std::max(std::abs(pushed) - stops, 0.0), pushed);
    angle_deg_[i] += T * speed_deg_s_[i];
    acceleration += (speed_deg_s_[i] - before) / T;
    heat_[i] += share * (duty_percent[i] * duty_percent[i] - heat_[i]);
  }
  newest_g_ = cloth_.step(acceleration / kFeltMotors / plant_.degreesPerG());
  felt_ += share * (newest_g_ * newest_g_ - felt_);
  wanted_ += share * (wanted_g * wanted_g - wanted_);
  dead_ += share * ((isDead(duty_percent, plant_) ? 1.0 : 0.0) - dead_);
  clipped_ += share * ((clipped ? 1.0 : 0.0) - clipped_);
}

FingerFigures FingerPrediction::figures() const {
  const double relative = std::sqrt(felt_) / kFeltThreshold_g;
  return {.acceleration_g = newest_g_,
          .level_dB = 20.0 / std::numbers::ln10 * math::log(std::max(relative, kFaintest)),
          .dead_share = dead_,
          .clipped_share = clipped_,
          .duty_rms_percent = std::sqrt(std::max(heat_[0], heat_[1])),
          .out_of_reach = wanted_ > kWanting_g * kWanting_g && relative < 1.0};
}

}  // namespace fyd::texture
