// Fits resonance, damping and gain of the cloth under a finger to the accelerations measured during chirps.
//
// The rollers' acceleration x is simulated from the duty by the motor model of FeltPlant: free speed, time constant,
// position gain, radius and breakaway as given; sliding friction is the share of the breakaway that fits best. With
// the measured acceleration y,
//   Σ |Y(f) − g·e^(−2πi·f·d)·H(f; f₀, ζ)·X(f)|² over 10…400 Hz
// is minimised over resonance f₀, damping ζ, gain g and delay d of the accelerometer. Every other band of 5 Hz is held
// out of the fit and gives its error. Offline: allocates.
#pragma once

#include <vector>

#include "core/texture/felt/plant_sweep.h"

namespace fyd::texture {

struct FoundCloth {
  int part = 0;
  double stretch_deg = 0.0;
  double resonance_Hz = 0.0;
  double sigma_Hz = 0.0;
  double damping = 0.0;
  double sigma_damping = 0.0;
  double gain = 0.0;  ///< below 0 where the accelerometer's axis points against the cloth's motion
  double delay_ms = 0.0;
  double held_out_error = 0.0;  ///< in the held-out bands: RMS error over RMS acceleration
};

struct ChirpFit {
  double sliding_share = 1.0;  ///< sliding friction over breakaway
  std::vector<FoundCloth> cloths;
};

/// Whether both motors had the same duty, which changed its sign more than a hundred times.
[[nodiscard]] bool isChirp(const SweepPart& part);

/// @param chirps one or more
/// @return an error that names a chirp that is too short or has no acceleration
[[nodiscard]] Result<ChirpFit> fitChirps(const std::vector<const SweepPart*>& chirps, const FeltPlant& plant);

}  // namespace fyd::texture
