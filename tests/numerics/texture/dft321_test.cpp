// DFT321 against its definition in long double, its phase rule, its energy, its speed against the printed loops.
#include <complex>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "core/texture/dft321.h"
#include "core/texture/phase_rule.h"
#include "tests/processor_time.h"

namespace fyd::texture {
namespace {

using Long = long double;
using LongBin = std::complex<Long>;

std::vector<double> noise(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> out(count);
  for (double& v : out) v = normal(random);
  return out;
}

/// The definition: DFT of each axis, magnitude √Σ|A|², phase of ΣA, inverse DFT; O(N²), long double.
std::vector<Long> definition(const std::array<std::vector<double>, 3>& axes) {
  const std::size_t n = axes[0].size();
  std::vector<LongBin> turn(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Long angle = -2.0L * std::numbers::pi_v<Long> * static_cast<Long>(i) / static_cast<Long>(n);
    turn[i] = {std::cos(angle), std::sin(angle)};
  }
  std::vector<LongBin> bins(n);
  for (std::size_t k = 0; k < n; ++k) {
    LongBin sum;
    Long energy = 0.0L;
    for (const auto& axis : axes) {
      LongBin a;
      std::size_t at = 0;  // k·i modulo n
      for (std::size_t i = 0; i < n; ++i) {
        a += static_cast<Long>(axis[i]) * turn[at];
        at += k;
        if (at >= n) at -= n;
      }
      sum += a;
      energy += std::norm(a);
    }
    bins[k] = std::sqrt(energy) * sum / std::abs(sum);
  }
  std::vector<Long> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    Long value = 0.0L;
    std::size_t at = 0;
    for (std::size_t k = 0; k < n; ++k) {
      value += (bins[k] * std::conj(turn[at])).real();
      at += i;
      if (at >= n) at -= n;
    }
    out[i] = value / static_cast<Long>(n);
  }
  return out;
}

double energyOf(std::span<const double> s) {
  double sum = 0.0;
  for (const double v : s) sum += v * v;
  return sum;
}

TEST(Dft321, EqualsItsDefinitionAndKeepsTheEnergyAtEveryLength) {
  std::vector<int> lengths;
  for (int n = 1; n <= 257; ++n) lengths.push_back(n);
  for (const int n : {509, 512, 521, 997, 1000, 1024}) lengths.push_back(n);
  for (const int n : lengths) {
    const auto count = static_cast<std::size_t>(n);
    const auto seed = static_cast<unsigned>(n);
    const std::array<std::vector<double>, 3> axes = {noise(count, seed), noise(count, seed + 5000),
                                                     noise(count, seed + 9000)};
    Dft321Frame frame(n);
    const auto out = frame.transform(axes[0], axes[1], axes[2]);
    const auto expected = definition(axes);
    Long difference = 0.0L;
    Long size = 0.0L;
    for (std::size_t i = 0; i < count; ++i) {
      difference += (out[i] - expected[i]) * (out[i] - expected[i]);
      size += expected[i] * expected[i];
    }
    ASSERT_LE(std::sqrt(difference / size), 1e-12L) << n;
    const double energy = energyOf(axes[0]) + energyOf(axes[1]) + energyOf(axes[2]);
    ASSERT_NEAR(energyOf(out) / energy, 1.0, 1e-12) << n;
  }
}

TEST(Dft321, AnotherKnownCaseByHand) {
  // N = 2: bins x0 ± x1. x = (1, 0), y = (0, 2), z = 0: DC 1 and 2 → +√5; Nyquist 1 and −2, sum −1 → −√5.
  Dft321Frame frame(2);
  const std::array<double, 2> x = {1.0, 0.0};
  const std::array<double, 2> y = {0.0, 2.0};
  const std::array<double, 2> z = {0.0, 0.0};
  const auto out = frame.transform(x, y, z);
  EXPECT_NEAR(out[0], 0.0, 1e-15);
  EXPECT_NEAR(out[1], std::sqrt(5.0), 1e-15);
}

TEST(PhaseRule, IsTheDefinitionWhereverTheSumIsNotNearlyNothing) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  int checked = 0;
  for (int i = 0; i < 200000; ++i) {
    const auto draw = [&] { return std::complex<double>(normal(random), normal(random)); };
    const std::complex<double> x = draw();
    const std::complex<double> y = draw();
    // Every second case lies near antiphase: the sum small, down to the rule's limit and below.
    std::complex<double> z = draw();
    if (i % 2 == 0) z = -x - y + std::pow(10.0, -4.0 * (i % 1000) / 1000.0) * z;
    const double magnitude = std::sqrt(std::norm(x) + std::norm(y) + std::norm(z));
    const std::complex<double> sum = x + y + z;
    const std::complex<double> a = combineAxes(x, y, z);
    ASSERT_NEAR(std::abs(a) / magnitude, 1.0, 1e-14);
    if (std::abs(sum) < kAntiphaseRatio * magnitude) continue;
    ASSERT_LT(std::abs(a - magnitude * sum / std::abs(sum)), 1e-14 * magnitude);
    ++checked;
  }
  EXPECT_GT(checked, 150000);
}

