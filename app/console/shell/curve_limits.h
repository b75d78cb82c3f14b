// The limit lines of the curves: what the touchpad can render and its sensors can measure with the parameters in force.
//
//   vibration    largest duty that the texture may use
//   stiffness    softest and stiffest that the law gives within the travel
//   stretch      travel of the controller
//   translation  largest angle of a motor from its zero
//   force        span of the load cell; a reading beyond it is invalid
#pragma once

#include "core/pipeline/parameters.h"
#include "widgets/curves/curve_stack.h"

namespace fyd::console {

/// Sets the limits in the strips that have any, in the strips' units.
void drawLimits(const widgets::CurveStack& stack, const pipeline::Parameters& parameters);

}  // namespace fyd::console
