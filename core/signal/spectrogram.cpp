#include "core/signal/spectrogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "core/base/portable_math.h"
#include "core/signal/fft.h"

namespace fyd::signal {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

std::vector<double> Spectrogram::mean() const {
  std::vector<double> out(bins, 0.0);
  std::size_t whole = 0;
  for (std::size_t s = 0; s < segments(); ++s) {
    if (!std::isfinite(segment(s).front())) continue;
    ++whole;
    for (std::size_t k = 0; k < bins; ++k) out[k] += segment(s)[k] * segment(s)[k];
  }
  for (double& each : out) each = whole == 0 ? kNaN : std::sqrt(each / static_cast<double>(whole));
  return out;
}

Spectrogram spectrogram(std::span<const double> time_s, std::span<const float> signal, double rate_Hz, int segment,
                        double tolerance) {
  constexpr int kShortest = 8;
  Spectrogram out;
  if (segment < kShortest || time_s.size() != signal.size() || !(rate_Hz > 0.0)) return out;
  const auto n = static_cast<std::size_t>(segment);
  if (signal.size() < n) return out;
  RealFft fft(segment);
  std::vector<double> window(n);
  for (std::size_t i = 0; i < n; ++i) {
    window[i] = 0.5 - 0.5 * math::cos(2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n));
  }
  const double window_sum = std::accumulate(window.begin(), window.end(), 0.0);
  const double length_s = static_cast<double>(n - 1) / rate_Hz;
  out.bins = n / 2 + 1;
  out.resolution_Hz = rate_Hz / static_cast<double>(n);
  out.first_time_s = time_s.front() + 0.5 * length_s;
  const std::size_t hop = n / 2;
  out.step_s = static_cast<double>(hop) / rate_Hz;
  for (std::size_t start = 0; start + n <= signal.size(); start += hop) {
    // Later segments stand where they were measured: what a hole in time leaves out takes its place.
    const double step = (time_s[start] - time_s.front()) / out.step_s;
    while (static_cast<double>(out.segments()) + 0.5 < step) out.amplitude.insert(out.amplitude.end(), out.bins, kNaN);
    const auto part = signal.subspan(start, n);
    const double took_s = time_s[start + n - 1] - time_s[start];
    const bool whole = std::abs(took_s - length_s) <= tolerance * length_s &&
                       std::ranges::all_of(part, [](float v) { return std::isfinite(v); });
    if (!whole) {
      out.amplitude.insert(out.amplitude.end(), out.bins, kNaN);
      continue;
    }
    const double mean = std::accumulate(part.begin(), part.end(), 0.0) / static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) fft.time()[i] = window[i] * (part[i] - mean);
    fft.forward();
    for (std::size_t k = 0; k < out.bins; ++k) {
      const bool single = k == 0 || 2 * k == n;
      out.amplitude.push_back((single ? 1.0 : 2.0) * math::abs(fft.bins()[k]) / window_sum);
    }
  }
  return out;
}

}  // namespace fyd::signal
