// Fit of a surface model to a recording.
#include <algorithm>
#include <cmath>

#include "core/base/portable_math.h"
#include "core/signal/resonator.h"
#include "core/texture/acceleration_sample.h"
#include "core/texture/surface_model.h"
#include "core/texture/surface_ranges.h"

namespace fyd::texture {
namespace {

constexpr int kIterations = 400;
constexpr double kThirdOctaveQuality = 4.318;  // 1 / (2^(1/6) − 2^(−1/6))
constexpr double kFitFloor = 1e-6;             // of the strongest bin: weaker ones need not fit
constexpr double kWeakest = 1e-5;              // of the strongest band's power
constexpr std::size_t kShortest = 64;

std::vector<double> withoutMean(std::span<const double> axis) {
  double sum = 0.0;
  for (const double v : axis) sum += v;
  std::vector<double> out(axis.begin(), axis.end());
  for (double& v : out) v -= sum / static_cast<double>(axis.size());
  return out;
}

/// Column k: the power spectrum, per g² of the band's own mean square, at each bin.
std::vector<std::vector<double>> bandShapes(const std::vector<double>& centres_Hz, const signal::Spectrum& target,
                                            double sample_rate_Hz) {
  std::vector<std::vector<double>> shapes;
  for (const double centre_Hz : centres_Hz) {
    signal::Resonator resonator;
    resonator.tune(centre_Hz, kThirdOctaveQuality, sample_rate_Hz);
    std::vector<double> shape(target.density.size());
    const double white_density = 2.0 / sample_rate_Hz / resonator.noisePower();  // one-sided, for unit output
    for (std::size_t i = 0; i < shape.size(); ++i) {
      shape[i] = white_density * resonator.powerGain(target.frequency_Hz(i), sample_rate_Hz);
    }
    shapes.push_back(std::move(shape));
  }
  return shapes;
}

std::vector<double> mixed(const std::vector<std::vector<double>>& shapes, const std::vector<double>& powers,
                          std::size_t bins) {
  std::vector<double> out(bins, 0.0);
  for (std::size_t b = 0; b < shapes.size(); ++b) {
    for (std::size_t i = 0; i < bins; ++i) out[i] += powers[b] * shapes[b][i];
  }
  return out;
}

/// Powers of the bands, from the target's bin `from` on; see the header.
std::vector<double> fitPowers(const std::vector<std::vector<double>>& shapes, const std::vector<double>& target,
                              std::size_t from) {
  const double strongest = *std::max_element(target.begin() + static_cast<std::ptrdiff_t>(from), target.end());
  const double floor = kFitFloor * strongest;
  std::vector<double> powers(shapes.size(), strongest);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const std::vector<double> model = mixed(shapes, powers, target.size());
    for (std::size_t b = 0; b < shapes.size(); ++b) {
      double wanted = 0.0;
      double have = 0.0;
      for (std::size_t i = from; i < target.size(); ++i) {
        wanted += shapes[b][i] * (target[i] + floor) / (model[i] + floor);
        have += shapes[b][i];
      }
      if (have > 0.0) powers[b] *= wanted / have;
    }
  }
  return powers;
}

}  // namespace

