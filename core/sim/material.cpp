#include "core/sim/material.h"

#include <cstddef>

namespace fyd::sim {
namespace {

constexpr std::array<SurfaceWave, 3> kSponge = {{
    {6.1, {0.10, 0.06, 0.16}, {0.3, 1.9, 4.0}},
    {2.7, {0.07, 0.05, 0.10}, {2.2, 5.1, 0.8}},
    {1.3, {0.04, 0.04, 0.05}, {4.4, 0.6, 3.0}},
}};
constexpr std::array<SurfaceWave, 3> kFoam = {{
    {3.9, {0.08, 0.05, 0.14}, {1.1, 3.3, 0.2}},
    {1.7, {0.09, 0.07, 0.12}, {5.0, 2.0, 1.4}},
    {0.9, {0.05, 0.06, 0.06}, {0.7, 4.4, 2.9}},
}};
constexpr std::array<SurfaceWave, 3> kRubber = {{
    {1.1, {0.16, 0.10, 0.12}, {0.0, 2.6, 5.2}},
    {0.55, {0.22, 0.12, 0.18}, {3.7, 0.9, 1.8}},
    {0.28, {0.10, 0.09, 0.08}, {1.5, 5.8, 4.1}},
}};
constexpr std::array<SurfaceWave, 4> kLeather = {{
    {2.3, {0.14, 0.10, 0.24}, {2.8, 0.4, 1.0}},
    {0.95, {0.20, 0.16, 0.30}, {0.9, 3.8, 5.5}},
    {0.47, {0.16, 0.12, 0.18}, {4.8, 1.2, 2.4}},
    {0.24, {0.08, 0.08, 0.09}, {2.0, 5.3, 0.1}},
}};
constexpr std::array<SurfaceWave, 4> kWood = {{
    {5.2, {0.30, 0.12, 0.42}, {1.7, 4.9, 3.1}},
    {1.4, {0.42, 0.26, 0.58}, {5.6, 0.5, 2.2}},
    {0.62, {0.34, 0.30, 0.46}, {0.2, 2.9, 4.6}},
    {0.31, {0.20, 0.18, 0.26}, {3.4, 1.6, 0.9}},
}};

const std::array<MaterialProperties, kMaterialNames.size()> kMaterials = {{
    {},
    {.stiffness_N_per_mm = 0.32, .damping_Ns_per_mm = 0.006, .waves = kSponge, .broadband_g = 0.02},
    {.stiffness_N_per_mm = 0.50, .damping_Ns_per_mm = 0.005, .waves = kFoam, .broadband_g = 0.03},
    {.stiffness_N_per_mm = 0.62, .damping_Ns_per_mm = 0.004, .waves = kRubber, .broadband_g = 0.05},
    {.stiffness_N_per_mm = 0.71, .damping_Ns_per_mm = 0.003, .waves = kLeather, .broadband_g = 0.06},
    {.stiffness_N_per_mm = 20.0, .damping_Ns_per_mm = 0.010, .waves = kWood, .broadband_g = 0.12},
}};

}  // namespace

const MaterialProperties& propertiesOf(Material material) {
  const auto index = static_cast<std::size_t>(material);
  return kMaterials[index < kMaterials.size() ? index : 0];
}

}  // namespace fyd::sim
