#include "core/sim/touchpad/simulated_motor.h"

#include <algorithm>
#include <cmath>

namespace fyd::sim {
namespace {

constexpr double kTimeConstant_s = 0.015;
constexpr double kStallCurrent_mA = 1500.0;
constexpr double kProportional = 25.0;    // % per °
constexpr double kDerivative = 0.3;       // % per °/s
constexpr double kFreeSpeedShare = 1.15;  // of the speed limit
constexpr double kGearBrake = 0.2;        // share of the stall torque, without current
constexpr double kEndStop_deg = 120.0;

double finiteOrZero(double value) { return std::isfinite(value) ? value : 0.0; }

}  // namespace

void SimulatedMotor::step(double reference_deg, double vibration_percent, bool active, const MotorLimits& limits,
                          double dt_s) {
  const double free_speed = kFreeSpeedShare * limits.speed_deg_s;
  double friction = limits.friction_percent / 100.0;
  double drive = 0.0;  // torque as a share of the stall torque
  position_duty_percent_ = 0.0;
  if (active) {
    const double reference = std::clamp(finiteOrZero(reference_deg), -kEndStop_deg, kEndStop_deg);
    position_duty_percent_ =
        std::clamp(kProportional * (reference - angle_deg_) - kDerivative * speed_deg_s_, -100.0, 100.0);
    const double vibration = std::clamp(finiteOrZero(vibration_percent), -100.0, 100.0);
    const double duty = std::clamp(position_duty_percent_ + vibration, -100.0, 100.0);
    const double limit = std::min(1.0, limits.current_mA / kStallCurrent_mA);
    drive = std::clamp(duty / 100.0 - speed_deg_s_ / free_speed, -limit, limit);
  } else {
    friction = std::max(friction, kGearBrake);
  }
  current_mA_ = drive * kStallCurrent_mA;

  const double gain = free_speed / kTimeConstant_s * dt_s;
  if (speed_deg_s_ == 0.0) {
    if (std::abs(drive) > friction) speed_deg_s_ = gain * (drive - std::copysign(friction, drive));
  } else {
    const double next = speed_deg_s_ + gain * (drive - std::copysign(friction, speed_deg_s_));
    const bool reversed = next * speed_deg_s_ < 0.0;
    speed_deg_s_ = reversed && std::abs(drive) <= friction ? 0.0 : next;  // friction stops, it does not drive back
  }
  speed_deg_s_ = std::clamp(speed_deg_s_, -limits.speed_deg_s, limits.speed_deg_s);
  angle_deg_ += speed_deg_s_ * dt_s;
  if (std::abs(angle_deg_) >= kEndStop_deg) {
    angle_deg_ = std::copysign(kEndStop_deg, angle_deg_);
    speed_deg_s_ = 0.0;
  }
}

}  // namespace fyd::sim
