#include "core/teleop/coupling/coupling_choice.h"

#include <algorithm>

#include "core/teleop/coupling/model_coupling.h"
#include "core/teleop/coupling/spring_coupling.h"

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

}  // namespace fyd::teleop
