#include "core/signal/welch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"
#include "core/signal/fft.h"

namespace fyd::signal {

Spectrum welch(std::span<const double> signal, double sample_rate_Hz, int segment) {
  Spectrum out;
  const auto n = std::min(static_cast<std::size_t>(std::max(segment, 2)), signal.size());
  if (n < 2) return out;
  RealFft fft(static_cast<int>(n));
  std::vector<double> window(n);
  double window_power = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    window[i] = 0.5 - 0.5 * math::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n));
    window_power += window[i] * window[i];
  }
  out.resolution_Hz = sample_rate_Hz / static_cast<double>(n);
  out.density.assign(n / 2 + 1, 0.0);
  std::size_t segments = 0;
  for (std::size_t start = 0; start + n <= signal.size(); start += std::max<std::size_t>(n / 2, 1), ++segments) {
    for (std::size_t i = 0; i < n; ++i) fft.time()[i] = window[i] * signal[start + i];
    fft.forward();
    for (std::size_t k = 0; k < out.density.size(); ++k) out.density[k] += std::norm(fft.bins()[k]);
  }
  const double scale = 1.0 / (sample_rate_Hz * window_power * static_cast<double>(segments));
  for (std::size_t k = 0; k < out.density.size(); ++k) {
    const bool two_sided_pair = k != 0 && 2 * k != n;
    out.density[k] *= two_sided_pair ? 2.0 * scale : scale;
  }
  return out;
}

void add(Spectrum& a, const Spectrum& b) {
  if (a.density.empty()) {
    a = b;
    return;
  }
  for (std::size_t k = 0; k < std::min(a.density.size(), b.density.size()); ++k) a.density[k] += b.density[k];
}

}  // namespace fyd::signal
