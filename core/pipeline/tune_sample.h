// What the auto-tune and the identification of the cloth take from a telemetry sample.
#pragma once

#include <cmath>

#include "core/control/cloth_identification.h"
#include "core/pipeline/telemetry.h"

namespace fyd::pipeline {

/// The law holds for the middle of the cloth: the measured stiffness is divided by the place factor where that is
/// known.
[[nodiscard]] inline control::TuneSample tuneSampleOf(const TelemetrySample& sample, double time_s) {
  const double factor = std::isfinite(sample.stiffness_place_factor) ? sample.stiffness_place_factor : 1.0;
  return {.time_s = time_s,
          .angle_deg = sample.stretch_measured_deg,
          .stiffness_N_per_mm = sample.stiffness_observable ? sample.stiffness_N_per_mm / factor : kNone};
}

}  // namespace fyd::pipeline
