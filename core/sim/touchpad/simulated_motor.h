// One geared motor with its board's position loop, as the touchpad has two.
//
//   duty = clamp(P·(reference − angle) − D·ω, ±100 %) + vibration, together within ±100 %   [thesis §4.1.4]
//   i    = stall·(duty/100 − ω/ω_free), within the current limit           ω_free = 1.15 · speed limit
//   ω̇    = (ω_free/τ)·(i/stall − friction·sgn ω), at rest 0 until i overcomes the friction; |ω| ≤ speed limit
//
// τ = 15 ms, stall 1500 mA, P = 25 %/°, D = 0.3 %·s/°. The angle has end stops at ±120°. The cloth's load is neglected
// because of the 256:1 gear.
#pragma once

namespace fyd::sim {

struct MotorLimits {
  double speed_deg_s = 180.0;
  double current_mA = 1200.0;
  double friction_percent = 3.0;
};

class SimulatedMotor {
 public:
  explicit SimulatedMotor(double angle_deg) : angle_deg_(angle_deg) {}

  /// One step of `dt_s`. @param active false: no current, the gear brakes
  void step(double reference_deg, double vibration_percent, bool active, const MotorLimits& limits, double dt_s);

  [[nodiscard]] double angle_deg() const { return angle_deg_; }
  [[nodiscard]] double speed_deg_s() const { return speed_deg_s_; }
  [[nodiscard]] double current_mA() const { return current_mA_; }
  [[nodiscard]] double positionDuty_percent() const { return position_duty_percent_; }

 private:
  double angle_deg_;
  double speed_deg_s_ = 0.0;
  double current_mA_ = 0.0;
  double position_duty_percent_ = 0.0;
};

}  // namespace fyd::sim
