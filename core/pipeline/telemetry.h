// Telemetry: one sample per step. The window draws, the recorder writes and replay compares this same struct.
// NaN means "no value"; 0 is never used for that.
// Stability: stable since 0.1
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "core/base/api.h"
#include "core/base/fields.h"
#include "core/pipeline/messages.h"
#include "core/pipeline/safety.h"

namespace fyd::pipeline {

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

struct TelemetrySample {
  Instant now{};
  std::uint64_t step = 0;
  SafetyState state = SafetyState::disconnected;
  Fault fault = Fault::none;
  LinkPhase link = LinkPhase::none;

  bool contact = false;
  double finger_x_mm = kNone;
  double finger_y_mm = kNone;
  double finger_area_px = kNone;

  double indentation_mm = kNone;
  double indentation_sigma_mm = kNone;
  double force_N = kNone;
  double stiffness_N_per_mm = kNone;
  bool stiffness_observable = false;
  double stiffness_place_factor = kNone;
  double robot_stiffness_N_per_mm = kNone;
  double robot_force_N = kNone;
  double target_N_per_mm = kNone;
  double reachable_target_N_per_mm = kNone;
  bool target_clamped = false;
  double finger_energy_mJ = kNone;
  double coupling_withheld_mJ = kNone;

  double stretch_reference_deg = kNone;
  double stretch_measured_deg = kNone;
  double translation_measured_deg = kNone;

  double acceleration_x_g = kNone;
  double acceleration_y_g = kNone;
  double acceleration_z_g = kNone;
  double texture_signal_g = 0.0;
  double vibration_duty_percent = 0.0;
  double vibration_clipped = 0.0;
  double vibration_rms_percent = kNone;
  double vibration_dead_share = kNone;
  double vibration_clipped_share = kNone;
  double felt_acceleration_g = kNone;
  double felt_level_dB = kNone;
  double felt_out_of_reach = kNone;

  double touch_x_mm = 0.0;
  double touch_y_mm = 0.0;
  double touch_z_mm = 0.0;
  double robot_x_mm = kNone;
  double robot_y_mm = kNone;
  double robot_z_mm = kNone;

  double finger_age_ms = kNone;
  double ir_age_ms = kNone;
  double bridge_age_ms = kNone;
  double motors_age_ms = kNone;
  double robot_age_ms = kNone;
  double missed_cycles = 0.0;

