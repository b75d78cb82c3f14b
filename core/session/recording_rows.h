// Between the step's inputs and outputs and the rows of the tables; exact in both directions.
#pragma once

#include "core/base/error.h"
#include "core/pipeline/inputs.h"
#include "core/pipeline/outputs.h"
#include "core/session/recording_format.h"
#include "core/session/recording_types.h"

namespace fyd::session {

[[nodiscard]] inline std::int64_t nanoseconds(Instant when) { return when.time_since_epoch().count(); }
[[nodiscard]] inline Instant instantOf(std::int64_t nanoseconds) { return Instant(Duration(nanoseconds)); }

[[nodiscard]] FingerRow rowOf(const Timed<sensing::FingerDetection>& value);
[[nodiscard]] IrRow rowOf(const Timed<sensing::IrCounts>& value);
[[nodiscard]] BridgeRow rowOf(const Timed<sensing::BridgeReading>& value);
[[nodiscard]] MotorFeedbackRow rowOf(const Timed<control::MotorFeedback>& value);
[[nodiscard]] RobotStateRow rowOf(const Timed<pipeline::RobotState>& value);
[[nodiscard]] MotorReferenceRow rowOf(const Timed<pipeline::RobotMotorReference>& value);
[[nodiscard]] MotorRow rowOf(const control::MotorCommand& command);
[[nodiscard]] AccelerationRow rowOf(const pipeline::AccelerationSample& sample);
[[nodiscard]] CommandRow rowOf(const pipeline::OperatorCommand& command);
[[nodiscard]] RobotCommandRow rowOf(pipeline::RobotCommand command);
[[nodiscard]] ChangeRow rowOf(const pipeline::ParameterChange& change);
[[nodiscard]] EventTableRow rowOf(const EventRow& event);
[[nodiscard]] LinkTableRow rowOf(const LinkRow& link);
/// @param bytes_start where its bytes begin in /camera/bytes
[[nodiscard]] PictureRow rowOf(const EncodedPicture& picture, std::uint64_t bytes_start);

// @return an error when a word of the row is none this program knows; then nothing else of it is to be trusted
[[nodiscard]] Result<void> valueOf(const FingerRow& row, Timed<sensing::FingerDetection>& value);
[[nodiscard]] Result<void> valueOf(const IrRow& row, Timed<sensing::IrCounts>& value);
[[nodiscard]] Result<void> valueOf(const BridgeRow& row, Timed<sensing::BridgeReading>& value);
[[nodiscard]] Result<void> valueOf(const MotorFeedbackRow& row, Timed<control::MotorFeedback>& value);
[[nodiscard]] Result<void> valueOf(const RobotStateRow& row, Timed<pipeline::RobotState>& value);
[[nodiscard]] Result<void> valueOf(const MotorReferenceRow& row, Timed<pipeline::RobotMotorReference>& value);
[[nodiscard]] Result<void> valueOf(const MotorRow& row, control::MotorCommand& command);
[[nodiscard]] Result<void> valueOf(const AccelerationRow& row, pipeline::AccelerationSample& sample);
[[nodiscard]] Result<void> valueOf(const CommandRow& row, pipeline::OperatorCommand& command);
[[nodiscard]] Result<void> valueOf(const RobotCommandRow& row, pipeline::RobotCommand& command);
[[nodiscard]] Result<void> valueOf(const ChangeRow& row, pipeline::ParameterChange& change);
[[nodiscard]] Result<void> valueOf(const EventTableRow& row, EventRow& event);
[[nodiscard]] Result<void> valueOf(const LinkTableRow& row, LinkRow& link);
[[nodiscard]] Result<void> valueOf(const PictureRow& row, sensing::FingerDetection& finger);

}  // namespace fyd::session
