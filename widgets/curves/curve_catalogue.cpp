#include "widgets/curves/curve_catalogue.h"

#include <QCoreApplication>
#include <algorithm>
#include <array>

namespace fyd::widgets {
namespace {

using enum Quantity;

// In the order of CurveChannel. A quantity without its own colour uses the text's, in its own strip.
constexpr std::array<CurveQuantity, kNamedCurves> kNamed = {{
    {.field = "force_N", .word = "", .quantity = force, .age = &pipeline::TelemetrySample::bridge_age_ms},
    {.field = "indentation_mm", .word = "", .quantity = indentation},
    {.field = "stiffness_N_per_mm", .word = "", .quantity = stiffness},
    {.field = "target_N_per_mm",
     .word = QT_TRANSLATE_NOOP("Curves", "target"),
     .quantity = stiffness,
     .stroke = Stroke::dashed},
    {.field = "vibration_duty_percent", .word = "", .quantity = vibration, .decimals = 0},
    {.field = "acceleration_x_g", .word = "x", .quantity = acceleration_x},
    {.field = "acceleration_y_g", .word = "y", .quantity = acceleration_y},
    {.field = "acceleration_z_g", .word = "z", .quantity = acceleration_z},
    {.field = "texture_signal_g", .word = QT_TRANSLATE_NOOP("Curves", "wanted"), .quantity = vibration},
    {.field = "felt_acceleration_g", .word = QT_TRANSLATE_NOOP("Curves", "felt"), .quantity = vibration},
    {.field = "felt_level_dB", .word = "", .quantity = vibration, .decimals = 1},
    {.field = "vibration_rms_percent", .word = QT_TRANSLATE_NOOP("Curves", "RMS"), .decimals = 0},
    {.field = "vibration_dead_share", .word = QT_TRANSLATE_NOOP("Curves", "too small to turn")},
    {.field = "vibration_clipped_share", .word = QT_TRANSLATE_NOOP("Curves", "clipped")},
    {.field = "felt_out_of_reach", .word = QT_TRANSLATE_NOOP("Curves", "out of reach"), .decimals = 0},
    {.field = "reachable_target_N_per_mm",
     .word = QT_TRANSLATE_NOOP("Curves", "reachable"),
     .quantity = stiffness,
     .stroke = Stroke::dotted,
     .numeral = false},
    {.field = "stretch_reference_deg",
     .word = QT_TRANSLATE_NOOP("Curves", "reference"),
     .stroke = Stroke::dashed,
     .decimals = 1},
    {.field = "stretch_measured_deg",
     .word = QT_TRANSLATE_NOOP("Curves", "measured"),
     .decimals = 1,
     .age = &pipeline::TelemetrySample::motors_age_ms},
    {.field = "translation_measured_deg", .word = "", .decimals = 1, .age = &pipeline::TelemetrySample::motors_age_ms},
    {.field = "finger_x_mm", .word = "x", .decimals = 1},
    {.field = "finger_y_mm", .word = "y", .decimals = 1},
    {.field = "finger_area_px", .word = "", .decimals = 0},
    {.field = "touch_x_mm", .word = "x", .decimals = 1},
    {.field = "touch_y_mm", .word = "y", .decimals = 1},
    {.field = "touch_z_mm", .word = "z", .decimals = 1},
    {.field = "robot_x_mm", .word = "x", .decimals = 1},
    {.field = "robot_y_mm", .word = "y", .decimals = 1},
    {.field = "robot_z_mm", .word = "z", .decimals = 1},
    {.field = "finger_age_ms", .word = QT_TRANSLATE_NOOP("Curves", "finger"), .decimals = 0},
    {.field = "ir_age_ms", .word = QT_TRANSLATE_NOOP("Curves", "IR"), .decimals = 0},
    {.field = "bridge_age_ms", .word = QT_TRANSLATE_NOOP("Curves", "force"), .decimals = 0},
    {.field = "motors_age_ms", .word = QT_TRANSLATE_NOOP("Curves", "motors"), .decimals = 0},
    {.field = "robot_age_ms", .word = QT_TRANSLATE_NOOP("Curves", "robot"), .decimals = 0},
    {.field = "missed_cycles", .word = "", .decimals = 0},
    {.field = "vibration_clipped", .word = "", .decimals = 0},
    {.field = "robot_stiffness_N_per_mm", .word = "", .quantity = stiffness},
    {.field = "robot_force_N", .word = "", .quantity = force},
    {.field = "finger_energy_mJ", .word = QT_TRANSLATE_NOOP("Curves", "put in"), .decimals = 1},
    {.field = "coupling_withheld_mJ",
     .word = QT_TRANSLATE_NOOP("Curves", "withheld"),
     .stroke = Stroke::dashed,
     .decimals = 1},
}};

QString translated(const char* text) {
  return text[0] == '\0' ? QString() : QCoreApplication::translate("Curves", text);
}

}  // namespace

std::span<const CurveQuantity> curveQuantities() {
  static const std::vector<CurveQuantity> kQuantities = [] {
    std::vector<CurveQuantity> out(kNamed.begin(), kNamed.end());
    forEachField<pipeline::TelemetrySample>([&](auto, const auto& field) {
      if (!std::is_same_v<FieldResult<decltype(field), pipeline::TelemetrySample>, double&>) return;
      const auto named = [&](const CurveQuantity& each) { return each.field == field.name; };
      if (std::ranges::none_of(kNamed, named)) out.push_back({.field = field.name.data(), .word = ""});
    });
    return out;
  }();
  return kQuantities;
}

std::span<const std::size_t> curveFields() {
  static const std::vector<std::size_t> kIndexes = [] {
    const auto fields = pipeline::telemetryFields();
    std::vector<std::size_t> out;
    for (const CurveQuantity& each : curveQuantities()) {
      const auto found = std::ranges::find(fields, std::string_view(each.field), &pipeline::TelemetryField::name);
      out.push_back(static_cast<std::size_t>(found - fields.begin()));
    }
    return out;
  }();
  return kIndexes;
}

namespace {

/// Adds the units, and a strip for each curve that has none.
std::vector<StripPlan> completed(std::vector<StripPlan> plans) {
  for (std::size_t channel = kNamedCurves; channel < kCurveChannels; ++channel) {
    const char* name = curveQuantities()[channel].field;
    plans.push_back({.id = name, .title = name, .least = {0, 1}, .channels = {channel}});
  }
  for (StripPlan& plan : plans) {
    const std::string_view unit = pipeline::telemetryFields()[curveFields()[plan.channels.front()]].unit;
    if (unit != "1") plan.unit = unit.data();
  }
  return plans;
}

}  // namespace

const std::vector<StripPlan>& stripPlans() {
  static const std::vector<StripPlan> kPlans = completed({
      {.id = "force",
       .title = QT_TRANSLATE_NOOP("Curves", "Force"),
       .least = {0, 2},
       .channels = {kForce},
       .large = true,
       .usual = true},
      {.id = "indentation",
       .title = QT_TRANSLATE_NOOP("Curves", "Indentation"),
       .least = {0, 5},
       .channels = {kIndentation},
       .large = true,
       .usual = true},
      {.id = "stiffness",
       .title = QT_TRANSLATE_NOOP("Curves", "Stiffness"),
       .least = {0, 1},
       .channels = {kStiffness, kTarget, kReachableTarget},
       .large = true,
       .usual = true},
      {.id = "vibration",
       .title = QT_TRANSLATE_NOOP("Curves", "Vibration"),
       .least = {-100, 100},
       .channels = {kVibration},
       .large = true,
       .peak = true,
       .usual = true},
      {.id = "acceleration",
       .title = QT_TRANSLATE_NOOP("Curves", "Acceleration"),
       .least = {-1, 1},
       .channels = {kAccelerationX, kAccelerationY, kAccelerationZ},
       .lanes = true,
       .peak = true,
       .usual = true},
      {.id = "texture_signal",
       .title = QT_TRANSLATE_NOOP("Curves", "Texture"),
       .least = {-0.2, 0.2},
       .channels = {kTextureSignal, kFeltAcceleration},
       .lanes = true,
       .peak = true},
      {.id = "felt_level",
       .title = QT_TRANSLATE_NOOP("Curves", "Felt, over threshold"),
       .least = {-10, 20},
       .channels = {kFeltLevel}},
      {.id = "vibration_rms",
       .title = QT_TRANSLATE_NOOP("Curves", "Motors' vibration"),
       .least = {0, 40},
       .channels = {kVibrationRms}},
      {.id = "vibration_shares",
       .title = QT_TRANSLATE_NOOP("Curves", "Share of the vibration"),
       .least = {0, 1},
       .channels = {kVibrationDead, kVibrationClipped, kOutOfReach},
       .lanes = true},
      {.id = "stretch",
       .title = QT_TRANSLATE_NOOP("Curves", "Stretch"),
       .least = {-10, 10},
       .channels = {kStretchMeasured, kStretchReference}},
      {.id = "translation",
       .title = QT_TRANSLATE_NOOP("Curves", "Translation"),
       .least = {-10, 10},
       .channels = {kTranslation}},
      {.id = "finger",
       .title = QT_TRANSLATE_NOOP("Curves", "Finger"),
       .least = {-20, 20},
       .channels = {kFingerX, kFingerY},
       .lanes = true},
      {.id = "area",
       .title = QT_TRANSLATE_NOOP("Curves", "Finger's area"),
       .least = {0, 500},
       .channels = {kFingerArea}},
      {.id = "touch",
       .title = QT_TRANSLATE_NOOP("Curves", "Position sent"),
       .least = {-20, 20},
       .channels = {kTouchX, kTouchY, kTouchZ},
       .lanes = true},
      {.id = "robot",
       .title = QT_TRANSLATE_NOOP("Curves", "Robot's position"),
       .least = {-20, 20},
       .channels = {kRobotX, kRobotY, kRobotZ},
       .lanes = true},
      {.id = "ages",
       .title = QT_TRANSLATE_NOOP("Curves", "Age of inputs"),
       .least = {-50, 50},
       .channels = {kFingerAge, kIrAge, kBridgeAge, kMotorsAge, kRobotAge},
       .lanes = true,
       .peak = true},
      {.id = "missed",
       .title = QT_TRANSLATE_NOOP("Curves", "Cycles missed"),
       .least = {0, 10},
       .channels = {kMissedCycles}},
      {.id = "clipped",
       .title = QT_TRANSLATE_NOOP("Curves", "Steps clipped"),
       .least = {0, 10},
       .channels = {kClippedSteps}},
      {.id = "robot_stiffness",
       .title = QT_TRANSLATE_NOOP("Curves", "Stiffness the robot tells"),
       .least = {0, 1},
       .channels = {kRobotStiffness}},
      {.id = "robot_force",
       .title = QT_TRANSLATE_NOOP("Curves", "Force the robot tells"),
       .least = {0, 2},
       .channels = {kRobotForce}},
      {.id = "energy",
       .title = QT_TRANSLATE_NOOP("Curves", "Energy of the touch"),
       .least = {-1, 5},
       .channels = {kFingerEnergy, kWithheld}},
  });
  return kPlans;
}

QString titleOf(const StripPlan& plan) { return translated(plan.title); }
QString wordOf(const CurveQuantity& quantity) { return translated(quantity.word); }

StripSetup setupOf(const StripPlan& plan) {
  StripSetup setup{.id = QLatin1String(plan.id),
                   .title = titleOf(plan),
                   .unit = QString::fromUtf8(plan.unit),
                   .least = plan.least,
                   .large = plan.large,
                   .peak = plan.peak,
                   .shown = plan.usual};
  for (const std::size_t channel : plan.channels) {
    const CurveQuantity& q = curveQuantities()[channel];
    if (!q.numeral) continue;
    setup.entries.push_back(
        {.label = wordOf(q), .quantity = q.quantity, .dashed = q.stroke == Stroke::dashed, .decimals = q.decimals});
    setup.channels.push_back(channel);
  }
  return setup;
}

}  // namespace fyd::widgets
