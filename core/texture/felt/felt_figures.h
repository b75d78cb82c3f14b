// Compares the acceleration at the finger with the wanted texture signal. Offline: allocates. The figures describe
// accelerations, not perception.
#pragma once

#include <span>

namespace fyd::texture {

struct FeltFigures {
  double spectral_match = 0.0;         ///< as in spectral_match.h, both spectra scaled to the same sum; 1: equal
  double third_octave_error_dB = 0.0;  ///< mean |difference| of levels in the 12 third octaves with centres from 25 to
                                       ///< 317 Hz (22 to 356 Hz) without their mean, weighted by the wanted amplitude
  double envelope = 0.0;               ///< correlation of the envelopes: RMS in windows of 50 ms
  double level_g = 0.0;                ///< RMS at the finger
  double level_dB = 0.0;               ///< level_g relative to kFeltThreshold_g
  double lag_ms = 0.0;                 ///< of the largest |cross-correlation|, within 0…50 ms
};

/// The longer input is cut to the shorter. Spectral figures are NaN for a wanted signal of zeros, and all are NaN for
/// less than 64 samples; spectral_match is 0 for a finger signal of zeros.
/// @param wanted texture signal, g, 1 kHz; @param finger acceleration, g, 1 kHz
[[nodiscard]] FeltFigures compareFelt(std::span<const double> wanted, std::span<const double> finger);

}  // namespace fyd::texture
