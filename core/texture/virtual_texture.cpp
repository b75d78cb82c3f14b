#include "core/texture/virtual_texture.h"

#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"

namespace fyd::texture {
namespace {

constexpr double kGlide_s = 0.005;
constexpr double kFullFrom_mm_s = 10.0;  // the end of the rise out of quiet
constexpr double kFadeFrom = 0.40;       // of the sample rate
constexpr double kFadeTo = 0.45;

/// 0 at `from`, 1 at `to`, without a corner.
double smoothRise(double value, double from, double to) {
  const double t = std::clamp((value - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

double sane(double value, double largest) {
  return std::isfinite(value) && value > 0.0 ? std::min(value, largest) : 0.0;
}

}  // namespace

VirtualTexture::VirtualTexture(const SurfaceModel& model, double sample_rate_Hz, std::uint64_t seed)
    : model_(model), sample_rate_Hz_(sample_rate_Hz), seed_(seed) {
  for (const SurfaceBand& surface : model_.bands) bands_.push_back({.surface = surface});
  reset();
}

void VirtualTexture::reset() {
  random_ = seed_ * 0x9E3779B97F4A7C15ULL + 0x632BE59BD9B4E019ULL;
  for (Band& band : bands_) band.resonator.reset();
  speed_mm_s_ = force_N_ = gain_ = 0.0;
  until_retune_ = 0;
}

// SplitMix64 [Steele 2014]; uniform in ±√3, so of variance 1. Its distribution does not show behind a
// band-pass.
double VirtualTexture::white() {
  random_ += 0x9E3779B97F4A7C15ULL;
  std::uint64_t z = random_;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  z ^= z >> 31U;
  constexpr double kHalfWidth = 1.7320508075688772;
  return (static_cast<double>(z >> 11U) * 0x1.0p-52 - 1.0) * kHalfWidth;
}

void VirtualTexture::retune() {
  for (Band& band : bands_) {
    const SurfaceBand& s = band.surface;
    const double centre_Hz = s.wavelength_mm > 0.0 ? speed_mm_s_ / s.wavelength_mm : s.frequency_Hz;
    band.resonator.tune(centre_Hz, s.quality, sample_rate_Hz_);
    const double audible = 1.0 - smoothRise(centre_Hz, kFadeFrom * sample_rate_Hz_, kFadeTo * sample_rate_Hz_);
    band.level = audible * s.rms_g / std::sqrt(band.resonator.noisePower());
  }
  const double strongest_mm_s = 2.0 * model_.reference_speed_mm_s;
  const double speed = std::min(speed_mm_s_, strongest_mm_s) / model_.reference_speed_mm_s;
  const double force = force_N_ / model_.reference_force_N;
  gain_ = smoothRise(speed_mm_s_, kQuietBelow_mm_s, kFullFrom_mm_s);
  if (gain_ > 0.0) gain_ *= math::pow(speed, model_.speed_exponent) * math::pow(force, model_.force_exponent);
}

double VirtualTexture::step(double speed_mm_s, double force_N) {
  const double share = std::min(1.0, 1.0 / (kGlide_s * sample_rate_Hz_));
  speed_mm_s_ += share * (sane(speed_mm_s, kFastest_mm_s) - speed_mm_s_);
  force_N_ += share * (sane(force_N, kHardest_N) - force_N_);
  if (force_N_ < 1e-9) force_N_ = 0.0;
  if (speed_mm_s_ < 1e-9) speed_mm_s_ = 0.0;
  if (until_retune_-- == 0) {
    until_retune_ = kRetuneEvery - 1;
    retune();
  }
  double sum = 0.0;
  for (Band& band : bands_) sum += band.level * band.resonator.step(white());
  return gain_ * sum;
}

}  // namespace fyd::texture
