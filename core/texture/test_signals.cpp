#include "core/texture/test_signals.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "core/base/portable_math.h"
#include "core/signal/fft.h"

namespace fyd::texture {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;

double bandShape(double frequency_Hz, double low_Hz, double high_Hz) {
  const double edge_Hz = 0.1 * (high_Hz - low_Hz);
  const double inside_Hz = std::min(frequency_Hz - low_Hz, high_Hz - frequency_Hz);
  if (inside_Hz <= 0.0) return 0.0;
  if (inside_Hz >= edge_Hz) return 1.0;
  return 0.5 - 0.5 * math::cos(std::numbers::pi * inside_Hz / edge_Hz);
}

std::vector<double> chirp(std::size_t samples, double from_Hz, double to_Hz, double sample_rate_Hz) {
  std::vector<double> out(samples);
  double phase = 0.0;
  for (std::size_t n = 0; n < samples; ++n) {
    out[n] = math::sin(phase);
    const double progress = static_cast<double>(n) / static_cast<double>(samples);
    phase = std::fmod(phase + kTwoPi * (from_Hz + (to_Hz - from_Hz) * progress) / sample_rate_Hz, kTwoPi);
  }
  return out;
}

}  // namespace

std::vector<double> bandNoise(std::size_t samples, double low_Hz, double high_Hz, double sample_rate_Hz,
                              std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  signal::RealFft fft(static_cast<int>(samples));
  for (std::size_t k = 0; k < fft.bins().size(); ++k) {
    const double frequency_Hz = static_cast<double>(k) * sample_rate_Hz / static_cast<double>(samples);
    const double shape = bandShape(frequency_Hz, low_Hz, high_Hz);
    fft.bins()[k] = {shape * normal(random), shape * normal(random)};
  }
  fft.backward();
  double energy = 0.0;
  for (const double v : fft.time()) energy += v * v;
  const double scale = std::sqrt(static_cast<double>(samples) / energy);
  std::vector<double> out(fft.time().begin(), fft.time().end());
  for (double& v : out) v *= scale;
  return out;
}

ThreeAxes spread(std::span<const double> source, const std::array<Path, 3>& paths) {
  ThreeAxes out;
  signal::RealFft fft(static_cast<int>(source.size()));
  const std::array<std::vector<double>*, 3> axes = {&out.x, &out.y, &out.z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::copy(source.begin(), source.end(), fft.time().begin());
    fft.forward();
    for (std::size_t k = 0; k < fft.bins().size(); ++k) {
      const double turn =
          -kTwoPi * static_cast<double>(k) * paths[axis].delay_samples / static_cast<double>(source.size());
      fft.bins()[k] *= math::polar(paths[axis].gain, turn);
    }
    fft.backward();
    axes[axis]->assign(fft.time().begin(), fft.time().end());
  }
  return out;
}

ThreeAxes chirps(std::size_t samples, double low_Hz, double high_Hz, double sample_rate_Hz) {
  return {.x = chirp(samples, low_Hz, high_Hz, sample_rate_Hz),
          .y = chirp(samples, high_Hz, low_Hz, sample_rate_Hz),
          .z = chirp(samples, low_Hz, 0.5 * (low_Hz + high_Hz), sample_rate_Hz)};
}

}  // namespace fyd::texture
