// Everything the step may know: nothing reaches it by another way, so a recording of these re-runs it bit for bit.
#pragma once

#include <cstdint>

#include "core/base/batch.h"
#include "core/base/timed.h"
#include "core/control/motor_types.h"
#include "core/pipeline/messages.h"
#include "core/sensing/finger_types.h"
#include "core/sensing/readings.h"

namespace fyd::pipeline {

/// The numbers are what a file holds: they stay, and a new one takes the next.
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
};

/// A live parameter's new value; `index` counts as in bindParameters(Parameters&).
struct ParameterChange {
  std::uint16_t index = 0;
  double value = 0.0;
};

inline constexpr std::size_t kMaximumAccelerationsPerStep = 64;
inline constexpr std::size_t kMaximumCommandsPerStep = 16;

struct RobotInputs {
  LinkPhase phase = LinkPhase::none;
  Timed<RobotState> state;
  Timed<RobotMotorReference> motor_reference;
  Batch<AccelerationSample, kMaximumAccelerationsPerStep> accelerations;  ///< since the last step
  Batch<RobotCommand, kMaximumCommandsPerStep> commands;                  ///< since the last step
};

struct Inputs {
  Instant now{};
  std::uint64_t missed_cycles = 0;         ///< of the haptic loop since its start: cycles that got no step
  Timed<sensing::FingerDetection> finger;  ///< taken: when the picture was taken
  Timed<sensing::IrCounts> ir;
  Timed<sensing::BridgeReading> bridge;
  Timed<control::MotorFeedback> motors;
  RobotInputs robot;
  Batch<OperatorCommand, kMaximumCommandsPerStep> commands;
  Batch<ParameterChange, kMaximumCommandsPerStep> changes;
};

}  // namespace fyd::pipeline
