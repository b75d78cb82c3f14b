#include "core/teleop/coupling/coupling.h"

#include <cmath>

namespace fyd::teleop {

double overspeedForce(double velocity_m_per_s, double limit_m_per_s) {
  if (!std::isfinite(velocity_m_per_s) || !std::isfinite(limit_m_per_s) || !(limit_m_per_s > 0.0)) return 0.0;
  const double excess = std::abs(velocity_m_per_s) / limit_m_per_s - 1.0;
  return excess > 0.0 ? std::copysign(100.0 * excess * excess, -velocity_m_per_s) : 0.0;
}

}  // namespace fyd::teleop