  static constexpr auto fields() {
    using T = TelemetrySample;
    return std::tuple(
        Field("now_ns", "ns", "the station's clock, exactly", &T::now),
        Field("t_s", "s", "the station's clock in seconds",
              [](const T& t) { return toSeconds(t.now.time_since_epoch()); }),
        Field("step", "1", "counts from 1", &T::step), Field("state", "1", "SafetyState: its number", &T::state),
        Field("lack", "1", "Fault: why not ready, or why held; 0: nothing", &T::fault),
        Field("link", "1", "LinkPhase: how the robot's link stands", &T::link),
        Field("contact", "1", "1: the cloth is touched", &T::contact),
        Field("finger_x_mm", "mm", "where the finger is in the touchpad's frame, x right; none without contact",
              &T::finger_x_mm),
        Field("finger_y_mm", "mm", "where the finger is in the touchpad's frame, y back; none without contact",
              &T::finger_y_mm),
        Field("finger_area_px", "px", "dark area of the newest picture", &T::finger_area_px),
        Field("indentation_mm", "mm", "how deep the finger presses", &T::indentation_mm),
        Field("indentation_sigma_mm", "mm", "standard deviation of the indentation", &T::indentation_sigma_mm),
        Field("force_N", "N", "normal force at the finger", &T::force_N),
        Field("stiffness_N_per_mm", "N/mm", "measured stiffness; keeps its last value while it cannot be observed",
              &T::stiffness_N_per_mm),
        Field("stiffness_observable", "1", "1: the measured stiffness is of now", &T::stiffness_observable),
        Field("stiffness_place_factor", "1",
              "stiffness of the cloth under this finger over that of the law, by place and depth; none where unknown",
              &T::stiffness_place_factor),
        Field("robot_stiffness_N_per_mm", "N/mm",
              "stiffness as the robot tells it, before the coupling; 0: it touches nothing",
              &T::robot_stiffness_N_per_mm),
        Field("robot_force_N", "N", "force of the robot's tool on what it touches; none where it does not tell it",
              &T::robot_force_N),
        Field("target_N_per_mm", "N/mm", "stiffness asked for", &T::target_N_per_mm),
        Field("reachable_target_N_per_mm", "N/mm", "stiffness nearest to the target that the touchpad can do",
              &T::reachable_target_N_per_mm),
        Field("target_clamped", "1", "1: the target asked for is not reachable", &T::target_clamped),
        Field("finger_energy_mJ", "mJ",
              "energy that the finger has put into the cloth, less what came back, during this touch or the last one",
              &T::finger_energy_mJ),
        Field("coupling_withheld_mJ", "mJ",
              "energy that a cloth as stiff as was asked for would have given this finger more, during this touch or "
              "the last one",
              &T::coupling_withheld_mJ),
        Field("stretch_reference_deg", "°", "stretch of the cloth, as commanded", &T::stretch_reference_deg),
        Field("stretch_measured_deg", "°", "stretch of the cloth, from the encoders", &T::stretch_measured_deg),
        Field("translation_measured_deg", "°", "sideways motion of the cloth, from the encoders",
              &T::translation_measured_deg),
        Field("acceleration_x_g", "g", "newest acceleration of the robot's, as received, x", &T::acceleration_x_g),
        Field("acceleration_y_g", "g", "newest acceleration of the robot's, as received, y", &T::acceleration_y_g),
        Field("acceleration_z_g", "g", "newest acceleration of the robot's, as received, z", &T::acceleration_z_g),
        Field("texture_signal_g", "g", "signal of the texture after high-pass and method, before PWM",
              &T::texture_signal_g),
        Field("vibration_duty_percent", "%", "vibration as sent to the first motor", &T::vibration_duty_percent),
        Field("vibration_clipped", "1", "steps in which the limit cut the signal, since the start",
              &T::vibration_clipped),
        Field("vibration_rms_percent", "%", "RMS of the duty over a second, of the motor with more",
              &T::vibration_rms_percent),
        Field("vibration_dead_share", "1",
              "share of the last second's samples with a duty that is too small to turn a motor",
              &T::vibration_dead_share),
        Field("vibration_clipped_share", "1", "share of the last second's samples that a limit cut",
              &T::vibration_clipped_share),
        Field("felt_acceleration_g", "g",
              "acceleration of the finger that the duties make, by texture.plant_*: an estimate, a guess where the "
              "plant was not identified",
              &T::felt_acceleration_g),
        Field("felt_level_dB", "dB",
              "its RMS over a second, over the least that a finger feels (0.02 g); −120 at least", &T::felt_level_dB),
        Field("felt_out_of_reach", "1", "1: a texture is wanted, and less than a finger feels arrives",
              &T::felt_out_of_reach),
        Field("touch_x_mm", "mm", "position sent to the robot, x right", &T::touch_x_mm),
        Field("touch_y_mm", "mm", "position sent to the robot, y back", &T::touch_y_mm),
        Field("touch_z_mm", "mm", "position sent to the robot, z up: pressing is negative", &T::touch_z_mm),
        Field("robot_x_mm", "mm", "position that the robot reports, x right", &T::robot_x_mm),
        Field("robot_y_mm", "mm", "position that the robot reports, y back", &T::robot_y_mm),
        Field("robot_z_mm", "mm", "position that the robot reports, z up", &T::robot_z_mm),
        Field("finger_age_ms", "ms", "age of the newest picture's result", &T::finger_age_ms),
        Field("ir_age_ms", "ms", "age of the newest distances", &T::ir_age_ms),
        Field("bridge_age_ms", "ms", "age of the newest force", &T::bridge_age_ms),
        Field("motors_age_ms", "ms", "age of the motors' newest report", &T::motors_age_ms),
        Field("robot_age_ms", "ms", "age of the robot's newest state", &T::robot_age_ms),
        Field("missed_cycles", "1", "cycles of the haptic loop that got no step, since the start", &T::missed_cycles));
  }
};

/// A field of the sample as a number: what CSV, MATLAB, MCAP, curves and reports read.
struct TelemetryField {
  std::string_view name;
  std::string_view unit;
  std::string_view help;
  double (*read)(const TelemetrySample&) = nullptr;
};

/// All fields except now_ns; the first is the time in seconds since the clock's origin.
[[nodiscard]] FYD_API std::span<const TelemetryField> telemetryFields();

}  // namespace fyd::pipeline
