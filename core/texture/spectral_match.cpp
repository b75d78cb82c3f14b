#include "core/texture/spectral_match.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/signal/welch.h"

namespace fyd::texture {
namespace {

constexpr double kLowestMatched_Hz = 20.0;

int segmentFor(std::size_t samples) {
  int segment = 512;
  while (segment > 8 && static_cast<std::size_t>(segment) * 4 > samples) segment /= 2;
  return segment;
}

double energyOf(std::span<const double> s) {
  double sum = 0.0;
  for (const double v : s) sum += v * v;
  return sum;
}

}  // namespace

MatchFigures compareSpectra(std::span<const double> x, std::span<const double> y, std::span<const double> z,
                            std::span<const double> signal, int delay_samples, double sample_rate_Hz) {
  const auto delay = static_cast<std::size_t>(std::max(delay_samples, 0));
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const std::size_t shortest = std::min({x.size(), y.size(), z.size(), signal.size()});
  if (shortest < delay + 8) return {kNaN, kNaN};
  const std::size_t count = shortest - delay;
  const auto late = signal.subspan(delay, count);

  const int segment = segmentFor(count);
  signal::Spectrum reference;
  double reference_energy = 0.0;
  for (const auto axis : {x, y, z}) {
    add(reference, signal::welch(axis.first(count), sample_rate_Hz, segment));
    reference_energy += energyOf(axis.first(count));
  }
  const signal::Spectrum spectrum = signal::welch(late, sample_rate_Hz, segment);

  double difference = 0.0;
  double total = 0.0;
  for (std::size_t k = 0; k < spectrum.density.size(); ++k) {
    if (spectrum.frequency_Hz(k) < kLowestMatched_Hz) continue;
    difference += std::abs(std::sqrt(spectrum.density[k]) - std::sqrt(reference.density[k]));
    total += std::sqrt(reference.density[k]);
  }
  return {.spectral_match = total > 0.0 ? 1.0 - difference / total : kNaN,
          .energy_ratio = reference_energy > 0.0 ? energyOf(late) / reference_energy : kNaN};
}

double edgeJumpRatio(std::span<const double> signal, int period, int delay_samples) {
  if (period < 2) return std::numeric_limits<double>::quiet_NaN();
  double at_edges = 0.0;
  double elsewhere = 0.0;
  std::size_t edges = 0;
  std::size_t others = 0;
  for (std::size_t n = static_cast<std::size_t>(std::max(delay_samples, 0)) + 1; n < signal.size(); ++n) {
    const double jump = std::abs(signal[n] - signal[n - 1]);
    const bool edge = (n - static_cast<std::size_t>(delay_samples)) % static_cast<std::size_t>(period) == 0;
    (edge ? at_edges : elsewhere) += jump;
    ++(edge ? edges : others);
  }
  if (edges == 0 || others == 0 || elsewhere == 0.0) return std::numeric_limits<double>::quiet_NaN();
  return (at_edges / static_cast<double>(edges)) / (elsewhere / static_cast<double>(others));
}

}  // namespace fyd::texture
