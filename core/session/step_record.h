// Everything of one step, as the haptic loop hands it to the recorder: what went in and what came out.
#pragma once

#include "core/pipeline/inputs.h"
#include "core/pipeline/outputs.h"

namespace fyd::session {

struct StepRecord {
  pipeline::Inputs inputs;
  control::MotorCommand motors;
  pipeline::TelemetrySample telemetry;
  Batch<pipeline::Event, pipeline::kMaximumEventsPerStep> events;
};

}  // namespace fyd::session
