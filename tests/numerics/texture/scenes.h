// The scenes of the texture tests: one band-limited noise that reaches three axes over different paths.
#pragma once

#include <array>

#include "core/texture/test_signals.h"

namespace fyd::texture {

inline constexpr double kRate_Hz = 1000.0;

struct Scene {
  const char* name = nullptr;
  double low_Hz = 0.0;
  double high_Hz = 0.0;
  std::array<Path, 3> paths;
};
inline const std::array<Scene, 5> kScenes = {{{"wide", 30, 400, {{{0, 1}, {2.5, 0.8}, {6, 0.6}}}},
                                              {"middle", 30, 300, {{{0, 1}, {3, 0.7}, {7, 0.5}}}},
                                              {"near", 50, 350, {{{0, 1}, {1.3, 0.9}, {2.7, 1.1}}}},
                                              {"equal gains", 20, 450, {{{0, 1}, {5, 1}, {11, 1}}}},
                                              {"opposed", 80, 250, {{{0, 1}, {1, -0.8}, {3, 0.6}}}}}};

inline ThreeAxes sceneSignal(const Scene& scene, std::uint64_t seed, std::size_t samples = 30000) {
  return spread(bandNoise(samples, scene.low_Hz, scene.high_Hz, kRate_Hz, seed), scene.paths);
}

}  // namespace fyd::texture
