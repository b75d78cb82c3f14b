// Whether two runs of the step gave the same, bit for bit: every telemetry field and the motor command.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/arithmetic.h"
#include "core/recording/step_record.h"

namespace fyd::recording {

struct StepDifference {
  std::string field;      ///< name in telemetryFields(), or "motors"
  double absolute = 0.0;  ///< the largest of the step; infinite when only one of the two values is finite
};

/// A recording that lacks columns cannot differ in them: they are taken from what is compared with it.
/// @param lacking RecordingInfo::missing_columns
void takeMissingColumns(const std::vector<std::string>& lacking, const pipeline::Outputs& computed,
                        StepRecord& recorded);

/// NaN equals NaN of the same bits only.
[[nodiscard]] bool sameStep(const pipeline::TelemetrySample& a, const control::MotorCommand& a_motors,
                            const pipeline::TelemetrySample& b, const control::MotorCommand& b_motors);

/// The field that differs most; nothing when all are the same.
[[nodiscard]] std::optional<StepDifference> compareSteps(const pipeline::TelemetrySample& a,
                                                         const control::MotorCommand& a_motors,
                                                         const pipeline::TelemetrySample& b,
                                                         const control::MotorCommand& b_motors);

/// Whether all fields and commands agree within the tolerance of an older arithmetic. NaN agrees with NaN only.
[[nodiscard]] bool withinTolerance(const pipeline::ArithmeticTolerance& tolerance, const pipeline::TelemetrySample& a,
                                   const control::MotorCommand& a_motors, const pipeline::TelemetrySample& b,
                                   const control::MotorCommand& b_motors);

}  // namespace fyd::recording
