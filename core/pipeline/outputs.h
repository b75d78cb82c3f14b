// What one step gives.
#pragma once

#include <cstdint>

#include "core/base/batch.h"
#include "core/base/parameter.h"
#include "core/control/motor_types.h"
#include "core/pipeline/input_health.h"
#include "core/pipeline/messages.h"
#include "core/pipeline/safety.h"
#include "core/pipeline/telemetry.h"

namespace fyd::pipeline {

/// The numbers are what a file holds: they stay, and a new one takes the next.
enum class EventKind : std::uint8_t {
  state_changed = 0,      ///< state, lack
  arm_refused = 1,        ///< lack: what is missing
  tare_done = 2,          ///< value: largest change of an offset, mm
  tare_failed = 3,        ///< the cloth was touched or a sensor unavailable
  parameter_changed = 4,  ///< index, value
  parameter_refused = 5,  ///< index, value: not live, not finite or out of range
  robot_command = 6,      ///< value: the command
  target_clamped = 7,     ///< value: nearest reachable stiffness, N/mm
  time_reversed = 8,      ///< value: by how many seconds
};

struct Event {
  EventKind kind = EventKind::state_changed;
  SafetyState state = SafetyState::disconnected;
  Lack lack = Lack::none;
  std::uint16_t index = 0;
  double value = 0.0;

  static constexpr auto fields() {
    return std::tuple(Field("value", "1", "of the event, where it has one", &Event::value),
                      Field("kind", "1", "EventKind: its number", &Event::kind),
                      Field("state", "1", "SafetyState then", &Event::state),
                      Field("lack", "1", "Lack: what is missing; 0: nothing", &Event::lack),
                      Field("index", "1", "of a parameter's event: as in /inputs/changes", &Event::index));
  }
};

inline constexpr std::size_t kMaximumEventsPerStep = 32;

/// Calibration that a tare changed; the profile should keep it.
struct TareValues {
  ParameterList ir_offset_mm;
  double force_zero_N = 0.0;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(ir_offset_mm, force_zero_N);
  }
};

struct Outputs {
  control::MotorCommand motors;
  TouchMessage touch;
  TelemetrySample telemetry;
  Lacks lacks;      ///< everything missing for Active
  TareValues tare;  ///< of the event tare_done
  Batch<Event, kMaximumEventsPerStep> events;
};

}  // namespace fyd::pipeline
