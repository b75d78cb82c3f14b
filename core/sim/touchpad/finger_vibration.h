// Model of the path from a motor's duty to the finger's acceleration, which the texture's mapping must compensate. It
// shares no formula with core/texture.
//
//   motor    torque = strength·u/100 − ω/ω_free − tension, ω̇ = (ω_free/τ)·(torque − friction)
//   friction stuck up to the breakaway b; sliding b·(s + (1 − s)·exp(−(ω/ω_s)²)) (Stribeck). With pre-sliding the stuck
//            gear is a bristle that bends so far before it slides [Dahl 1968]
//   board    u = clamp(K·(reference − θ), ±100) + vibration, together within ±100
//   gear     has backlash; the cloth's tension holds the roller against one flank, under a slack cloth it stays
//   finger   ẍ = 2ζω₀(ẋ_roller − ẋ) + ω₀²(x_roller − x), on the mean of both rollers
//
// Twenty steps a millisecond. This models the motor as the finger feels it; SimulatedMotor models it as the encoders
// see it and is kept because older recordings were made with it. Pure and allocation-free; not thread-safe.
#pragma once

#include <array>

#include "core/control/motor_types.h"
#include "core/sim/finger_vibration_parameters.h"

namespace fyd::sim {

class FingerVibration {
 public:
  /// At which tension and resonance are given.
  static constexpr double kReferenceStretch_deg = 45.0;

  /// At rest at this stretch.
  explicit FingerVibration(const FingerVibrationParameters& parameters, double stretch_deg = kReferenceStretch_deg);

  /// One millisecond with this duty. @param force_N of the finger; 0: none, the cloth vibrates alone
  /// @return acceleration of the finger, mean over the millisecond, g
  double step(const std::array<double, control::kMotorCount>& duty_percent, double force_N = 1.0);

  /// The stretch that the board holds; it also sets the cloth's tension.
  void setStretch(double stretch_deg) { stretch_deg_ = stretch_deg; }

  [[nodiscard]] const std::array<double, control::kMotorCount>& motor_deg() const { return angle_deg_; }
  /// Duty of the board's position loop now.
  [[nodiscard]] const std::array<double, control::kMotorCount>& positionDuty_percent() const { return held_percent_; }
  /// Half the difference of both motors' angles, as the encoders would measure it.
  [[nodiscard]] double stretch_deg() const { return 0.5 * (angle_deg_[0] - angle_deg_[1]); }

 private:
  void turn(std::size_t motor, double duty_percent);
  void follow(std::size_t motor);
  [[nodiscard]] double tension(std::size_t motor) const;
  [[nodiscard]] double reference_deg(std::size_t motor) const;

  FingerVibrationParameters p_;
  double stretch_deg_;
  std::array<double, control::kMotorCount> rest_deg_{};  // what the position loop needs to hold the tension
  std::array<double, control::kMotorCount> angle_deg_{};
  std::array<double, control::kMotorCount> speed_deg_s_{};
  std::array<double, control::kMotorCount> bent_deg_{};
  std::array<double, control::kMotorCount> roller_deg_{};
  std::array<double, control::kMotorCount> held_percent_{};
  double cloth_mm_ = 0.0;  // mean of the rollers
  double finger_mm_ = 0.0;
  double finger_mm_s_ = 0.0;
};

}  // namespace fyd::sim
