// Settings of the mapping `felt`, which compensates motors and cloth.
// Stability: may change
#pragma once

#include "core/texture/felt/felt_plant.h"

namespace fyd::texture {

struct FeltSettings {
  FeltPlant plant;
  double gain = 1.0;                ///< k_vib: factor on the duties, 1: the whole range
  double maximum_percent = 100.0;   ///< largest duty
  double rms_limit_percent = 38.7;  ///< heat limit: largest RMS of a duty over 1 s
  double gate_g = 0.0075;           ///< threshold of the noise gate: RMS of a steady signal; 0: no gate
  double surface_level_g = 0.0;     ///< stored RMS signal of this surface; 0: estimated while touching
};

}  // namespace fyd::texture
