// Converts the texture signal to motor duties so that the finger receives the wanted acceleration: an inverse of the
// plant (felt_plant.h) within the motors' limits.
//
//   signal ─▶ noise gate ─▶ gain of the surface ─▶ inverse cloth ─▶ inverse motor ─▶ + friction ─▶ limits ─▶ duties
//
// Inverse cloth: inverse_cloth.h. Inverse motor: u = 100·(τ·α + ω)/ω_free + K·θ for the wanted acceleration α, speed ω
// and angle θ of the roller; K·θ compensates the board's position loop. Called the linear part of the duty.
// Friction compensation: 95 % of the breakaway duty times a soft sign of the *wanted* speed ω, because friction opposes
// speed, not duty. It is faded out while the position loop alone turns the motor.
//
// Gain of the surface: a small geared motor at full duty accelerates the roller by only about 0.25 g, so each surface
// is scaled to the available range. The mean squares of signal and linear duty (at gain 1) are estimated over some
// seconds of touch. The gain sets the RMS of the linear duty to linearRms_percent(level), which grows by 9 dB over
// 40 dB of signal level: stronger surfaces give stronger vibration, faint ones stay perceptible. A stored level
// (surface_level_g) replaces the estimated one. Before anything is estimated the gain is kInitialGain, so that a first
// tap can be felt.
// A silent signal gives exactly 0.
//
// Pure and allocation-free. A signal that is not finite counts as 0.
#pragma once

#include <array>

#include "core/base/state.h"
#include "core/texture/felt/felt_settings.h"
#include "core/texture/felt/inverse_cloth.h"

namespace fyd::texture {

struct FeltDuty {
  std::array<double, kFeltMotors> percent{};
  double wanted_g = 0.0;  ///< acceleration wanted at the finger
  bool clipped = false;   ///< a duty exceeded its limit and was cut
};

class FeltMapping {
 public:
  FeltMapping(const FeltSettings& settings, double sample_rate_Hz);

  /// Keeps the estimated mean squares. A new inverse filter is faded in over 32 samples.
  void configure(const FeltSettings& settings);
  /// Present stretch of the rollers; NaN: unknown, counts as FeltPlant::stretch_deg.
  void setStretch(double stretch_deg) { stretch_deg_ = stretch_deg; }
  /// Back to the initial state: no signal, no estimates.
  void reset();

  /// One sample.
  /// @param position_share_percent duty of the board's position loop, signed; NaN: unknown, counts as 0
  [[nodiscard]] FeltDuty step(double signal_g, double position_share_percent);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(stretch_deg_, tuned_Hz_, inverse_, speed_deg_s_, angle_deg_, gate_mean_square_, gate_gain_, learned_,
            samples_, heat_percent2_);
  }

 private:
  /// Of a surface, while it is touched.
  struct MeanSquares {
    double signal = 0.0;  // g²
    double duty = 0.0;    // linear part at gain 1, %²
    double speed = 0.0;   // of the roller at gain 1, (°/s)²

    template <class Archive>
    void serialize(Archive& archive) {
      archive(signal, duty, speed);
    }
  };

  void tune();
  void updateGate(double signal_g);
  void learn(const MeanSquares& squares);
  [[nodiscard]] MeanSquares initialMeanSquares() const;
  /// Factor from the linear duty at gain 1 to the one to send, FeltSettings::gain included.
  [[nodiscard]] double gain() const;
  /// Lower bound of heat_percent2_.
  [[nodiscard]] double leastHeat_percent2() const;
  /// RMS of the whole duty to aim at: a margin below the limits of RMS and peak duty.
  [[nodiscard]] double rmsTarget_percent() const;
  /// Friction compensation of a motor at full speed sign, at most rmsTarget_percent().
  [[nodiscard]] double friction_percent(std::size_t motor) const;
  /// RMS of the linear part of the duty for a surface with this RMS signal.
  [[nodiscard]] double linearRms_percent(double level_g) const;

  FeltSettings settings_;
  double rate_Hz_;
  double stretch_deg_;
  double tuned_Hz_ = 0.0;
  InverseCloth inverse_;
  double speed_deg_s_ = 0.0;  // of the roller, wanted, at gain 1
  double angle_deg_ = 0.0;
  double gate_mean_square_ = 0.0;  // of the signal over kGateAveraging_s, g²
  double gate_gain_ = 0.0;         // 0 closed … 1 open
  MeanSquares learned_;
  double samples_ = 0.0;        // of touch in learned_, limited
  double heat_percent2_ = 0.0;  // mean square of the larger duty before the heat limit: measure of heating
};

}  // namespace fyd::texture
