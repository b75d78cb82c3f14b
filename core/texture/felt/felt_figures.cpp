#include "core/texture/felt/felt_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/base/portable_math.h"
#include "core/signal/welch.h"
#include "core/texture/felt/felt_level.h"

namespace fyd::texture {
namespace {

constexpr double kRate_Hz = 1000.0;
constexpr double kLowest_Hz = 20.0;
constexpr std::size_t kEnvelopeWindow = 50;          // samples, overlap one half
constexpr std::size_t kLargestLag = 50;              // samples
constexpr double kThirdOctave = 1.2599210498948732;  // 2^(1/3)
constexpr double kSixthOctave = 1.122462048309373;   // 2^(1/6)
constexpr double kZeroPower = 1e-12;                 // sums up to this count as 0
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double decibels(double power_ratio) { return 10.0 * math::log(power_ratio) / 2.302585092994046; }  // ln 10

/// Length of a segment, a power of two: at most a quarter of the samples.
int welchSegment(std::size_t samples) {
  int segment = 512;
  while (segment > 8 && static_cast<std::size_t>(segment) * 4 > samples) segment /= 2;
  return segment;
}

double spectralMatch(const signal::Spectrum& wanted, const signal::Spectrum& finger) {
  double a = 0.0;
  double b = 0.0;
  for (std::size_t k = 0; k < wanted.density.size(); ++k) {
    if (wanted.frequency_Hz(k) < kLowest_Hz) continue;
    a += std::sqrt(wanted.density[k]);
    b += std::sqrt(finger.density[k]);
  }
  if (!(a > kZeroPower)) return kNaN;
  if (!(b > kZeroPower)) return 0.0;
  double difference = 0.0;
  for (std::size_t k = 0; k < wanted.density.size(); ++k) {
    if (wanted.frequency_Hz(k) < kLowest_Hz) continue;
    difference += std::abs(std::sqrt(wanted.density[k]) - std::sqrt(finger.density[k]) * a / b);
  }
  return 1.0 - difference / a;
}

double thirdOctaveError(const signal::Spectrum& wanted, const signal::Spectrum& finger) {
  std::vector<double> weights;
  std::vector<double> differences;
  // Counted, up to 317 Hz: the next, at the end of 400 Hz, would be one of them or not by its rounding.
  constexpr int kBands = 12;
  double centre = 25.0;
  for (int band = 0; band < kBands; ++band, centre *= kThirdOctave) {
    double a = 0.0;
    double b = 0.0;
    for (std::size_t k = 0; k < wanted.density.size(); ++k) {
      const double f = wanted.frequency_Hz(k);
      if (f < centre / kSixthOctave || f >= centre * kSixthOctave) continue;
      a += wanted.density[k];
      b += finger.density[k];
    }
    if (!(a > kZeroPower)) continue;
    weights.push_back(std::sqrt(a));
    differences.push_back(decibels(std::max(b, kZeroPower * a) / a));
  }
  double weight = 0.0;
  double mean = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    weight += weights[i];
    mean += weights[i] * differences[i];
  }
  if (!(weight > 0.0)) return kNaN;
  mean /= weight;
  double error = 0.0;
  for (std::size_t i = 0; i < weights.size(); ++i) error += weights[i] * std::abs(differences[i] - mean);
  return error / weight;
}

std::vector<double> envelopeOf(std::span<const double> x) {
  std::vector<double> out;
  for (std::size_t from = 0; from + kEnvelopeWindow <= x.size(); from += kEnvelopeWindow / 2) {
    double sum = 0.0;
    for (const double v : x.subspan(from, kEnvelopeWindow)) sum += v * v;
    out.push_back(std::sqrt(sum / kEnvelopeWindow));
  }
  return out;
}

double correlation(std::span<const double> a, std::span<const double> b) {
  double mean_a = 0.0;
  double mean_b = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    mean_a += a[i];
    mean_b += b[i];
  }
  mean_a /= static_cast<double>(a.size());
  mean_b /= static_cast<double>(b.size());
  double ab = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - mean_a) * (b[i] - mean_b);
    aa += (a[i] - mean_a) * (a[i] - mean_a);
    bb += (b[i] - mean_b) * (b[i] - mean_b);
  }
  return aa > kZeroPower && bb > kZeroPower ? ab / std::sqrt(aa * bb) : 0.0;
}

double lagOf(std::span<const double> wanted, std::span<const double> finger) {
  double best = 0.0;
  std::size_t at = 0;
  for (std::size_t lag = 0; lag <= kLargestLag && lag < wanted.size(); ++lag) {
    double sum = 0.0;
    for (std::size_t n = lag; n < wanted.size(); ++n) sum += finger[n] * wanted[n - lag];
    if (std::abs(sum) > best) {
      best = std::abs(sum);
      at = lag;
    }
  }
  return 1e3 * static_cast<double>(at) / kRate_Hz;
}

}  // namespace

FeltFigures compareFelt(std::span<const double> wanted, std::span<const double> finger) {
  const std::size_t count = std::min(wanted.size(), finger.size());
  if (count < 64) return {kNaN, kNaN, kNaN, kNaN, kNaN, kNaN};
  wanted = wanted.first(count);
  finger = finger.first(count);
  const int segment = welchSegment(count);
  const signal::Spectrum a = signal::welch(wanted, kRate_Hz, segment);
  const signal::Spectrum b = signal::welch(finger, kRate_Hz, segment);
  double power = 0.0;
  for (const double v : finger) power += v * v;
  FeltFigures out;
  out.spectral_match = spectralMatch(a, b);
  out.third_octave_error_dB = thirdOctaveError(a, b);
  out.envelope = correlation(envelopeOf(wanted), envelopeOf(finger));
  out.level_g = std::sqrt(power / static_cast<double>(count));
  out.level_dB = feltLevel_dB(out.level_g);
  out.lag_ms = lagOf(wanted, finger);
  return out;
}

}  // namespace fyd::texture
