// Calibrates the simulated cloth as an operator does: presses over each sensor, `fyd calibrate cloth`, accept.
#pragma once

#include "core/pipeline/parameters.h"
#include "core/sim/sim_parameters.h"

namespace fyd::bench {

/// The default parameters with the calibrated values of this cloth.
/// @throws std::runtime_error when the fit was refused: its figures would be those of a cloth that is not calibrated
[[nodiscard]] pipeline::Parameters calibratedOn(const sim::SimParameters& cloth);

}  // namespace fyd::bench
