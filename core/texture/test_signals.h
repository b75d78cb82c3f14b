// Analytic and synthetic three-axis vibration with known spectra: no freely licensed three-axis texture recording
// at 1 kHz was found, so measurements and tests use these. Deterministic from a seed. Offline: allocates.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/api.h"

namespace fyd::texture {

struct ThreeAxes {
  std::vector<double> x;
  std::vector<double> y;
  std::vector<double> z;
};

/// One path from the source to one axis.
struct Path {
  double delay_samples = 0.0;  ///< may be fractional
  double gain = 1.0;
};

/// Gaussian noise of unit RMS between two frequencies, edges falling over 10 % of the band; periodic in `samples`.
[[nodiscard]] FYD_API std::vector<double> bandNoise(std::size_t samples, double low_Hz, double high_Hz,
                                                    double sample_rate_Hz, std::uint64_t seed);

/// The hard, realistic case: one band-limited noise that reaches the three axes with different delays and gains.
/// What the paths do to the sum of the axes is a comb: some frequencies cancel.
[[nodiscard]] FYD_API ThreeAxes spread(std::span<const double> source, const std::array<Path, 3>& paths);

/// A linear chirp on each axis, low to high, high to low, and low to the middle; unit amplitude.
[[nodiscard]] FYD_API ThreeAxes chirps(std::size_t samples, double low_Hz, double high_Hz, double sample_rate_Hz);

}  // namespace fyd::texture
