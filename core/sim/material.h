// Materials under the simulated robot's tool: stiffness, damping, and the vibration of a tool drawn over the surface.
//
// Surface: the acceleration at the tool is a sum of waves fixed to the surface, met at the frequency v/λ when the
// tool travels at v, and of a broadband part; each axis has its own share and phase. Amplitudes grow with
// v/(v + 30 mm/s) and √(F/1 N), so that nothing moves at rest or without contact.
// The values are plausible assumptions, not taken from recordings.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "core/base/vec3.h"

namespace fyd::sim {

enum class Material : std::uint8_t { none, sponge, foam, rubber, leather, wood };

inline constexpr std::array<std::string_view, 6> kMaterialNames = {"none",   "sponge",  "foam",
                                                                   "rubber", "leather", "wood"};

struct SurfaceWave {
  double length_mm = 1.0;  ///< λ
  Vec3 amplitude_g;        ///< at full speed factor and 1 N
  Vec3 phase_rad;
};

struct MaterialProperties {
  double stiffness_N_per_mm = 0.0;  ///< 0: there is nothing to touch
  double damping_Ns_per_mm = 0.0;
  std::span<const SurfaceWave> waves;
  double broadband_g = 0.0;  ///< RMS of each axis' broadband part, likewise
};

/// The cloth's range is 0.50–0.715 N/mm: sponge is softer and wood stiffer than the touchpad can render.
[[nodiscard]] const MaterialProperties& propertiesOf(Material material);

}  // namespace fyd::sim
