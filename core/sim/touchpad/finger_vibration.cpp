#include "core/sim/touchpad/finger_vibration.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/units.h"

namespace fyd::sim {
namespace {

constexpr int kVibrationParts = 20;  // of a millisecond
constexpr double kPart_s = 1e-3 / kVibrationParts;
// With a damping ratio of 2 the integration diverges from 1.5 kHz on.
constexpr double kLowestResonance_Hz = 5.0, kHighestResonance_Hz = 1000.0;
constexpr double kSlack = 1e-3;  // of the stall torque: a lower tension does not close the backlash
constexpr double kRadians = std::numbers::pi / 180.0;

double side(std::size_t motor) { return motor == 0 ? 1.0 : -1.0; }

}  // namespace

FingerVibration::FingerVibration(const FingerVibrationParameters& parameters, double stretch_deg)
    : p_(parameters), stretch_deg_(stretch_deg) {
  for (std::size_t i = 0; i < angle_deg_.size(); ++i) angle_deg_[i] = side(i) * stretch_deg;
  for (std::size_t i = 0; i < angle_deg_.size(); ++i) {
    const double strength = i == 0 ? 1.0 : p_.second_strength;
    if (p_.position_gain > 0.0 && strength > 0.0) rest_deg_[i] = 100.0 * tension(i) / strength / p_.position_gain;
    roller_deg_[i] = angle_deg_[i];
    follow(i);
  }
  cloth_mm_ = 0.5 * (roller_deg_[0] + roller_deg_[1]) * kRadians * p_.roller_radius_mm;
  finger_mm_ = cloth_mm_;
}

double FingerVibration::tension(std::size_t motor) const {
  return side(motor) * p_.tension_percent / 100.0 * std::max(stretch_deg(), 0.0) / kReferenceStretch_deg;
}

double FingerVibration::reference_deg(std::size_t motor) const { return side(motor) * stretch_deg_ + rest_deg_[motor]; }

void FingerVibration::turn(std::size_t i, double duty_percent) {
  const double strength = i == 0 ? 1.0 : p_.second_strength;
  const double breakaway = p_.breakaway_percent / 100.0 * (i == 0 ? 1.0 : p_.second_friction);
  held_percent_[i] = std::clamp(p_.position_gain * (reference_deg(i) - angle_deg_[i]), -100.0, 100.0);
  const double duty = std::clamp(held_percent_[i] + duty_percent, -100.0, 100.0);
  double& speed = speed_deg_s_[i];
  const double torque = strength * duty / 100.0 - speed / p_.free_speed_deg_s - tension(i);
  const double gain = p_.free_speed_deg_s / (p_.time_constant_ms * 1e-3) * kPart_s;
  const double slip = speed / p_.stribeck_deg_s;
  const double sliding = breakaway * (p_.sliding_share + (1.0 - p_.sliding_share) * std::exp(-slip * slip));
  if (p_.presliding_deg > 0.0 && breakaway > 0.0) {
    const double furthest = p_.presliding_deg * sliding / breakaway;
    bent_deg_[i] = std::clamp(bent_deg_[i] + speed * kPart_s, -furthest, furthest);
    speed += gain * (torque - breakaway * bent_deg_[i] / p_.presliding_deg);
  } else if (speed == 0.0) {
    if (std::abs(torque) > breakaway) speed = gain * (torque - std::copysign(breakaway, torque));
  } else {
    const double next = speed + gain * (torque - std::copysign(sliding, speed));
    speed = next * speed < 0.0 ? 0.0 : next;
  }
  angle_deg_[i] += speed * kPart_s;
}

void FingerVibration::follow(std::size_t i) {
  const double half_deg = 0.5 * p_.backlash_deg;
  const double pull = tension(i);
  if (std::abs(pull) > kSlack) {  // the cloth pulls the roller back against one flank
    roller_deg_[i] = angle_deg_[i] - std::copysign(half_deg, pull);
  } else {
    roller_deg_[i] = std::clamp(roller_deg_[i], angle_deg_[i] - half_deg, angle_deg_[i] + half_deg);
  }
}

double FingerVibration::step(const std::array<double, control::kMotorCount>& duty_percent, double force_N) {
  const double loaded = force_N > 0.0 ? std::pow(force_N, -p_.finger_loading) : 1.0;
  const double resonance_Hz =
      std::clamp((p_.resonance_Hz + p_.resonance_Hz_per_deg * (stretch_deg() - kReferenceStretch_deg)) * loaded,
                 kLowestResonance_Hz, kHighestResonance_Hz);
  const double w = 2.0 * std::numbers::pi * resonance_Hz;
  double sum_mm_s2 = 0.0;
  for (int part = 0; part < kVibrationParts; ++part) {
    for (std::size_t i = 0; i < angle_deg_.size(); ++i) {
      turn(i, std::isfinite(duty_percent[i]) ? duty_percent[i] : 0.0);
      follow(i);
    }
    const double cloth_mm = 0.5 * (roller_deg_[0] + roller_deg_[1]) * kRadians * p_.roller_radius_mm;
    const double cloth_mm_s = (cloth_mm - cloth_mm_) / kPart_s;
    cloth_mm_ = cloth_mm;
    const double acceleration = 2.0 * p_.damping * w * (cloth_mm_s - finger_mm_s_) + w * w * (cloth_mm - finger_mm_);
    finger_mm_s_ += acceleration * kPart_s;
    finger_mm_ += finger_mm_s_ * kPart_s;
    sum_mm_s2 += acceleration;
  }
  return sum_mm_s2 / kVibrationParts * 1e-3 / kStandardGravity;
}

}  // namespace fyd::sim
