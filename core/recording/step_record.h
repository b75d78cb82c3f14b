// Everything of one step, as the haptic loop hands it to the recorder: what went in and what came out.
// Stability: stable since 0.1
#pragma once

#include "core/pipeline/inputs.h"
#include "core/pipeline/outputs.h"

namespace fyd::recording {

struct StepRecord {
  /// A bit for each table whose rows for this step are lost, which `missingTables` names; 0: none. The members they fill
  /// are a new record's, as if nothing had ever come.
  std::uint32_t missing = 0;
  pipeline::Inputs inputs;
  control::MotorCommand motors;
  pipeline::TelemetrySample telemetry;
  Batch<pipeline::Event, pipeline::kMaximumEventsPerStep> events;
};

}  // namespace fyd::recording
