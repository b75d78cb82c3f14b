// One telemetry sample as a row of /telemetry: what a double would not keep exactly stands as integers.
#pragma once

#include <cstdint>

#include "core/base/error.h"
#include "core/pipeline/telemetry.h"
#include "core/session/recording_format.h"

namespace fyd::session {

// Members in the order of the row; every name but now_ns is a name of telemetryFields().
#define FYD_TELEMETRY_DOUBLES(X)                                                                                       \
  X(finger_x_mm)                                                                                                       \
  X(finger_y_mm)                                                                                                       \
  X(finger_area_px)                                                                                                    \
  X(indentation_mm)                                                                                                    \
  X(indentation_sigma_mm)                                                                                              \
  X(force_N)                                                                                                           \
  X(stiffness_N_per_mm) X(target_N_per_mm) X(reachable_target_N_per_mm) X(stretch_reference_deg)                       \
      X(stretch_measured_deg) X(translation_measured_deg) X(acceleration_x_g) X(acceleration_y_g) X(acceleration_z_g)  \
          X(texture_signal_g) X(vibration_duty_percent) X(vibration_clipped) X(touch_x_mm) X(touch_y_mm) X(touch_z_mm) \
              X(robot_x_mm) X(robot_y_mm) X(robot_z_mm) X(finger_age_ms) X(ir_age_ms) X(bridge_age_ms)                 \
                  X(motors_age_ms) X(robot_age_ms) X(missed_cycles)
#define FYD_TELEMETRY_BYTES(X) X(state) X(lack) X(link) X(contact) X(stiffness_observable) X(target_clamped)

struct TelemetryRow {
  std::int64_t now_ns = 0;
  double t_s = 0.0;
  std::uint64_t step = 0;
#define X(member) double member = 0.0;
  FYD_TELEMETRY_DOUBLES(X)
#undef X
#define X(member) std::uint8_t member = 0;
  FYD_TELEMETRY_BYTES(X)
#undef X
  std::array<std::uint8_t, 2> reserved{};
};

[[nodiscard]] TelemetryRow rowOf(const pipeline::TelemetrySample& sample);
/// @return an error when a word of the row is none we know
[[nodiscard]] pipeline::TelemetrySample sampleOf(const TelemetryRow& row);
/// Value of a field (index into telemetryFields()) straight from a row in memory.
[[nodiscard]] double fieldOf(const TelemetryRow& row, std::size_t field);

}  // namespace fyd::session
