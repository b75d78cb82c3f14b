#include "core/sim/touchpad/ir_sensor.h"

#include <algorithm>
#include <cmath>

#include "core/sensing/ir_distance.h"

namespace fyd::sim {

double irVolts(double distance_mm) {
  static const sensing::IrDistance curve({}, 0, sensing::kAdcCodes - 1);
  return std::isnan(distance_mm) ? 0.0 : curve.voltsAt(distance_mm);
}

std::uint16_t irCode(double volts) {
  if (std::isnan(volts)) return 0;
  const double code = volts * sensing::kAdcCodes / sensing::kAdcReference_V;
  return static_cast<std::uint16_t>(std::lround(std::clamp(code, 0.0, sensing::kAdcCodes - 1.0)));
}

}  // namespace fyd::sim
