// High-pass filters, FFT, Welch spectra and resonator against their definitions and closed forms.
#include <complex>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/signal/fft.h"
#include "core/signal/high_pass.h"
#include "core/signal/resonator.h"
#include "core/signal/welch.h"

namespace fyd::signal {
namespace {

constexpr double kPi = std::numbers::pi;

/// |H| at a frequency, from the coefficients themselves.
std::complex<double> response(const BiquadCoefficients& c, double cycles_per_sample) {
  const std::complex<double> z = std::polar(1.0, -2.0 * kPi * cycles_per_sample);
  return (c.b0 + c.b1 * z + c.b2 * z * z) / (1.0 + c.a1 * z + c.a2 * z * z);
}

std::vector<double> noise(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> out(count);
  for (double& v : out) v = normal(random);
  return out;
}

TEST(HighPass, ThesisAnswersAnImpulseWithThePrintedRecursionBitForBit) {
  Biquad<double> filter(thesisHighPass());
  // y0 = b0; y1 = b1 − a1·y0; y2 = b2 − a1·y1 − a2·y0; y3 = −a1·y2 − a2·y1, written out left to right.
  const double y0 = -0.7162;
  const double y1 = 1.433 * 1.0 - (-1.372) * y0;
  const double y2 = -0.7163 * 1.0 - (-1.372) * y1 - 0.4998 * y0;
  const double y3 = 0.0 - (-1.372) * y2 - 0.4998 * y1;
  EXPECT_EQ(filter.step(1.0), y0);
  EXPECT_EQ(filter.step(0.0), y1);
  EXPECT_EQ(filter.step(0.0), y2);
  EXPECT_EQ(filter.step(0.0), y3);
  EXPECT_NEAR(y1, 0.4503736, 1e-9);  // by hand: 1.433 − 1.372·0.7162
  EXPECT_NEAR(y2, 0.2595693, 1e-7);  // −0.7163 + 1.372·0.4503736 + 0.4998·0.7162
}

TEST(HighPass, ThesisLeaksGravityAndInvertsThePassband) {
  const double dc = std::abs(response(thesisHighPass(), 0.0));
  EXPECT_NEAR(dc, 5e-4 / 0.1278, 1e-6);  // Σb / Σa = 0.0005 / 0.1278
  EXPECT_NEAR(20.0 * std::log10(dc), -48.15, 0.01);
  EXPECT_NEAR(response(thesisHighPass(), 0.5).real(), -0.998, 5e-4);
  EXPECT_NEAR(std::norm(response(thesisHighPass(), 0.0783)), 0.5, 3e-3);
}

TEST(HighPass, DefaultIsMinusThreeDecibelsAtItsCornerAtAnyRate) {
  for (const double rate_Hz : {250.0, 1000.0, 2500.0, 10000.0}) {
    for (const double corner_Hz : {5.0, 78.0, 110.0}) {
      const BiquadCoefficients c = highPass(corner_Hz, rate_Hz);
      EXPECT_NEAR(std::norm(response(c, corner_Hz / rate_Hz)), 0.5, 1e-9) << rate_Hz << " " << corner_Hz;
      EXPECT_NEAR(response(c, 0.5).real(), 1.0, 1e-12);
      EXPECT_EQ(c.b0 + c.b1 + c.b2, 0.0);
    }
  }
}

TEST(HighPass, DefaultLetsLessThanAMillionthOfGravityThrough) {
  Biquad<double> filter(highPass(78.0, 1000.0));
  double y = 0.0;
  for (int n = 0; n < 1000; ++n) y = filter.step(1.0);
  EXPECT_LE(std::abs(y), 1e-6);  // −120 dB
  for (int n = 0; n < 1000000; ++n) y = filter.step(1.0);
  EXPECT_EQ(y, 0.0);
  Biquad<double> settled(highPass(78.0, 1000.0));
  settled.settleAt(9.81);
  EXPECT_EQ(settled.step(9.81), 0.0);
}

TEST(HighPass, FloatAgreesWithDoubleToAHundredThousandthOfFullScale) {
  // Stated in the manual: corner 20 Hz and up at 1 kHz, input within ±1.
  for (const BiquadCoefficients& c : {highPass(78.0, 1000.0), highPass(20.0, 1000.0), thesisHighPass()}) {
    Biquad<double> exact(c);
    Biquad<float> single(c);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<float> uniform(-1.0F, 1.0F);
    double worst = 0.0;
    for (int n = 0; n < 100000; ++n) {
      const float x = uniform(random);
      worst = std::max(worst, std::abs(exact.step(x) - static_cast<double>(single.step(x))));
    }
    EXPECT_LT(worst, 1e-5);
    EXPECT_GT(worst, 0.0);
  }
}

TEST(Fft, AgreesWithTheDefinitionAndComesBack) {
  for (const int n : {1, 2, 3, 8, 31, 100}) {
    RealFft fft(n);
    const auto x = noise(static_cast<std::size_t>(n), 3);
    std::copy(x.begin(), x.end(), fft.time().begin());
    fft.forward();
    for (std::size_t k = 0; k < fft.bins().size(); ++k) {
      std::complex<double> sum;
      for (std::size_t i = 0; i < x.size(); ++i) {
        sum += x[i] * std::polar(1.0, -2.0 * kPi * static_cast<double>(k * i) / n);
      }
      EXPECT_LT(std::abs(sum - fft.bins()[k]), 1e-12 * n) << n << " " << k;
    }
    fft.backward();
    for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(fft.time()[i], x[i], 1e-14 * n);
  }
}

TEST(Welch, IntegratesToTheMeanSquareAndFindsATone) {
  std::vector<double> x(20000);
  for (std::size_t n = 0; n < x.size(); ++n) x[n] = 3.0 * std::sin(2.0 * kPi * 125.0 * static_cast<double>(n) / 1000.0);
  const Spectrum s = welch(x, 1000.0, 512);
  double integral = 0.0;
  std::size_t loudest = 0;
  for (std::size_t k = 0; k < s.density.size(); ++k) {
    integral += s.density[k] * s.resolution_Hz;
    if (s.density[k] > s.density[loudest]) loudest = k;
  }
  EXPECT_NEAR(integral, 4.5, 1e-3);
  EXPECT_NEAR(s.frequency_Hz(loudest), 125.0, 1e-9);
}

TEST(Resonator, NoisePowerAndGainAreWhatTheHeaderSays) {
  Resonator r;
  r.tune(140.0, 3.0, 1000.0);
  const auto white = noise(400000, 9);
  double power = 0.0;
  for (const double w : white) {
    const double y = r.step(w);
    power += y * y;
  }
  EXPECT_NEAR(power / static_cast<double>(white.size()) / r.noisePower(), 1.0, 0.03);
  for (const double f : {60.0, 140.0, 300.0}) {
    r.reset();
    double energy = 0.0;
    for (int n = 0; n < 20000; ++n) {
      const double y = r.step(std::sin(2.0 * kPi * f * n / 1000.0));
      if (n >= 10000) energy += y * y;
    }
    EXPECT_NEAR(energy / 5000.0, r.powerGain(f, 1000.0), 1e-3) << f;
  }
}

}  // namespace
}  // namespace fyd::signal
