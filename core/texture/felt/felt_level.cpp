#include "core/texture/felt/felt_level.h"

#include <algorithm>
#include <numbers>

#include "core/base/portable_math.h"
#include "core/texture/felt/felt_plant.h"

namespace fyd::texture {

double feltLevel_dB(double felt_g) {
  constexpr double kLeastRatio = 1e-6;  // of the threshold: −120 dB
  return 20.0 / std::numbers::ln10 * math::log(std::max(felt_g / kFeltThreshold_g, kLeastRatio));
}

}  // namespace fyd::texture
