// Outputs of one step.
// Stability: stable since 0.1
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

/// Listed in event_list.h, with their values and all their texts.
enum class EventKind : std::uint8_t {
#define EVENT(name, number, ...) name = number,
#include "core/pipeline/event_list.h"
#undef EVENT
};

struct Event {
  EventKind kind = EventKind::state_changed;
  SafetyState state = SafetyState::disconnected;  ///< of state_changed and arm_refused
  Fault fault = Fault::none;
  std::uint16_t index = 0;  ///< of an event that names a parameter: as in ParameterChange
  double value = 0.0;

  /// Whether `index` is a parameter's.
  [[nodiscard]] constexpr bool namesParameter() const {
    return kind == EventKind::parameter_changed || kind == EventKind::parameter_refused;
  }

  static constexpr auto fields() {
    return std::tuple(Field("value", "1", "of the event, where it has one", &Event::value),
                      Field("kind", "1", "EventKind: its number", &Event::kind),
                      Field("state", "1", "SafetyState: of state_changed and arm_refused; otherwise 0", &Event::state),
                      Field("lack", "1", "Fault: what is missing; 0: nothing", &Event::fault),
                      Field("index", "1", "of a parameter's event: as in /inputs/changes", &Event::index));
  }
};

/// Two of each of the robot's keys, one of each of the operator's commands and changes, and those of the step itself:
/// what says why a session stopped is never the one that finds no room.
inline constexpr std::size_t kMaximumEventsPerStep = 4 * kMaximumCommandsPerStep + 16;

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
  FaultSet faults;  ///< everything missing for Active
  TareValues tare;  ///< of the event tare_done
  Batch<Event, kMaximumEventsPerStep> events;
};

}  // namespace fyd::pipeline
