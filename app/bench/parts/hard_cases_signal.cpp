// Filters, spectra and textures.
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "app/bench/parts/hard_case.h"
#include "core/signal/biquad.h"
#include "core/signal/fft.h"
#include "core/signal/high_pass.h"
#include "core/signal/resonator.h"
#include "core/texture/phase_rule.h"
#include "core/texture/pwm.h"
#include "core/texture/uniform_stream.h"

namespace fyd::bench {
namespace {

constexpr double kRate_Hz = 1000.0;

HardCase vibrationOnGravity() {
  constexpr double kVibration_g = 1e-8;
  const signal::BiquadCoefficients c = signal::highPass(0.1, kRate_Hz);
  double w1 = 1.0 / (1.0 + c.a1 + c.a2), w2 = w1;  // direct form II, in its steady state
  signal::Biquad<double> ours(c);
  ours.settleAt(1.0);
  long double x1 = 1.0L, x2 = 1.0L, y1 = 0.0L, y2 = 0.0L;
  HardCase out{.name = "a vibration of 1e-8 g on 1 g of gravity through a high-pass of 0.1 Hz",
               .naive = "direct form II: its state is two million times the input",
               .ours = "direct form I, b = g·(1, −2, 1) from left to right (`signal::Biquad`)",
               .truth = "the equation in long double",
               .unit = "of the vibration",
               .at_most = 1e-6};
  for (int i = 0; i < 20'000; ++i) {
    const double x = 1.0 + kVibration_g * std::sin(0.6 * i);
    const long double truth = c.b0 * static_cast<long double>(x) + c.b1 * x1 + c.b2 * x2 - c.a1 * y1 - c.a2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = truth;
    const double w = x - c.a1 * w1 - c.a2 * w2;
    const double naive = c.b0 * w + c.b1 * w1 + c.b2 * w2;
    w2 = w1;
    w1 = w;
    const auto off = [&](double y) { return static_cast<double>(std::abs(y - truth)) / kVibration_g; };
    out.naive_error = std::max(out.naive_error, off(naive));
    out.our_error = std::max(out.our_error, off(ours.step(x)));
  }
  return out;
}

HardCase gravityThroughTheHighPass() {
  signal::Biquad<double> naive(signal::thesisHighPass()), ours(signal::highPass(20.0, kRate_Hz));
  double by_naive = 0.0, by_ours = 0.0;
  for (int i = 0; i < 20'000; ++i) {
    by_naive = naive.step(1.0);
    by_ours = ours.step(1.0);
  }
  return {.name = "1 g of gravity through a high-pass, after 20 s",
          .naive = "the coefficients as printed: they add up to 5e-4",
          .ours = "b = g·(1, −2, 1), which adds up to exactly 0 (`signal::highPass`)",
          .truth = "by definition: 0",
          .unit = "g",
          .naive_error = std::abs(by_naive),
          .our_error = std::abs(by_ours),
          .at_most = 0.0};
}

HardCase silenceAfterASound() {
  const signal::BiquadCoefficients c = signal::highPass(20.0, kRate_Hz);
  signal::Biquad<double> ours(c);
  double x1 = 0.0, x2 = 0.0, y1 = 0.0, y2 = 0.0;
  HardCase out{.name = "silence after a sound: outputs that are denormal",
               .naive = "the filter's equation as it is",
               .ours = "outputs below 1e-30 are 0 (`signal::Biquad`)",
               .truth = "by definition: none",
               .unit = "of 200 000 samples",
               .at_most = 0.0};
  for (int i = 0; i < 200'000; ++i) {
    const double x = i == 0 ? 1.0 : 0.0;
    const double y = c.b0 * x + c.b1 * x1 + c.b2 * x2 - c.a1 * y1 - c.a2 * y2;
    x2 = x1;
    x1 = x;
    y2 = y1;
    y1 = y;
    out.naive_error += std::fpclassify(y) == FP_SUBNORMAL ? 1.0 : 0.0;
    out.our_error += std::fpclassify(ours.step(x)) == FP_SUBNORMAL ? 1.0 : 0.0;
  }
  return out;
}

HardCase cornerAtNyquist() {
  const double k = std::tan(std::numbers::pi * 500.0 / kRate_Hz), root2 = std::numbers::sqrt2;
  const double g = 1.0 / (1.0 + root2 * k + k * k);
  signal::Biquad<double> naive({g, -2.0 * g, g, 2.0 * (k * k - 1.0) * g, (1.0 - root2 * k + k * k) * g});
  signal::Biquad<double> ours(signal::highPass(500.0, kRate_Hz));
  double by_naive = 0.0, by_ours = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double x = i % 2 == 0 ? 1.0 : -1.0;
    by_naive = naive.step(x) * x;
    by_ours = ours.step(x) * x;
  }
  return {.name = "a high-pass whose corner is half the sample rate: gain there",
          .naive = "the bilinear transform as printed: tan 90°",
          .ours = "the corner is brought to 0.49 of the rate (`signal::highPass`)",
          .truth = "closed form: 1",
          .unit = "",
          .naive_error = std::abs(by_naive - 1.0),
          .our_error = std::abs(by_ours - 1.0),
          .at_most = 1e-9};
}

HardCase centreThatJumps() {
  constexpr double kQuality = 20.0;
  signal::Resonator ours;
  double z1 = 0.0, z2 = 0.0;
  double early_naive = 0.0, early_ours = 0.0, late_naive = 0.0, late_ours = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const double x = i == 0 ? 1.0 : 0.0, centre_Hz = i % 2 == 0 ? 60.0 : 350.0;
    ours.tune(centre_Hz, kQuality, kRate_Hz);
    const double y = ours.step(x);
    // The usual cookbook band-pass, its coefficients replaced while it runs; transposed direct form II.
    const double w = 2.0 * std::numbers::pi * centre_Hz / kRate_Hz, alpha = std::sin(w) / (2.0 * kQuality);
    const double a0 = 1.0 + alpha, b0 = alpha / a0, a1 = -2.0 * std::cos(w) / a0, a2 = (1.0 - alpha) / a0;
    const double n = b0 * x + z1;
    z1 = z2 - a1 * n;
    z2 = -b0 * x - a2 * n;
    (i < 100 ? early_naive : late_naive) = std::max(i < 100 ? early_naive : late_naive, std::abs(n));
    (i < 100 ? early_ours : late_ours) = std::max(i < 100 ? early_ours : late_ours, std::abs(y));
  }
  const auto growth = [](double early, double late) {
    return std::isfinite(late) ? std::max(0.0, late / early - 1.0) : kNotFinite;
  };
  return {.name = "a band-pass whose centre jumps at each sample, after its input has ended: growth",
          .naive = "cookbook coefficients replaced while it runs",
          .ours = "topology-preserving filter (`signal::Resonator`)",
          .truth = "no energy comes in: 0",
          .unit = "of the first swing",
          .naive_error = growth(early_naive, late_naive),
          .our_error = growth(early_ours, late_ours),
          .at_most = 0.0};
}

