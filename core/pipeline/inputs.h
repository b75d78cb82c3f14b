// All inputs of the step: nothing else reaches it, so a recording of them replays it bit for bit.
// Stability: stable since 0.1
#pragma once

#include <cstdint>

#include "core/base/fields.h"
#include "core/control/motor_types.h"
#include "core/pipeline/messages.h"
#include "core/sensing/finger_types.h"
#include "core/sensing/readings.h"

namespace fyd::pipeline {

/// Stored in files by number: numbers never change, and a new one takes the next.
enum class OperatorAction : std::uint8_t {
  arm = 0,                ///< start, or start again after Held or Stopped
  stop = 1,               ///< to Stopped, from anywhere
  tare = 2,               ///< take the present readings as "not touched": distance offsets and load-cell zero
  target_by_hand = 3,     ///< value: N/mm
  target_from_robot = 4,  ///< follow the robot's stiffness
  fell_silent = 5         ///< given by the station when the window that drives it stops answering: Held while rendering
};

struct OperatorCommand {
  OperatorAction action = OperatorAction::stop;
  double value = 0.0;

  static constexpr auto fields() {
    return std::tuple(Field("value", "1", "of the action, where it has one", &OperatorCommand::value),
                      Field("action", "1", "OperatorAction: its number", &OperatorCommand::action));
  }
};

/// A live parameter's new value; `index` counts as bindParameters(Parameters&) does in this library. A file counts as
/// its own profile does: who reads it (Recording::step) translates, to 0xFFFF where there is no such parameter here.
struct ParameterChange {
  std::uint16_t index = 0;
  double value = 0.0;

  static constexpr auto fields() {
    return std::tuple(
        Field("value", "1", "new value in the parameter's own unit", &ParameterChange::value),
        Field("index", "1",
              "the parameter's line in the file's own profile, from 0; as read, its number here, 65535: none",
              &ParameterChange::index));
  }
};

inline constexpr std::size_t kMaximumAccelerationsPerStep = 64;
inline constexpr std::size_t kMaximumCommandsPerStep = 16;

struct RobotInputs {
  LinkPhase phase = LinkPhase::none;
  Timed<RobotState> state;
  Timed<RobotMotorReference> motor_reference;
  Batch<texture::AccelerationSample, kMaximumAccelerationsPerStep> accelerations;
  Batch<RobotCommand, kMaximumCommandsPerStep> commands;
};

struct Inputs {
  Instant now{};
  std::uint64_t missed_cycles = 0;
  Timed<sensing::FingerDetection> finger;
  Timed<sensing::IrCounts> ir;
  Timed<sensing::BridgeReading> bridge;
  Timed<control::MotorFeedback> motors;
  RobotInputs robot;
  Batch<OperatorCommand, kMaximumCommandsPerStep> commands;
  Batch<ParameterChange, kMaximumCommandsPerStep> changes;

  /// Fields stored in the step's own row.
  static constexpr auto fields() {
    return std::tuple(
        Field("now_ns", "ns", "when the step was", &Inputs::now),
        Field("missed_cycles", "1", "cycles of the haptic loop that got no step, since its start",
              &Inputs::missed_cycles),
        Field("phase", "1", "LinkPhase: how the robot's link stands", inside(&Inputs::robot, &RobotInputs::phase)));
  }
  /// Inputs stored in tables of their own; the step's row refers to their rows.
  static constexpr auto tables() {
    const auto robot = [](auto member) { return inside(&Inputs::robot, member); };
    return std::tuple(
        InputTable("/inputs/finger", 3, "what the finger detector says of a picture, taken when that was",
                   &Inputs::finger),
        InputTable("/inputs/ir", 4, "a reading of the distance sensors", &Inputs::ir),
        InputTable("/inputs/bridge", 5, "a reading of the load cell", &Inputs::bridge),
        InputTable("/inputs/motor_feedback", 6, "what the motors report", &Inputs::motors, true),
        InputTable("/inputs/robot_state", 7, "what the robot says of itself", robot(&RobotInputs::state), true),
        InputTable("/inputs/motor_reference", 8, "where the robot wants the motors",
                   robot(&RobotInputs::motor_reference)),
        InputTable("/inputs/accelerations", 9, "a sample of the robot's accelerometer",
                   robot(&RobotInputs::accelerations), true),
        InputTable("/inputs/commands", 10, "a command of the operator", &Inputs::commands),
        InputTable("/inputs/robot_commands", 11, "a command of the robot's operator", robot(&RobotInputs::commands)),
        InputTable("/inputs/changes", 12, "a parameter changed while it ran", &Inputs::changes));
  }
};

}  // namespace fyd::pipeline
