// Settings of the mapping felt (felt_mapping.h).
#pragma once

#include "core/texture/felt/felt_plant.h"

namespace fyd::texture {

struct FeltSettings {
  FeltPlant plant;
  double gain = 1.0;                ///< k_vib, at the finger
  double maximum_percent = 100.0;   ///< largest duty
  double rms_limit_percent = 38.7;  ///< heat: largest RMS duty, over a second
  double gate_g = 0.0075;           ///< a steady signal of less RMS is noise
  double surface_level_g = 0.0;     ///< stored RMS of this surface; 0: learned
};

}  // namespace fyd::texture
