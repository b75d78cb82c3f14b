#include "core/pipeline/telemetry.h"

#include <array>

namespace fyd::pipeline {
namespace {

using Sample = TelemetrySample;

#define FYD_FIELD(member, unit, decimals)                                                  \
  TelemetryField {                                                                         \
#member, unit, decimals, [](const Sample& s) { return static_cast<double>(s.member); } \
  }

constexpr auto kFields = std::to_array<TelemetryField>({
    {"t_s", "s", 6, [](const Sample& s) { return toSeconds(s.now.time_since_epoch()); }},
    FYD_FIELD(step, "1", 0),
    FYD_FIELD(state, "1", 0),
    FYD_FIELD(lack, "1", 0),
    FYD_FIELD(link, "1", 0),
    FYD_FIELD(contact, "1", 0),
    FYD_FIELD(finger_x_mm, "mm", 3),
    FYD_FIELD(finger_y_mm, "mm", 3),
    FYD_FIELD(finger_area_px, "px", 0),
    FYD_FIELD(indentation_mm, "mm", 4),
    FYD_FIELD(indentation_sigma_mm, "mm", 4),
    FYD_FIELD(force_N, "N", 4),
    FYD_FIELD(stiffness_N_per_mm, "N/mm", 4),
    FYD_FIELD(stiffness_observable, "1", 0),
    FYD_FIELD(target_N_per_mm, "N/mm", 4),
    FYD_FIELD(reachable_target_N_per_mm, "N/mm", 4),
    FYD_FIELD(target_clamped, "1", 0),
    FYD_FIELD(stretch_reference_deg, "°", 3),
    FYD_FIELD(stretch_measured_deg, "°", 3),
    FYD_FIELD(translation_measured_deg, "°", 3),
    FYD_FIELD(acceleration_x_g, "g", 4),
    FYD_FIELD(acceleration_y_g, "g", 4),
    FYD_FIELD(acceleration_z_g, "g", 4),
    FYD_FIELD(texture_signal_g, "g", 5),
    FYD_FIELD(vibration_duty_percent, "%", 2),
    FYD_FIELD(vibration_clipped, "1", 0),
    FYD_FIELD(touch_x_mm, "mm", 3),
    FYD_FIELD(touch_y_mm, "mm", 3),
    FYD_FIELD(touch_z_mm, "mm", 3),
    FYD_FIELD(robot_x_mm, "mm", 3),
    FYD_FIELD(robot_y_mm, "mm", 3),
    FYD_FIELD(robot_z_mm, "mm", 3),
    FYD_FIELD(finger_age_ms, "ms", 2),
    FYD_FIELD(ir_age_ms, "ms", 2),
    FYD_FIELD(bridge_age_ms, "ms", 2),
    FYD_FIELD(motors_age_ms, "ms", 2),
    FYD_FIELD(robot_age_ms, "ms", 2),
    FYD_FIELD(missed_cycles, "1", 0),
});

#undef FYD_FIELD

}  // namespace

std::span<const TelemetryField> telemetryFields() { return kFields; }

}  // namespace fyd::pipeline