Result<SurfaceFit> fitSurface(std::span<const double> x_g, std::span<const double> y_g, std::span<const double> z_g,
                              const FitConditions& conditions) {
  const std::size_t count = std::min({x_g.size(), y_g.size(), z_g.size()});
  if (count < kShortest) return fail("recording of {} samples: expected at least {}", count, kShortest);
  using C = FitConditions;
  const auto within = [](double value, double least, double most) { return value >= least && value <= most; };
  if (!within(conditions.force_N, C::kLeastForce_N, C::kLargestForce_N)) {
    return fail("force = {} N: expected {} … {}", conditions.force_N, C::kLeastForce_N, C::kLargestForce_N);
  }
  const bool moving = conditions.speed_mm_s != 0.0;
  if (moving && !within(conditions.speed_mm_s, C::kSlowest_mm_s, C::kFastest_mm_s)) {
    return fail("speed = {} mm/s: expected {} … {}, or none when it is unknown", conditions.speed_mm_s,
                C::kSlowest_mm_s, C::kFastest_mm_s);
  }
  const double rate_Hz = conditions.sample_rate_Hz;
  if (!within(rate_Hz, C::kSlowest_Hz, C::kFastest_Hz)) {
    return fail("rate = {} Hz: expected {} … {}", rate_Hz, C::kSlowest_Hz, C::kFastest_Hz);
  }
  for (const auto axis : {x_g, y_g, z_g}) {
    for (std::size_t i = 0; i < count; ++i) {
      if (within(axis[i], -kLargestAcceleration_g, kLargestAcceleration_g)) continue;
      return fail("recording: sample {} is {} g: expected {} … {}", i + 1, axis[i], -kLargestAcceleration_g,
                  kLargestAcceleration_g);
    }
  }
  const int segment = count >= 2048 ? 512 : static_cast<int>(kShortest);
  signal::Spectrum target;
  for (const auto axis : {x_g, y_g, z_g}) add(target, signal::welch(withoutMean(axis.first(count)), rate_Hz, segment));

  const double lowest_Hz = std::min(20.0, rate_Hz / 10.0);
  std::vector<double> centres_Hz;
  for (double f = lowest_Hz; f < 0.4 * rate_Hz && centres_Hz.size() < kMaximumBands; f *= math::cbrt(2.0)) {
    if (moving ? kWavelengths_mm.has(conditions.speed_mm_s / f) : kFrequencies_Hz.has(f)) centres_Hz.push_back(f);
  }
  if (centres_Hz.empty()) {
    return fail("recording of {} Hz at {} mm/s: no band of it can stand in a surface model", rate_Hz,
                conditions.speed_mm_s);
  }
  const auto from = static_cast<std::size_t>(std::ceil(lowest_Hz / target.resolution_Hz));
  double total = 0.0;
  for (std::size_t i = from; i < target.density.size(); ++i) total += target.density[i];
  if (!(total > 0.0)) return fail("recording: no vibration above {} Hz in it", lowest_Hz);

  const auto shapes = bandShapes(centres_Hz, target, rate_Hz);
  const std::vector<double> powers = fitPowers(shapes, target.density, from);

  SurfaceFit fit;
  fit.model.name = conditions.name;
  fit.model.reference_speed_mm_s = moving ? conditions.speed_mm_s : SurfaceModel{}.reference_speed_mm_s;
  fit.model.reference_force_N = conditions.force_N;
  const double strongest = *std::max_element(powers.begin(), powers.end());
  for (std::size_t b = 0; b < powers.size(); ++b) {
    if (powers[b] < kWeakest * strongest) continue;
    if (const double rms_g = std::sqrt(powers[b]); !kBandRms_g.has(rms_g)) {
      return fail("recording: {} g around {} Hz: expected at most {} g", rms_g, centres_Hz[b], kBandRms_g.maximum);
    }
    fit.model.bands.push_back({.wavelength_mm = moving ? conditions.speed_mm_s / centres_Hz[b] : 0.0,
                               .frequency_Hz = moving ? 0.0 : centres_Hz[b],
                               .quality = kThirdOctaveQuality,
                               .rms_g = std::sqrt(powers[b])});
  }
  const std::vector<double> model = mixed(shapes, powers, target.density.size());
  double difference = 0.0;
  double amplitude = 0.0;
  for (std::size_t i = from; i < model.size(); ++i) {
    difference += std::abs(std::sqrt(model[i]) - std::sqrt(target.density[i]));
    amplitude += std::sqrt(target.density[i]);
  }
  fit.spectral_match = 1.0 - difference / amplitude;
  return fit;
}

}  // namespace fyd::texture