/// Antiphase pairs, the (2, −1, −1) pattern and rotating axes, in which the sum vanishes at all times.
std::array<std::vector<double>, 3> antiphase(int pattern, std::size_t count) {
  const auto s = noise(count, 77);
  std::array<std::vector<double>, 3> a;
  for (auto& axis : a) axis.assign(count, 0.0);
  for (std::size_t n = 0; n < count; ++n) {
    const double turn = 2.0 * std::numbers::pi * 0.13 * static_cast<double>(n);
    switch (pattern) {
      case 0: a[0][n] = s[n], a[1][n] = -s[n]; break;
      case 1: a[0][n] = s[n], a[2][n] = -s[n]; break;
      case 2: a[1][n] = s[n], a[2][n] = -s[n]; break;
      case 3: a[0][n] = 2 * s[n], a[1][n] = a[2][n] = -s[n]; break;
      case 4: a[0][n] = a[1][n] = s[n], a[2][n] = -2 * s[n]; break;
      default:
        for (std::size_t i = 0; i < 3; ++i)
          a[i][n] = std::cos(turn + 2.0 * std::numbers::pi * static_cast<double>(i) / 3);
    }
  }
  return a;
}

TEST(PhaseRule, AtExactAntiphaseABillionthOfNoiseMovesTheOutputByLessThanAMillionth) {
  for (int pattern = 0; pattern <= 5; ++pattern) {
    for (const int hop : {64, 32}) {
      const std::size_t count = 4096;
      const auto clean = antiphase(pattern, count);
      auto noisy = clean;
      for (std::size_t i = 0; i < 3; ++i) {
        const auto extra = noise(count, static_cast<unsigned>(100 + i));
        for (std::size_t n = 0; n < count; ++n) noisy[i][n] += 1e-9 * extra[n];
      }
      Dft321 a(64, hop, 1000.0);
      Dft321 b(64, hop, 1000.0);
      double energy_in = 0.0;
      double energy_out = 0.0;
      double moved = 0.0;
      for (std::size_t n = 0; n < count; ++n) {
        const double p = a.step({clean[0][n], clean[1][n], clean[2][n]});
        const double q = b.step({noisy[0][n], noisy[1][n], noisy[2][n]});
        moved = std::max(moved, std::abs(p - q));
        if (n >= 63) energy_out += p * p;
        if (n + 63 < count) {
          energy_in += clean[0][n] * clean[0][n] + clean[1][n] * clean[1][n] + clean[2][n] * clean[2][n];
        }
      }
      EXPECT_LE(moved, 1e-6) << pattern << " hop " << hop;
      EXPECT_NEAR(energy_out / energy_in, 1.0, hop == 64 ? 2e-2 : 3e-2) << pattern << " hop " << hop;
    }
  }
}

