#include "core/control/control_parameters.h"

namespace fyd::control {
namespace {

Result<void> checkRising(std::string_view id, const ParameterList& list) {
  for (std::size_t i = 1; i < list.size(); ++i) {
    if (!(list[i] > list[i - 1])) {
      return fail("{}: {} follows {}; expected rising values", id, list[i], list[i - 1]);
    }
  }
  return {};
}

}  // namespace

Result<void> checkControlParameters(const ControlParameters& p) {
  const ParameterList& angle = p.law_angle_deg;
  const ParameterList& stiffness = p.law_stiffness_N_per_mm;
  if (angle.size() < 2) return fail("control.law_angle_deg: {} points; expected at least 2", angle.size());
  if (angle.size() != stiffness.size()) {
    return fail("control.law_stiffness_N_per_mm: {} values for {} angles; expected one for each", stiffness.size(),
                angle.size());
  }
  if (auto rising = checkRising("control.law_angle_deg", angle); !rising) return rising;
  if (auto rising = checkRising("control.law_stiffness_N_per_mm", stiffness); !rising) return rising;
  if (!(stiffness[0] > 0)) return fail("control.law_stiffness_N_per_mm: {}; expected above 0", stiffness[0]);
  if (!(p.travel_maximum_deg > p.travel_minimum_deg)) {
    return fail("control.travel_maximum_deg = {}: expected more than control.travel_minimum_deg = {}",
                p.travel_maximum_deg, p.travel_minimum_deg);
  }
  return {};
}

}  // namespace fyd::control
