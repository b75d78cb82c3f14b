// Predicts what arrives at the finger from the duties sent, by the plant model (felt_plant.h); shown to the operator.
//
//   motor   ω̇ = (ω_free/τ)·(u/100 − ω/ω_free − K·θ), less the friction (breakaway); mean of both motors
//   finger  H(s) = gain·(2ζω₀s + ω₀²)/(s² + 2ζω₀s + ω₀²) of the rollers' acceleration
//
// Rough on purpose, one step a sample; an estimate, never a measurement: encoders, load cell and current see none of
// it. Figures are running means over 1 s. Allocation-free.
#pragma once

#include <array>

#include "core/base/state.h"
#include "core/signal/biquad.h"
#include "core/texture/felt/felt_plant.h"

namespace fyd::texture {

struct FingerFigures {
  double acceleration_g = 0.0;    ///< newest, of the finger
  double level_dB = 0.0;          ///< RMS at the finger over kFeltThreshold_g; −120 at least
  double dead_share = 0.0;        ///< of the samples (isDead)
  double clipped_share = 0.0;     ///< of the samples: cut by a limit
  double duty_rms_percent = 0.0;  ///< of the motor with more
  bool out_of_reach = false;      ///< something is wanted, and less than the threshold arrives
};

inline constexpr double kWanting_g = 0.01;  ///< RMS of the texture signal from which something is wanted
/// There is a duty, but each motor's is below its breakaway.
[[nodiscard]] bool isDead(const std::array<double, kFeltMotors>& duty_percent, const FeltPlant& plant);

class FingerPrediction {
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
    archive(cloth_, newest_g_, speed_deg_s_, angle_deg_, felt_, wanted_, dead_, clipped_, heat_);
  }

 private:
  FeltPlant plant_;
  double rate_Hz_;
  double tuned_Hz_ = 0.0;
  signal::Biquad<double> cloth_;
  double newest_g_ = 0.0;
  std::array<double, kFeltMotors> speed_deg_s_{};
  std::array<double, kFeltMotors> angle_deg_{};
  double felt_ = 0.0;  // mean squares and shares
  double wanted_ = 0.0;
  double dead_ = 0.0;
  double clipped_ = 0.0;
  std::array<double, kFeltMotors> heat_{};
};

}  // namespace fyd::texture
