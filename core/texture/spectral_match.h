// How well one signal stands for three axes. Figures about spectra and energy, never about what a person feels.
// Stability: may change
#pragma once

#include <span>

#include "core/base/api.h"

namespace fyd::texture {

/// Both NaN when fewer than 8 samples are left after the delay.
struct MatchFigures {
  /// 1 − Σ|√P − √Pref| / Σ√Pref over 20 Hz…Nyquist; 1 is equal, 0 or less is useless; NaN when the axes are silent there
  double spectral_match = 0.0;
  double energy_ratio = 0.0;  ///< signal's energy over the three axes' energies together; NaN when those are silent
};

/// P: Welch spectrum (Hann, 512 samples or the largest power of two that fits four times, half overlapped) of `signal`;
/// Pref: sum of the three axes' Welch spectra. The signal's first `delay_samples` are its method's delay:
/// the axes are compared with the signal that delay later.
[[nodiscard]] FYD_API MatchFigures compareSpectra(std::span<const double> x, std::span<const double> y,
                                                  std::span<const double> z, std::span<const double> signal,
                                                  int delay_samples, double sample_rate_Hz);

/// Mean |s(n) − s(n−1)| where n is a multiple of `period` (plus any one offset), over the mean elsewhere: 1 means that
/// the frame's edges do not show. NaN when there are no edges (period < 2) or no signal. The offset is the one of
/// `delay_samples`: frames start at sample 0 of the input.
[[nodiscard]] FYD_API double edgeJumpRatio(std::span<const double> signal, int period, int delay_samples);

}  // namespace fyd::texture
