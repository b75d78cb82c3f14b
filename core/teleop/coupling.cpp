#include "core/teleop/coupling.h"

#include <algorithm>
#include <cmath>

#include "core/teleop/model_coupling.h"
#include "core/teleop/spring_coupling.h"

namespace fyd::teleop {

Result<CouplingChoice> couplingNamed(std::string_view name) {
  const auto found = std::ranges::find(kCouplingNames, name);
  if (found != kCouplingNames.end()) return static_cast<CouplingChoice>(found - kCouplingNames.begin());
  return fail("coupling \"{}\": expected one of {}", name, fmt::join(kCouplingNames, ", "));
}

std::unique_ptr<CouplingEnd> makeHandEnd(CouplingChoice choice, const CouplingSettings& settings) {
  if (choice == CouplingChoice::model) return std::make_unique<ModelHandEnd>(settings);
  return std::make_unique<SpringEnd>(SpringEnd::Side::hand, choice == CouplingChoice::tdpa, settings);
}

std::unique_ptr<CouplingEnd> makeFarEnd(CouplingChoice choice, const CouplingSettings& settings) {
  if (choice == CouplingChoice::model) return std::make_unique<ModelFarEnd>(settings);
  return std::make_unique<SpringEnd>(SpringEnd::Side::far, choice == CouplingChoice::tdpa, settings);
}

double overspeedForce(double velocity_m_per_s, double limit_m_per_s) {
  if (!std::isfinite(velocity_m_per_s) || !std::isfinite(limit_m_per_s) || !(limit_m_per_s > 0.0)) return 0.0;
  const double excess = std::abs(velocity_m_per_s) / limit_m_per_s - 1.0;
  return excess > 0.0 ? std::copysign(100.0 * excess * excess, -velocity_m_per_s) : 0.0;
}

}  // namespace fyd::teleop
