// What an operator does before a session, on the simulated cloth: presses over each sensor, `calibrate cloth`, accept.
#pragma once

#include "core/pipeline/parameters.h"
#include "core/sim/sim_parameters.h"

namespace fyd::bench {

/// The defaults with what the calibration of this cloth found; the defaults when it refused.
[[nodiscard]] pipeline::Parameters calibratedOn(const sim::SimParameters& cloth);

}  // namespace fyd::bench
