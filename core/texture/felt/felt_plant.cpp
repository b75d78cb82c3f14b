#include "core/texture/felt/felt_plant.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/units.h"

namespace fyd::texture {

double FeltPlant::resonanceAt_Hz(double at_deg) const {
  const double offset_deg = std::isfinite(at_deg) ? at_deg - stretch_deg : 0.0;
  return std::clamp(resonance_Hz + resonance_Hz_per_deg * offset_deg, 10.0, 400.0);
}

double FeltPlant::rollerAccelerationPerG_deg_s2() const {
  return kStandardGravity * 1e3 / roller_radius_mm * 180.0 / std::numbers::pi;
}

}  // namespace fyd::texture
