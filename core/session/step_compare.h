// Whether two runs of the step gave the same, bit for bit: every telemetry field and the motor command.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/pipeline/arithmetic.h"
#include "core/session/step_record.h"

namespace fyd::session {

struct StepDifference {
  std::string field;      ///< name in telemetryFields(), or "motors"
  double absolute = 0.0;  ///< the largest of the step; infinite when a number stands against none
};

/// A recording that lacks columns cannot differ in them: they are taken from what is compared with it.
/// @param lacking RecordingInfo::lacking_columns
void takeLacking(const std::vector<std::string>& lacking, const pipeline::Outputs& computed, StepRecord& recorded);

/// NaN equals NaN of the same bits only.
[[nodiscard]] bool sameStep(const pipeline::TelemetrySample& a, const control::MotorCommand& a_motors,
                            const pipeline::TelemetrySample& b, const control::MotorCommand& b_motors);

/// The field that differs most; nothing when all are the same.
[[nodiscard]] std::optional<StepDifference> compareSteps(const pipeline::TelemetrySample& a,
                                                         const control::MotorCommand& a_motors,
                                                         const pipeline::TelemetrySample& b,
                                                         const control::MotorCommand& b_motors);

/// Whether no field and no command lies further apart than an older arithmetic explains. NaN is close to NaN only.
[[nodiscard]] bool withinTolerance(const pipeline::ArithmeticTolerance& tolerance, const pipeline::TelemetrySample& a,
                                   const control::MotorCommand& a_motors, const pipeline::TelemetrySample& b,
                                   const control::MotorCommand& b_motors);

}  // namespace fyd::session