TEST(PhaseRule, AntiphaseEnergyOfABlockIsExact) {
  for (int pattern = 0; pattern <= 5; ++pattern) {
    const auto axes = antiphase(pattern, 64);
    Dft321Frame frame(64);
    const double energy = energyOf(axes[0]) + energyOf(axes[1]) + energyOf(axes[2]);
    EXPECT_NEAR(energyOf(frame.transform(axes[0], axes[1], axes[2])) / energy, 1.0, 1e-12) << pattern;
  }
}

TEST(ThesisDft321, DropsOneSampleInEveryBlockAndIsSilentWhileItComputes) {
  constexpr int kFrame = 8;
  ThesisDft321 printed(kFrame);
  std::vector<double> out;
  out.reserve(36);
  for (int n = 0; n < 36; ++n) out.push_back(printed.step({static_cast<double>(n + 1), 0.0, 0.0}));
  for (int n = 0; n < 9; ++n) EXPECT_EQ(out[static_cast<std::size_t>(n)], 0.0);
  for (int n = 9; n < 36; ++n) {
    // One axis only: the block comes back as it was, N + 1 samples later; the ninth of each is silence.
    const double expected = n % 9 == 8 ? 0.0 : static_cast<double>(n - 9 + 1);
    EXPECT_NEAR(out[static_cast<std::size_t>(n)], expected, 1e-12) << n;
  }
}

TEST(Dft321, LeavesNoGapWhileABlockIsComputed) {
  Dft321 blocks(8, 8, 1000.0);
  for (int n = 0; n < 64; ++n) {
    const double out = blocks.step({static_cast<double>(n + 1), 0.0, 0.0});
    EXPECT_NEAR(out, n < 7 ? 0.0 : static_cast<double>(n - 7 + 1), 1e-12) << n;
  }
}

/// The thesis' loops: sines and cosines inside, each axis on its own, then the inverse.
void printedDft321(const std::array<std::vector<double>, 3>& axes, std::vector<double>& out) {
  const std::size_t n = axes[0].size();
  std::vector<double> real(n), imag(n);
  for (std::size_t k = 0; k < n; ++k) {
    double sum_real = 0, sum_imag = 0, square = 0;
    for (const auto& axis : axes) {
      double re = 0, im = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(k * i) / static_cast<double>(n);
        re += axis[i] * std::cos(angle);
        im -= axis[i] * std::sin(angle);
      }
      sum_real += re;
      sum_imag += im;
      square += re * re + im * im;
    }
    const double phase = std::atan2(sum_imag, sum_real);
    real[k] = std::sqrt(square) * std::cos(phase);
    imag[k] = std::sqrt(square) * std::sin(phase);
  }
  for (std::size_t i = 0; i < n; ++i) {
    double value = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const double angle = 2.0 * std::numbers::pi * static_cast<double>(k * i) / static_cast<double>(n);
      value += real[k] * std::cos(angle) - imag[k] * std::sin(angle);
    }
    out[i] = value / static_cast<double>(n);
  }
}

TEST(Dft321, IsTwentyTimesFasterThanThePrintedLoopsAt64Samples) {
  const std::array<std::vector<double>, 3> axes = {noise(64, 1), noise(64, 2), noise(64, 3)};
  std::vector<double> printed(64);
  Dft321Frame frame(64);
  std::span<const double> ours;
  const auto fastest = [](int runs, auto&& call) {
    double best = 1e300;
    for (int i = 0; i < runs; ++i) {
      const double start_s = processorTime_s();
      call();
      best = std::min(best, processorTime_s() - start_s);
    }
    return best;
  };
  const double slow_s = fastest(20, [&] { printedDft321(axes, printed); });
  const double fast_s = fastest(200, [&] { ours = frame.transform(axes[0], axes[1], axes[2]); });
  EXPECT_GE(slow_s / fast_s, 20.0);
  for (std::size_t i = 0; i < 64; ++i) EXPECT_NEAR(printed[i], ours[i], 1e-10);
}

}  // namespace
}  // namespace fyd::texture
