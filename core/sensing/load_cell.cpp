#include "core/sensing/load_cell.h"

#include <cmath>
#include <limits>

#include "core/base/units.h"

namespace fyd::sensing {

double LoadCell::force_N(double value_mV_per_V) const {
  if (!(std::abs(value_mV_per_V) <= span_mV_per_V())) return std::numeric_limits<double>::quiet_NaN();
  const double grams = parameters_.slope_g_per_mV_per_V * value_mV_per_V + parameters_.offset_g;
  return grams / 1000.0 * kStandardGravity - parameters_.zero_N;
}

void LoadCell::tare(double untouched_force_N) {
  if (std::isfinite(untouched_force_N)) parameters_.zero_N += untouched_force_N;
}

}  // namespace fyd::sensing
