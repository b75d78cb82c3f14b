#include "app/console/shell/curve_limits.h"

#include <algorithm>

#include "core/control/static_law.h"
#include "core/sensing/load_cell.h"

namespace fyd::console {
namespace {

std::vector<double> limitsOf(const QString& strip, const pipeline::Parameters& parameters) {
  const control::ControlParameters& control = parameters.control;
  const double motor_deg = control.motor_limit_deg;
  if (strip == QLatin1String("vibration")) {
    const double most_percent = parameters.texture.maximum_percent;
    return {-most_percent, most_percent};
  }
  if (strip == QLatin1String("stiffness")) {
    control::StaticLaw law(control);
    law.limitTravel(control.travel_minimum_deg, control.travel_maximum_deg);
    return {law.minimumStiffness_N_per_mm(), law.maximumStiffness_N_per_mm()};
  }
  if (strip == QLatin1String("stretch")) {
    return {std::max(control.travel_minimum_deg, -motor_deg), std::min(control.travel_maximum_deg, motor_deg)};
  }
  if (strip == QLatin1String("translation")) return {-motor_deg, motor_deg};
  if (strip == QLatin1String("force")) {
    const sensing::LoadCell cell(parameters.sensing.load_cell);
    return {cell.force_N(-cell.span_mV_per_V()), cell.force_N(cell.span_mV_per_V())};
  }
  return {};
}

}  // namespace

void drawLimits(const widgets::CurveStack& stack, const pipeline::Parameters& parameters) {
  for (std::size_t i = 0; i < stack.size(); ++i) stack.strip(i)->setLimits(limitsOf(stack.setup(i).id, parameters));
}

}  // namespace fyd::console
