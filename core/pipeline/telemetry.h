// One sample per step, one struct: what the window draws is what the recorder writes is what replay compares.
// NaN means "there is none": never a zero.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "core/base/time.h"
#include "core/pipeline/messages.h"
#include "core/pipeline/safety.h"

namespace fyd::pipeline {

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct TelemetrySample {
  Instant now{};
  std::uint64_t step = 0;  ///< counts from 1
  SafetyState state = SafetyState::disconnected;
  Lack lack = Lack::none;  ///< why not ready, or why held
  LinkPhase link = LinkPhase::none;

  bool contact = false;
  double finger_x_mm = kNone;
  double finger_y_mm = kNone;
  double finger_area_px = kNone;

  double indentation_mm = kNone;
  double indentation_sigma_mm = kNone;
  double force_N = kNone;
  double stiffness_N_per_mm = kNone;  ///< measured; holds its last value while not observable
  bool stiffness_observable = false;
  double target_N_per_mm = kNone;            ///< as asked
  double reachable_target_N_per_mm = kNone;  ///< nearest the touchpad can do
  bool target_clamped = false;

  double stretch_reference_deg = kNone;  ///< commanded
  double stretch_measured_deg = kNone;   ///< from the encoders
  double translation_measured_deg = kNone;

  double acceleration_x_g = kNone;  ///< newest of the robot's, as received
  double acceleration_y_g = kNone;
  double acceleration_z_g = kNone;
  double texture_signal_g = 0.0;        ///< after high-pass and method, before PWM
  double vibration_duty_percent = 0.0;  ///< as sent to the motors
  double vibration_clipped = 0.0;       ///< steps in which the limit cut the signal, since the start

  double touch_x_mm = 0.0;  ///< position sent to the robot
  double touch_y_mm = 0.0;
  double touch_z_mm = 0.0;
  double robot_x_mm = kNone;  ///< position the robot reports
  double robot_y_mm = kNone;
  double robot_z_mm = kNone;

  double finger_age_ms = kNone;
  double ir_age_ms = kNone;
  double bridge_age_ms = kNone;
  double motors_age_ms = kNone;
  double robot_age_ms = kNone;
  double missed_cycles = 0.0;  ///< since the start
};

/// The table every consumer reads: column names, units, digits after the point.
struct TelemetryField {
  std::string_view name;
  std::string_view unit;
  int decimals = 3;
  double (*read)(const TelemetrySample&) = nullptr;
};

/// All fields, the time first, in seconds since the clock's origin.
[[nodiscard]] std::span<const TelemetryField> telemetryFields();

}  // namespace fyd::pipeline
