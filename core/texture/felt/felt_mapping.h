// From the texture signal to duties that the finger feels: inverts the plant (felt_plant.h) as far as the motors allow.
//
//   signal ─▶ noise gate ─▶ gain of the surface ─▶ inverse cloth ─▶ inverse motor ─▶ + friction ─▶ limits ─▶ duties
//
// Inverse cloth: inverse_cloth.h. Inverse motor: u = 100·(τ·α + ω)/ω_free + K·θ for the wanted acceleration α, speed ω
// and angle θ of the roller; K·θ is what the board's position loop subtracts.
// Friction: 95 % of the breakaway times a soft sign of the *wanted* speed ω, because friction opposes speed, not duty.
// None while the position loop turns the motor by itself.
//
// Gain: the motors' authority is small (full duty of a small geared motor is a quarter of a g at the roller), so a
// surface is scaled to what they can do. Its level and its cost (RMS of signal and of duty, gain 1) are learned while
// it is touched, over some seconds; the linear part of the duty is then target(level) %, which grows by 9 dB over 40 dB
// of level: stronger surfaces feel stronger, faint ones are still felt. A stored level is not changed by learning. Out
// of silence the gain is kUsualGain, so that a first tap is felt.
// Silence gives exactly 0.
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
  bool clipped = false;   ///< a limit cut it
};

class FeltMapping {
 public:
  FeltMapping(const FeltSettings& settings, double sample_rate_Hz);

  /// Keeps what it has learned; the resonance glides.
  void configure(const FeltSettings& settings);
  /// Present stretch of the rollers; NaN: unknown, counts as the stretch of the identification.
  void setStretch(double stretch_deg) { stretch_deg_ = stretch_deg; }
  /// Silence, nothing learned.
  void reset();

  /// @param position_share_percent of the board's position loop, signed; NaN: unknown, counts as none
  [[nodiscard]] FeltDuty step(double signal_g, double position_share_percent);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(stretch_deg_, tuned_Hz_, inverse_, speed_deg_s_, angle_deg_, gate_level_, gate_, learned_, samples_, heat_);
  }

 private:
  /// Mean squares of a surface.
  struct Surface {
    double level = 0.0;  // of the signal, g²
    double cost = 0.0;   // of the duty that it costs with gain 1, %²
    double speed = 0.0;  // of the roller's speed with gain 1, (°/s)²

    template <class Archive>
    void serialize(Archive& archive) {
      archive(level, cost, speed);
    }
  };

  void tune();
  void openGate(double signal_g);
  void learn(const Surface& squares);
  [[nodiscard]] Surface usual() const;
  [[nodiscard]] double gain() const;
  [[nodiscard]] double warm() const;
  /// RMS of the duty to aim at, within the motors' heat limit.
  [[nodiscard]] double limit_percent() const;
  /// Feed-forward of a motor's friction, at most what the heat limit allows.
  [[nodiscard]] double friction_percent(std::size_t motor) const;
  /// RMS of the duty's linear part, for a surface of this level.
  [[nodiscard]] double target_percent(double level_g) const;

  FeltSettings settings_;
  double rate_Hz_;
  double stretch_deg_;
  double tuned_Hz_ = 0.0;
  InverseCloth inverse_;
  double speed_deg_s_ = 0.0;  // wanted, with gain 1
  double angle_deg_ = 0.0;
  double gate_level_ = 0.0;  // mean square of the signal, short
  double gate_ = 0.0;        // 0 closed … 1 open
  Surface learned_;
  double samples_ = 0.0;  // that learned_ rests on
  double heat_ = 0.0;     // mean square of the duty before the heat limit
};

}  // namespace fyd::texture
