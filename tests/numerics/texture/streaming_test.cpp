// The streaming targets: match, energy, delay, overlap.
#include <gtest/gtest.h>

#include "core/texture/dft321.h"
#include "core/texture/method_bank.h"
#include "core/texture/mixing_methods.h"
#include "core/texture/spectral_match.h"
#include "tests/numerics/texture/scenes.h"

namespace fyd::texture {
namespace {

std::vector<double> stream(Method& method, const ThreeAxes& in) {
  std::vector<double> out(in.x.size());
  for (std::size_t n = 0; n < out.size(); ++n) out[n] = method.step({in.x[n], in.y[n], in.z[n]});
  return out;
}

TEST(Streaming, OverlappedFramesOf32MatchTheSpectrumAndKeepTheEnergy) {
  for (const Scene& scene : kScenes) {
    for (const std::uint64_t seed : {1U, 2U}) {
      for (const int hop : {16, 8}) {
        const ThreeAxes in = sceneSignal(scene, seed);
        Dft321 method(32, hop, kRate_Hz);
        const auto out = stream(method, in);
        const auto figures = compareSpectra(in.x, in.y, in.z, out, method.delaySamples(), kRate_Hz);
        EXPECT_GE(figures.spectral_match, 0.92) << scene.name << " seed " << seed << " hop " << hop;
        EXPECT_NEAR(figures.energy_ratio, 1.0, 0.03) << scene.name << " seed " << seed << " hop " << hop;
      }
    }
  }
}

TEST(Streaming, RecolourMatchesWithoutDelay) {
  for (const Scene& scene : kScenes) {
    const ThreeAxes in = sceneSignal(scene, 3);
    Recolour method(kRate_Hz);
    ASSERT_EQ(method.delaySamples(), 0);
    const auto out = stream(method, in);
    const auto figures = compareSpectra(in.x, in.y, in.z, out, 0, kRate_Hz);
    EXPECT_GE(figures.spectral_match, 0.92) << scene.name;
    EXPECT_NEAR(figures.energy_ratio, 1.0, 0.03) << scene.name;
  }
}

TEST(Streaming, SumOfComponentsCancelsWhereTheOthersDoNot) {  // so that the two tests above can fail
  const ThreeAxes in = sceneSignal(kScenes[4], 1);
  SumOfComponents soc;
  EXPECT_LT(compareSpectra(in.x, in.y, in.z, stream(soc, in), 0, kRate_Hz).spectral_match, 0.7);
}

TEST(Streaming, ThePrincipalAxisFollowsAVibrationThatLeavesOneAxisForAnother) {
  for (const int from : {0, 1, 2}) {
    for (const int to : {0, 1, 2}) {
      for (const int pause : {0, 3000, 60'000}) {
        PrincipalAxis method(kRate_Hz);
        const auto on = [](int axis, double v) {
          return Vec3{axis == 0 ? v : 0.0, axis == 1 ? v : 0.0, axis == 2 ? v : 0.0};
        };
        for (int n = 0; n < 3000; ++n) (void)method.step(on(from, std::sin(0.7 * n)));
        for (int n = 0; n < pause; ++n) (void)method.step({});
        double power = 0.0;
        for (int n = 0; n < 4000; ++n) {
          const double out = method.step(on(to, std::sin(0.7 * n)));
          if (n >= 2000) power += out * out;
        }
        EXPECT_NEAR(power / 2000.0, 0.5, 0.005) << from << " to " << to << ", pause of " << pause;
      }
    }
  }
}

TEST(Streaming, AnImpulseLeavesEachMethodExactlyAfterItsStatedDelay) {
  for (const int axis : {0, 1, 2}) {
    for (std::size_t m = 0; m < kMethodNames.size(); ++m) {
      const auto choice = static_cast<MethodChoice>(m);
      if (choice == MethodChoice::single && axis != 2) continue;
      for (const auto& [frame, hop] : {std::pair{32, 32}, {32, 16}, {32, 8}, {8, 4}, {64, 32}}) {
        auto method = makeMethod(choice, kRate_Hz, frame, hop);
        ASSERT_TRUE(method);
        const int at = 100 + axis;  // within a block wherever that stands
        int loudest = -1;
        double peak = 0.0;
        for (int n = 0; n < 400; ++n) {
          const double one = n == at ? 1.0 : 0.0;
          const double out = (*method)->step({axis == 0 ? one : 0, axis == 1 ? one : 0, axis == 2 ? one : 0});
          if (std::abs(out) > peak) {
            peak = std::abs(out);
            loudest = n;
          }
        }
        EXPECT_EQ(loudest - at, (*method)->delaySamples()) << kMethodNames[m] << " " << frame << "/" << hop;
        EXPECT_GT(peak, 0.3);
      }
    }
  }
}

TEST(Streaming, OverlappingWindowsAddUpToOne) {
  // One axis needs no decision about phases: it must come back as it went in, late, at once and for ever.
  const auto source = bandNoise(5000, 20, 480, kRate_Hz, 4);
  for (const auto& [frame, hop] : {std::pair{32, 16}, {32, 8}, {32, 4}, {8, 4}, {9, 3}, {512, 256}}) {
    Dft321 method(frame, hop, kRate_Hz);
    for (std::size_t n = 0; n < source.size(); ++n) {
      const double out = method.step({0.0, source[n], 0.0});
      const auto late = static_cast<std::size_t>(method.delaySamples());
      const bool whole = n >= 2 * static_cast<std::size_t>(frame);  // the first frame's windows miss their partners
      if (!whole) continue;
      ASSERT_NEAR(out, source[n - late], 1e-9) << frame << "/" << hop << " at " << n;
    }
  }
}

}  // namespace
}  // namespace fyd::texture
