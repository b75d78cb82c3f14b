// The list of all curves: every floating-point field of a telemetry sample, and the strips that show them. A field that
// is not named here has its own strip under its export name. Live curves and those of a review use the same list.
#pragma once

#include <QString>
#include <cstddef>
#include <span>
#include <vector>

#include "core/pipeline/telemetry.h"
#include "widgets/curves/curve_stack.h"

namespace fyd::widgets {

struct CurveQuantity {
  const char* field = "";  ///< name in pipeline::telemetryFields()
  const char* word = "";   ///< what the strip does not already say: "x", "target"; empty: the strip's own quantity
  Quantity quantity = Quantity::none;
  Stroke stroke = Stroke::solid;
  int decimals = 2;
  bool numeral = true;  ///< false: only a line
  /// Age of the touchpad's reading that it repeats, of one that says nothing itself of its age.
  double pipeline::TelemetrySample::*age = nullptr;
};

/// The channels of a curve source, in their order.
enum CurveChannel : std::size_t {
  kForce,
  kIndentation,
  kStiffness,
  kTarget,
  kVibration,
  kAccelerationX,
  kAccelerationY,
  kAccelerationZ,
  kTextureSignal,
  kFeltAcceleration,
  kFeltLevel,
  kVibrationRms,
  kVibrationDead,
  kVibrationClipped,
  kOutOfReach,
  kReachableTarget,
  kStretchReference,
  kStretchMeasured,
  kTranslation,
  kFingerX,
  kFingerY,
  kFingerArea,
  kTouchX,
  kTouchY,
  kTouchZ,
  kRobotX,
  kRobotY,
  kRobotZ,
  kFingerAge,
  kIrAge,
  kBridgeAge,
  kMotorsAge,
  kRobotAge,
  kMissedCycles,
  kClippedSteps,
  kRobotStiffness,
  kRobotForce,
  kFingerEnergy,
  kWithheld,
  kNamedCurves
};
inline constexpr std::size_t kCurveChannels = [] {
  std::size_t count = 0;
  forEachField<pipeline::TelemetrySample>([&](auto, const auto& field) {
    if (std::is_same_v<FieldResult<decltype(field), pipeline::TelemetrySample>, double&>) ++count;
  });
  return count;
}();

/// kCurveChannels of them.
[[nodiscard]] std::span<const CurveQuantity> curveQuantities();
/// Index into telemetryFields(), one for each channel.
[[nodiscard]] std::span<const std::size_t> curveFields();

struct StripPlan {
  const char* id = "";
  const char* title = "";
  const char* unit = "";  ///< its first field's
  Range least;            ///< shown at least
  std::vector<std::size_t> channels;
  bool lanes = false;  ///< signals that would hide each other: one below the other
  bool large = false;  ///< a large numeral
  bool peak = false;   ///< its numeral is the largest magnitude since the last one, not the mean
  bool usual = false;  ///< shown by default
};

[[nodiscard]] const std::vector<StripPlan>& stripPlans();
/// Its title in the operator's language.
[[nodiscard]] QString titleOf(const StripPlan& plan);
[[nodiscard]] QString wordOf(const CurveQuantity& quantity);
/// The strip's setup in the stack, without traces.
[[nodiscard]] StripSetup setupOf(const StripPlan& plan);

}  // namespace fyd::widgets
