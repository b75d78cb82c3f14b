// The hard cases through methods and the whole renderer.
#include <chrono>
#include <cstdlib>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "app/bench/parts/allocation_count.h"
#include "core/signal/biquad.h"
#include "core/texture/method_bank.h"
#include "core/texture/texture_renderer.h"
#include "tests/not_a_number.h"
#include "tests/numerics/texture/scenes.h"
#include "tests/processor_time.h"

namespace fyd::texture {
namespace {

TEST(HardCases, ConstantsAndZerosGiveSilence) {
  for (std::size_t m = 0; m < kMethodNames.size(); ++m) {
    TextureParameters p;
    p.method = static_cast<MethodChoice>(m);
    p.dead_zone_percent = 0.0;
    for (const Vec3& constant : {Vec3{0, 0, 0}, Vec3{0.1, -0.2, 1.0}}) {
      TextureRenderer renderer(p);
      for (int n = 0; n < 500; ++n) {
        const AccelerationSample sample = {instantAt(n * 1e-3), constant};
        const auto out = renderer.step(instantAt(n * 1e-3), {&sample, 1}, 0.0);
        ASSERT_EQ(out.duty_percent[0], 0.0) << kMethodNames[m];
        ASSERT_EQ(out.signal_g, 0.0) << kMethodNames[m];
      }
    }
  }
}

/// Through the renderer at 1 kHz, one sample a step; an empty optional hands over nothing.
template <class Source>
std::vector<TextureOutput> renderThrough(TextureRenderer& renderer, int steps, Source&& source, double share = 0.0) {
  std::vector<TextureOutput> out;
  for (int n = 0; n < steps; ++n) {
    const AccelerationSample sample = {instantAt(n * 1e-3), source(n)};
    out.push_back(renderer.step(instantAt(n * 1e-3), {&sample, 1}, share));
  }
  return out;
}

TEST(HardCases, ATinyVibrationOnGravityIsNotLost) {
  TextureParameters p;
  p.full_scale_g = 1e-4;
  p.dead_zone_percent = 0.0;
  TextureRenderer renderer(p);
  const auto out = renderThrough(renderer, 2000, [](int n) { return Vec3{0.0, 0.0, 1.0 + 1e-5 * std::sin(0.9 * n)}; });
  double peak = 0.0;
  for (std::size_t n = 1000; n < out.size(); ++n) peak = std::max(peak, out[n].signal_g);
  EXPECT_NEAR(peak, 1e-5, 1e-6);
}

TEST(HardCases, SpikesSquareWavesAndClippedSensorsStayWithinLimits) {
  const auto spike = [](int n) { return n == 300 ? Vec3{900.0, -900.0, 900.0} : Vec3{}; };
  const auto square = [](int n) { return (n / 7) % 2 == 0 ? Vec3{5, 5, 5} : Vec3{-5, -5, -5}; };
  const auto clipped = [](int n) { return Vec3{std::clamp(40.0 * std::sin(0.7 * n), -5.0, 5.0), 5.0, -5.0}; };
  for (std::size_t m = 0; m < kMethodNames.size(); ++m) {
    for (const PwmChoice pwm : {PwmChoice::symmetric, PwmChoice::thesis, PwmChoice::felt}) {
      TextureParameters p;
      p.method = static_cast<MethodChoice>(m);
      p.pwm = pwm;
      p.k_vib = 3.0;
      p.maximum_percent = 80.0;
      const auto check = [&](auto&& source) {
        TextureRenderer renderer(p);
        for (const auto& out : renderThrough(renderer, 1000, source, 35.0)) {
          ASSERT_TRUE(std::isfinite(out.signal_g));
          ASSERT_LE(std::abs(out.duty_percent[0]), 80.0);
          ASSERT_LE(out.duty_percent[0] + 35.0, 100.0);
        }
      };
      check(spike);
      check(square);
      check(clipped);
    }
  }
}

TEST(HardCases, NoInputMakesANumberThatIsNone) {
  const std::vector<double> wild = {kNaN, INFINITY, -INFINITY, 1e308, -1e308, 1e-310, 0.0, 5.0, 1000.0, -1000.0};
  std::mt19937_64 random(4);
  TextureRenderer renderer{TextureParameters{}};
  std::int64_t t_ns = 0;
  for (int n = 0; n < 20000; ++n) {
    t_ns += static_cast<std::int64_t>(random() % 3) * 1'000'000 - (random() % 50 == 0 ? 20'000'000 : 0);
    std::array<AccelerationSample, 64> bunch;
    const std::size_t count = random() % 65;
    for (std::size_t i = 0; i < count; ++i) {
      const auto pick = [&] { return wild[random() % wild.size()]; };
      bunch[i] = {Instant(Duration(t_ns - static_cast<std::int64_t>(random() % 5'000'000))), {pick(), pick(), pick()}};
    }
    const auto out = renderer.step(Instant(Duration(t_ns)), {bunch.data(), count}, wild[random() % wild.size()]);
    ASSERT_TRUE(std::isfinite(out.signal_g));
    ASSERT_LE(std::abs(out.duty_percent[0]), 100.0);
  }
}

/// Relative RMS error of the half second that begins one delay and one frame after a NaN.
double errorAfterNaN(const TextureParameters& p, std::uint64_t expected_gaps) {
  const ThreeAxes in = sceneSignal(kScenes[1], 5, 4000);
  const auto at = [&](int n) {
    const auto i = static_cast<std::size_t>(n);
    return Vec3{in.x[i], in.y[i], in.z[i]};
  };
  TextureRenderer clean(p);
  TextureRenderer hurt(p);
  const auto a = renderThrough(clean, 3000, at);
  const auto b = renderThrough(hurt, 3000, [&](int n) { return n == 2000 ? Vec3{kNaN, 0.0, 0.0} : at(n); });
  EXPECT_EQ(b.back().gaps, expected_gaps);
  double error = 0.0;
  double size = 0.0;
  for (std::size_t n = 2000 + 1 + 31 + 32; n < 2500; ++n) {
    EXPECT_TRUE(std::isfinite(b[n].signal_g));
    error += (a[n].signal_g - b[n].signal_g) * (a[n].signal_g - b[n].signal_g);
    size += a[n].signal_g * a[n].signal_g;
  }
  return std::sqrt(error / size);
}

TEST(HardCases, OneNaNIsContainedWithinOneFrame) {
  for (const bool bridged : {false, true}) {  // as a gap, and by a line between its neighbours
    TextureParameters p;
    p.maximum_gap_ms = bridged ? 2.5 : 1.5;
    const std::uint64_t gaps = bridged ? 0 : 1;
    p.hop = HopChoice::frame;
    EXPECT_LT(errorAfterNaN(p, gaps), 1e-3);
    p.method = MethodChoice::soc;
    EXPECT_LT(errorAfterNaN(p, gaps), 1e-3);
    // The equaliser's average of 0.3 s remembers the click: its gains differ a little for that long.
    p.method = MethodChoice::dft321;
    p.hop = HopChoice::half;
    EXPECT_LT(errorAfterNaN(p, gaps), 0.2);
    p.method = MethodChoice::recolour;
    EXPECT_LT(errorAfterNaN(p, gaps), 0.2);
  }
}

TEST(HardCases, AGapIsSilentAndCountedAndTheTextureComesBack) {
  const ThreeAxes in = sceneSignal(kScenes[0], 6, 3000);
  TextureParameters p;
  p.method = MethodChoice::soc;
  TextureRenderer renderer(p);
  std::vector<TextureOutput> out;
  for (int n = 0; n < 3000; ++n) {
    const auto i = static_cast<std::size_t>(n);
    const AccelerationSample sample = {instantAt(n * 1e-3), {in.x[i], in.y[i], in.z[i]}};
    const bool missing = n >= 1000 && n < 1500;
    out.push_back(renderer.step(instantAt(n * 1e-3), {&sample, missing ? 0U : 1U}, kNaN));
  }
  for (std::size_t n = 1005; n < 1500; ++n) {
    ASSERT_EQ(out[n].signal_g, 0.0);
    ASSERT_TRUE(out[n].gap);
  }
  EXPECT_EQ(out.back().gaps, 1U);
  EXPECT_FALSE(out.back().position_share_known);
  EXPECT_NE(out[1600].signal_g, 0.0);
}

TEST(HardCases, ThesisPwmIsOffAtOnceWhenAllAccelerationsAreExactlyZero) {
  TextureParameters p;
  p.pwm = PwmChoice::thesis;
  p.full_scale_g = 0.1;
  TextureRenderer renderer(p);
  const auto out = renderThrough(renderer, 400, [](int n) { return n < 200 ? Vec3{0, 0, std::sin(1.1 * n)} : Vec3{}; });
  EXPECT_NE(out[203].signal_g, 0.0);  // the frame's delay: the signal goes on
  for (std::size_t n = 203; n < 230; ++n) EXPECT_EQ(out[n].duty_percent[0], 0.0);
}

TEST(Switching, NeverExceedsTheLargerOfTheTwoSignals) {
  const ThreeAxes in = sceneSignal(kScenes[0], 7, 6000);
  const auto at = [&](int n) {
    const auto i = static_cast<std::size_t>(n);
    return Vec3{in.x[i], in.y[i], in.z[i]};
  };
  TextureParameters soc;
  soc.method = MethodChoice::soc;
  TextureParameters single = soc;
  single.method = MethodChoice::single;
  TextureRenderer only_soc(soc);
  TextureRenderer only_single(single);
  TextureRenderer switching(soc);
  const auto a = renderThrough(only_soc, 6000, at);
  const auto b = renderThrough(only_single, 6000, at);
  for (int n = 0; n < 6000; ++n) {
    if (n % 137 == 0) switching.configure(n % 274 == 0 ? single : soc);
    const AccelerationSample sample = {instantAt(n * 1e-3), at(n)};
    const double s = switching.step(instantAt(n * 1e-3), {&sample, 1}, 0.0).signal_g;
    const auto i = static_cast<std::size_t>(n);
    ASSERT_LE(std::abs(s), std::max(std::abs(a[i].signal_g), std::abs(b[i].signal_g)) + 1e-3) << n;
  }
}

TEST(Switching, AChangeOfGainGlides) {
  TextureParameters p;
  p.pwm = PwmChoice::symmetric;
  p.method = MethodChoice::single;
  p.filter = FilterChoice::none;
  p.dead_zone_percent = 0.0;
  TextureRenderer renderer(p);
  double last = 0.0;
  for (int n = 0; n < 300; ++n) {
    if (n == 100) {
      p.k_vib = 2.0;
      renderer.configure(p);
    }
    const AccelerationSample sample = {instantAt(n * 1e-3), {0.0, 0.0, 0.8}};
    const double duty = renderer.step(instantAt(n * 1e-3), {&sample, 1}, 0.0).duty_percent[0];
    const double jump = n > 5 ? std::abs(duty - last) : 0.0;
    ASSERT_LE(jump, 3.0) << n;  // 40 % over 20 ms
    last = duty;
  }
  EXPECT_EQ(last, 80.0);
}

TEST(Switching, NeitherStepsNorChangesAllocate) {
  TextureRenderer renderer{TextureParameters{}};
  const bench::AllocationCount counted;
  for (int n = 0; n < 8000; ++n) {
    if (n % 100 == 0) {
      TextureParameters p;
      p.method = static_cast<MethodChoice>(static_cast<std::size_t>(n / 100) % kMethodNames.size());
      p.frame = static_cast<FrameChoice>(n / 100 % 7);
      p.hop = static_cast<HopChoice>(n / 100 % 3);
      p.corner_Hz = 20.0 + n % 200;
      renderer.configure(p);
    }
    const AccelerationSample sample = {instantAt(n * 1e-3), {std::sin(n * 0.3), std::cos(n * 0.8), 1.0}};
    (void)renderer.step(instantAt(n * 1e-3), {&sample, 1}, kNaN);
    (void)renderer.stepVirtual(0.1, kNaN);
  }
  EXPECT_EQ(counted.count(), 0U);
}

TEST(HardCases, AFilteredDenormalInputCostsNoMoreThanANormalOne) {
  const auto cost = [](Method& method, double scale) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(-scale, scale);
    std::vector<Vec3> in(20000);
    for (Vec3& v : in) v = {uniform(random), uniform(random), uniform(random)};
    // A method never meets the raw signal: the filter before it flushes what is next to nothing, as this one does.
    std::array<signal::Biquad<>, 3> filter;
    double best = 1e300;
    double sink = 0.0;
    for (int run = 0; run < 5; ++run) {
      const double start_s = processorTime_s();
      for (const Vec3& v : in) sink += method.step({filter[0].step(v.x), filter[1].step(v.y), filter[2].step(v.z)});
      best = std::min(best, processorTime_s() - start_s);
    }
    EXPECT_TRUE(std::isfinite(sink));
    return best;
  };
  for (const MethodChoice choice : {MethodChoice::dft321, MethodChoice::recolour, MethodChoice::principal}) {
    auto normal = makeMethod(choice, kRate_Hz, 32, 16);
    auto tiny = makeMethod(choice, kRate_Hz, 32, 16);
    auto fading = makeMethod(choice, kRate_Hz, 32, 16);
    const double normal_s = cost(**normal, 1.0);
    (void)cost(**fading, 1.0);
    EXPECT_LT(cost(**tiny, 1e-308) / normal_s, 4.0) << kMethodNames[static_cast<std::size_t>(choice)];
    EXPECT_LT(cost(**fading, 1e-308) / normal_s, 4.0) << kMethodNames[static_cast<std::size_t>(choice)];
  }
}

TEST(HardCases, DoesNotDriftOverManySamples) {
  // 10⁶ samples here; FYD_LONG_TESTS=1 makes it 10⁸ (some 40 s). The input repeats every 4000 samples, a multiple of
  // every frame.
  const std::int64_t samples = std::getenv("FYD_LONG_TESTS") != nullptr ? 100'000'000 : 1'000'000;
  constexpr std::int64_t kPeriod = 4000;
  const ThreeAxes in = sceneSignal(kScenes[1], 8, kPeriod);
  TextureRenderer renderer{TextureParameters{}};
  std::vector<double> early;
  double worst = 0.0;
  double mean = 0.0;
  TextureOutput out;
  for (std::int64_t n = 0; n < samples; ++n) {
    const auto i = static_cast<std::size_t>(n % kPeriod);
    const Instant now = Instant(std::chrono::milliseconds(n));
    const AccelerationSample sample = {now, {in.x[i], in.y[i], in.z[i] + 1.0}};
    out = renderer.step(now, {&sample, 1}, 0.0);
    if (n / kPeriod == 20) early.push_back(out.signal_g);
    if (n >= samples - kPeriod) {
      worst = std::max(worst, std::abs(out.signal_g - early[i]));
      mean += out.signal_g / kPeriod;
    }
  }
  EXPECT_LT(worst, 1e-9);
  EXPECT_LT(std::abs(mean), 1e-3);
  EXPECT_EQ(out.gaps, 0U);
  EXPECT_EQ(out.refused_samples, 0U);
}

}  // namespace
}  // namespace fyd::texture
