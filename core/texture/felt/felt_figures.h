// Compares what arrived at the finger with what was wanted. Offline: allocates. Figures about accelerations, never
// about what a person feels.
#pragma once

#include <span>

namespace fyd::texture {

struct FeltFigures {
  double spectral_match = 0.0;         ///< as in spectral_match.h, both spectra scaled to the same sum; 1 is equal
  double third_octave_error_dB = 0.0;  ///< mean distance in third octaves 20…400 Hz, weighted by the wanted amplitude
  double envelope = 0.0;               ///< correlation of the RMS in windows of 50 ms
  double level_g = 0.0;                ///< RMS at the finger
  double level_dB = 0.0;               ///< that over kFeltThreshold_g
  double lag_ms = 0.0;                 ///< where the cross-correlation is largest, within 0…50 ms
};

/// NaN where nothing was wanted; spectral match 0 where nothing arrived.
/// @param wanted texture signal, 1 kHz; @param finger acceleration, as long
[[nodiscard]] FeltFigures compareFelt(std::span<const double> wanted, std::span<const double> finger);

}  // namespace fyd::texture
