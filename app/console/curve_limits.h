// The limits that stand in the curves: what the parameters in force let the touchpad render, and its sensors measure.
//
//   vibration    largest duty that the texture may use
//   stiffness    softest and stiffest that the law gives within the travel
//   stretch      travel of the controller
//   translation  no motor goes further from its zero
//   force        span of the load cell; a reading beyond it is invalid
#pragma once

#include "core/pipeline/parameters.h"
#include "widgets/curve_stack.h"

namespace fyd::console {

/// Draws them in the strips that have any, in the strips' units.
void drawLimits(const widgets::CurveStack& stack, const pipeline::Parameters& parameters);

}  // namespace fyd::console
