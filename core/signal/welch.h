// Power spectral density by Welch's method [Welch 1967]. Offline: allocates.
// Stability: may change
#pragma once

#include <span>
#include <vector>

#include "core/base/api.h"

namespace fyd::signal {

struct Spectrum {
  double resolution_Hz = 0.0;
  std::vector<double> density;  ///< one-sided, unit²/Hz, bin k at k·resolution_Hz, DC to Nyquist

  [[nodiscard]] double frequency_Hz(std::size_t bin) const { return static_cast<double>(bin) * resolution_Hz; }
};

/// Hann segments, half overlapped, no detrending; ∫ density df is the mean square of a stationary signal.
/// @param segment samples; shortened to the signal's length when that is shorter. Fewer than 2 samples give no bins.
[[nodiscard]] FYD_API Spectrum welch(std::span<const double> signal, double sample_rate_Hz, int segment);

/// a += b, bin by bin; both of the same shape.
FYD_API void add(Spectrum& a, const Spectrum& b);

}  // namespace fyd::signal
