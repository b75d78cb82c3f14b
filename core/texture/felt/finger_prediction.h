// Predicts the acceleration at the finger from the duties sent, by the plant model (felt_plant.h), for display.
//
//   motor   ω̇ = (ω_free/τ)·((u − K·θ)/100 − ω/ω_free), less the friction (breakaway); mean of both motors
//   finger  H(s) = gain·(2ζω₀s + ω₀²)/(s² + 2ζω₀s + ω₀²) of the rollers' acceleration
//
// A coarse model with one integration step per sample. It is an estimate, not a measurement: encoders, load cell and
// motor current do not sense this vibration. The figures are running means over 1 s. Allocation-free.
// Stability: may change
#pragma once

#include <array>

#include "core/base/api.h"
#include "core/base/state.h"
#include "core/signal/biquad.h"
#include "core/texture/felt/felt_plant.h"

namespace fyd::texture {

struct FingerFigures {
  double acceleration_g = 0.0;    ///< of the finger, newest sample
  double level_dB = 0.0;          ///< RMS at the finger relative to kFeltThreshold_g; −120 at least
  double dead_share = 0.0;        ///< share of the samples with inDeadZone
  double clipped_share = 0.0;     ///< share of the samples in which a limit cut a duty
  double duty_rms_percent = 0.0;  ///< of the motor with the larger one
  bool out_of_reach = false;      ///< a signal is wanted, but the finger gets less than the threshold
};

inline constexpr double kWantedThreshold_g = 0.01;  ///< a texture signal of more RMS is wanted
/// At least one duty is not 0, and every duty is below its motor's breakaway: no motor turns.
[[nodiscard]] FYD_API bool inDeadZone(const std::array<double, kFeltMotors>& duty_percent, const FeltPlant& plant);

class FYD_API FingerPrediction {
 public:
  FingerPrediction(const FeltPlant& plant, double sample_rate_Hz);

  /// Keeps its state.
  void configure(const FeltPlant& plant, double stretch_deg);
  void reset();

  /// @param wanted_g the texture signal; @param clipped whether a limit cut a duty
  void step(const std::array<double, kFeltMotors>& duty_percent, double wanted_g, bool clipped);

  [[nodiscard]] FingerFigures figures() const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(cloth_, acceleration_g_, speed_deg_s_, angle_deg_, finger_mean_square_, wanted_mean_square_, dead_share_,
            clipped_share_, duty_mean_square_);
  }

 private:
  FeltPlant plant_;
  double rate_Hz_;
  double resonance_Hz_ = 0.0;
  signal::Biquad<double> cloth_;
  double acceleration_g_ = 0.0;
  std::array<double, kFeltMotors> speed_deg_s_{};
  std::array<double, kFeltMotors> angle_deg_{};
  double finger_mean_square_ = 0.0;  // g²; this and the following: running means
  double wanted_mean_square_ = 0.0;
  double dead_share_ = 0.0;
  double clipped_share_ = 0.0;
  std::array<double, kFeltMotors> duty_mean_square_{};
};

}  // namespace fyd::texture