HardCase lowestBinOfAMillion() {
  constexpr int kLength = 1 << 20;
  constexpr long double kPhase = 0.3L;
  const long double step = 2.0L * std::numbers::pi_v<long double> / kLength;
  signal::RealFft fft(kLength);
  const double coefficient = 2.0 * std::cos(static_cast<double>(step));
  double s1 = 0.0, s2 = 0.0;
  for (int n = 0; n < kLength; ++n) {
    const auto x = static_cast<double>(std::cos(step * n + kPhase));
    fft.time()[static_cast<std::size_t>(n)] = x;
    const double s = x + coefficient * s1 - s2;
    s2 = s1;
    s1 = s;
  }
  fft.forward();
  const auto w = static_cast<double>(step);
  const std::complex<double> goertzel(s1 * std::cos(w) - s2, s1 * std::sin(w));
  const std::complex<double> truth = std::polar(0.5 * kLength, static_cast<double>(kPhase));
  return {.name = "the lowest frequency of a million samples",
          .naive = "Goertzel's recurrence",
          .ours = "FFTW (`signal::RealFft`)",
          .truth = "closed form: N/2·exp(0.3i)",
          .unit = "relative",
          .naive_error = std::abs(goertzel - truth) / std::abs(truth),
          .our_error = std::abs(fft.bins()[1] - truth) / std::abs(truth),
          .at_most = 1e-12};
}

