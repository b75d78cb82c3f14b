#include "core/sim/ir_sensor.h"

#include <algorithm>
#include <cmath>

namespace fyd::sim {
namespace {

constexpr double kReference_V = 3.3;

double distanceAt(double v) {
  return 10.0 * (((((-4.6327 * v + 39.954) * v - 133.8297) * v + 220.8604) * v - 188.5623) * v + 79.0712);
}

}  // namespace

double irVolts(double distance_mm) {
  if (std::isnan(distance_mm)) return 0.0;
  double low = 0.0;
  double high = kReference_V;
  for (int i = 0; i < 40; ++i) {  // 3.3 V / 2⁴⁰ is far below a count
    const double middle = 0.5 * (low + high);
    (distanceAt(middle) > distance_mm ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

std::uint16_t irCode(double volts) {
  if (std::isnan(volts)) return 0;
  return static_cast<std::uint16_t>(std::lround(std::clamp(volts * 4096.0 / kReference_V, 0.0, 4095.0)));
}

}  // namespace fyd::sim