HardCase axesInAntiphase() {
  using Complex = std::complex<double>;
  const auto printed = [](Complex x, Complex y, Complex z) {
    return std::polar(std::sqrt(std::norm(x) + std::norm(y) + std::norm(z)), std::arg(x + y + z));
  };
  HardCase out{.name = "DFT321 of two axes in antiphase, with 1e-9 of noise: how far the output moves",
               .naive = "the phase of the sum, as printed",
               .ours = "a direction that stays where the sum vanishes (`texture::combineAxes`)",
               .truth = "the same without noise",
               .unit = "of the amplitude",
               .at_most = 1e-6};
  for (int i = 0; i < 360; ++i) {
    const Complex noise = std::polar(1e-9, std::numbers::pi / 180.0 * i);
    out.naive_error = std::max(out.naive_error, std::abs(printed(1.0, -1.0, noise) - printed(1.0, -1.0, 0.0)));
    out.our_error = std::max(out.our_error,
                             std::abs(texture::combineAxes(1.0, -1.0, noise) - texture::combineAxes(1.0, -1.0, 0.0)));
  }
  out.naive_error /= std::numbers::sqrt2;
  out.our_error /= std::numbers::sqrt2;
  return out;
}

HardCase dutyOfASine() {
  const texture::PwmSettings settings{.dead_zone_percent = 0.0};
  constexpr int kSamples = 1000;
  double by_floor = 0.0, by_ours = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    const double signal_g = std::sin(2.0 * std::numbers::pi * (i + 0.5) / kSamples);
    by_floor += texture::thesisDuty(signal_g, settings).percent / kSamples;
    by_ours += texture::symmetricDuty(signal_g, settings).percent / kSamples;
  }
  return {.name = "mean duty of a sine",
          .naive = "floor, as printed",
          .ours = "halves away from zero (`texture::symmetricDuty`)",
          .truth = "symmetry: 0",
          .unit = "%",
          .naive_error = std::abs(by_floor),
          .our_error = std::abs(by_ours),
          .at_most = 1e-9};
}

HardCase sensorWithASlowClock() {
  // 999 samples a second for ten minutes, each stamped; the acceleration is its own time.
  constexpr int kMinutes = 10;
  constexpr double kSlope_g_per_s = 1.0;
  texture::UniformStream stream(kRate_Hz);
  stream.configure(5.0, 20.0);
  const Instant start = instantAt(1000.0);
  const auto stamp = [&](std::int64_t n) { return start + std::chrono::nanoseconds(n * 1'000'000'000 / 999); };
  std::int64_t sent = 0;
  double lag_ms = 0.0, first_ms = std::nan("");
  for (int ms = 1; ms <= kMinutes * 60'000; ++ms) {
    const Instant now = start + std::chrono::milliseconds(ms);
    for (; stamp(sent) <= now; ++sent) {
      const texture::AccelerationSample sample{stamp(sent),
                                               {kSlope_g_per_s * toSeconds(stamp(sent) - start), 0.0, 0.0}};
      stream.push(now, {&sample, 1});
    }
    const auto step = stream.step(now);
    if (step.gap) continue;
    lag_ms = ms - 1e3 * step.acceleration_g.x / kSlope_g_per_s;
    if (ms >= 1000 && std::isnan(first_ms)) first_ms = lag_ms;
  }
  return {.name = "a sensor whose clock is 0.1 % slow, ten minutes: its lag grows by",
          .naive = "a sample counts as 1 ms",
          .ours = "by its time stamp (`texture::UniformStream`)",
          .truth = "the stamps: 0",
          .unit = "ms",
          .naive_error = kMinutes * 60'000 - static_cast<double>(sent),
          .our_error = std::abs(lag_ms - first_ms),
          .at_most = 2.0};
}

}  // namespace

std::vector<HardCase> hardCasesOfSignals() {
  return {vibrationOnGravity(),  gravityThroughTheHighPass(), silenceAfterASound(), cornerAtNyquist(),
          centreThatJumps(),     lowestBinOfAMillion(),       axesInAntiphase(),    dutyOfASine(),
          sensorWithASlowClock()};
}

}  // namespace fyd::bench
