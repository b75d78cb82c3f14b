// Parameters of the stretch control that an operator or a profile may set.
// Stability: stable since 0.1
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/api.h"
#include "core/base/error.h"
#include "core/base/message.h"
#include "core/base/parameter.h"

namespace fyd::control {

enum class ControlMode : std::uint8_t {
  normal,  ///< feed-forward from the static law, PID on the relative error; "default" in profiles
  thesis,  ///< every 100 ms a PI(D) on the error in N/mm around the rest position [thesis §4.1.4]
};
inline constexpr std::array<std::string_view, 2> kControlModeNames = {"default", "thesis"};

enum class StaticLawKind : std::uint8_t {
  interpolated,   ///< monotone curve through the profile's calibration points
  thesis,         ///< 314.5 k² − 107 k − 0.3552 [thesis §4.1.4]
  thesis_linear,  ///< 204.6 k − 23.6 (the authors' later code, another cloth)
};
inline constexpr std::array<std::string_view, 3> kStaticLawNames = {"interpolated", "thesis", "thesis-linear"};

/// How much of a measured difference from the law the loop corrects (scale_trust.h).
enum class CorrectionRule : std::uint8_t { excess, bounded };
inline constexpr std::array<std::string_view, 2> kCorrectionRuleNames = {"excess", "bounded"};

/// No limit in effect: ln(1 + 4) exceeds the largest ln S that the observer can learn, 1.5.
inline constexpr double kNoCorrectionLimit = 4.0;

// Largest gains: what no cloth bears on any touchpad of this kind. With motors of 30 ms (loop_prediction.h) and nothing
// later than the step itself, the gain margin of Ki alone is used up at 118, that of Kd at 3.3 (filter 0.1 s) and that
// of Kp at 31; but from 15 up Kp drives the motors so far into their speed limit that the stretch swings on. In mode
// thesis, with its default period and measurement, at 358, 770 and 52. Later sensors and motors bear less: tuning.md.
inline constexpr double kMostKp = 20.0;
inline constexpr double kMostKi_per_s = 120.0;
inline constexpr double kMostKd_s = 3.5;
inline constexpr double kMostThesisKp = 400.0;  // deg/(N/mm)
inline constexpr double kMostThesisKi = 800.0;  // deg/(N/mm)/s
inline constexpr double kMostThesisKd = 60.0;   // deg/(N/mm)·s

struct ControlParameters {
  ControlMode mode = ControlMode::normal;
  StaticLawKind law = StaticLawKind::interpolated;
  ParameterList law_angle_deg{{20.0, 45.0, 60.0, 90.0}, 4};
  ParameterList law_stiffness_N_per_mm{{0.501, 0.550, 0.673, 0.715}, 4};

  double kp = 0.15;
  double ki_per_s = 5.0;
  double kd_s = 0.0;
  double derivative_filter_s = 0.1;
  double dead_band_N_per_mm = 0.003;
  double measurement_lag_s = 0.25;
  double measurement_delay_s = 0.05;
  double noise_correlation_s = 0.4;
  double measurement_bias = 0.15;
  double correction_limit = 0.5;
  CorrectionRule correction = CorrectionRule::bounded;

  double travel_minimum_deg = 20.0;
  double travel_maximum_deg = 90.0;
  double rate_limit_deg_per_s = 180.0;
  double motor_limit_deg = 120.0;

  double thesis_kp = 60.0;
  double thesis_ki = 60.0;
  double thesis_kd = 0.0;
  double thesis_period_ms = 100.0;

  int encoder_zero_first_counts = 0;
  int encoder_zero_second_counts = 0;
  bool encoder_first_inverted = false;
  bool encoder_second_inverted = false;

  template <class Visitor>
  void describe(Visitor& v) {
    v.choice(
        "control.mode", mode, kControlModeNames,
        {.help = sentence("How the stretch follows the stiffness target: law and PID, or as the thesis prints it.")});
    v.choice("control.law", law, kStaticLawNames,
             {.help = sentence("Static law between stretch angle and stiffness; interpolated uses the points below.")});
    v.list("control.law_angle_deg", law_angle_deg,
           {.unit = "deg",
            .minimum = -180,
            .maximum = 180,
            .help = sentence("Stretch angles of the calibration points, rising.")});
    v.list("control.law_stiffness_N_per_mm", law_stiffness_N_per_mm,
           {.unit = "N/mm",
            .minimum = 0.01,
            .maximum = 10,
            .help = sentence("Stiffness measured at each of those angles, rising.")});
    v.real("control.kp", kp,
           {.name = sentence("Kp"),
            .minimum = 0,
            .maximum = kMostKp,
            .help = sentence("Proportional gain: relative correction for relative error."),
            .live = true});
    v.real("control.ki", ki_per_s,
           {.name = sentence("Ki"),
            .unit = "1/s",
            .minimum = 0,
            .maximum = kMostKi_per_s,
            .help = sentence("Integral gain, of the relative error."),
            .live = true});
    v.real("control.kd", kd_s,
           {.name = sentence("Kd"),
            .unit = "s",
            .minimum = 0,
            .maximum = kMostKd_s,
            .help = sentence("Derivative gain, on the measured stiffness and not on the target."),
            .live = true});
    v.real("control.derivative_filter_s", derivative_filter_s,
           {.name = sentence("Derivative filter"),
            .unit = "s",
            .minimum = 0.001,
            .maximum = 10,
            .help = sentence("Time constant of the derivative's low-pass."),
            .live = true});
    v.real("control.dead_band_N_per_mm", dead_band_N_per_mm,
           {.name = sentence("Dead band"),
            .unit = "N/mm",
            .minimum = 0,
            .maximum = 0.5,
            .help = sentence("Errors of the stiffness up to this are left alone (the thesis, in its own mode, 0.01)."),
            .live = true});
    v.real("control.measurement_lag_s", measurement_lag_s,
           {.name = sentence("Measurement lag"),
            .unit = "s",
            .minimum = 0,
            .maximum = 10,
            .help = sentence(
                "How slowly the measured stiffness follows the true one (time constant); auto-tune measures it."),
            .live = true});
    v.real("control.measurement_delay_s", measurement_delay_s,
           {.name = sentence("Measurement delay"),
            .unit = "s",
            .minimum = 0,
            .maximum = 1,
            .help = sentence("Dead time of the measured stiffness behind the stretch; auto-tune measures it."),
            .live = true});
    v.real("control.noise_correlation_s", noise_correlation_s,
           {.name = sentence("Noise correlation"),
            .unit = "s",
            .minimum = 0.005,
            .maximum = 10,
            .help = sentence("Time over which the measured stiffness' noise repeats itself; auto-tune measures it."),
            .live = true});
    v.real("control.measurement_bias", measurement_bias,
           {.name = sentence("Lasting measurement error"),
            .minimum = 0,
            .maximum = 1,
            .help = sentence("Relative error of the measured stiffness that may last; what is corrected beyond it "
                             "control.correction says."),
            .live = true,
            .before_it_was = 0.0});
    v.choice("control.correction", correction, kCorrectionRuleNames,
             {.name = sentence("Correction"),
              .help = sentence("Of a difference from the law: excess corrects what exceeds the lasting error, bounded "
                               "twice that, at most all of it: never worse than the law alone either way."),
              .live = true,
              .before_it_was = 0});
    v.real(
        "control.correction_limit", correction_limit,
        {.name = sentence("Correction limit"),
         .minimum = 0,
         .maximum = kNoCorrectionLimit,
         .help = sentence("Largest relative correction of the law; a measurement that asks for more contradicts it."),
         .live = true,
         .before_it_was = kNoCorrectionLimit});
    v.real("control.travel_minimum_deg", travel_minimum_deg,
           {.unit = "deg", .minimum = -30, .maximum = 180, .help = sentence("Least stretch the controller commands.")});
    v.real(
        "control.travel_maximum_deg", travel_maximum_deg,
        {.unit = "deg", .minimum = -30, .maximum = 180, .help = sentence("Greatest stretch the controller commands.")});
    v.real(
        "control.rate_limit_deg_per_s", rate_limit_deg_per_s,
        {.name = sentence("Rate limit"),
         .unit = "deg/s",
         .minimum = 1,
         .maximum = 360,
         .help = sentence("Fastest change of the commanded stretch and translation; in mode thesis not of the stretch, "
                          "unless the robot sets it."),
         .live = true});
    v.real("control.motor_limit_deg", motor_limit_deg,
           {.unit = "deg",
            .minimum = 10,
            .maximum = 700,
            .help = sentence(
                "No motor is sent further than this from its zero, whatever stretch and translation add up to.")});
    v.real("control.thesis_kp", thesis_kp,
           {.name = sentence("Thesis kp"),
            .unit = "deg/(N/mm)",
            .minimum = 0,
            .maximum = kMostThesisKp,
            .help = sentence("Proportional gain in thesis mode."),
            .live = true});
    v.real("control.thesis_ki", thesis_ki,
           {.name = sentence("Thesis ki"),
            .unit = "deg/(N/mm)/s",
            .minimum = 0,
            .maximum = kMostThesisKi,
            .help = sentence("Integral gain in thesis mode."),
            .live = true});
    v.real("control.thesis_kd", thesis_kd,
           {.name = sentence("Thesis kd"),
            .unit = "deg/(N/mm)*s",
            .minimum = 0,
            .maximum = kMostThesisKd,
            .help = sentence("Derivative gain in thesis mode (the thesis used none)."),
            .live = true});
    v.real("control.thesis_period_ms", thesis_period_ms,
           {.unit = "ms", .minimum = 1, .maximum = 1000, .help = sentence("Period of the thesis' control law.")});
    v.integer("control.encoder_zero_first_counts", encoder_zero_first_counts,
              {.unit = "counts",
               .minimum = 0,
               .maximum = 4095,
               .help = sentence("First encoder's reading at zero stretch.")});
    v.integer("control.encoder_zero_second_counts", encoder_zero_second_counts,
              {.unit = "counts",
               .minimum = 0,
               .maximum = 4095,
               .help = sentence("Second encoder's reading at zero stretch.")});
    v.boolean("control.encoder_first_inverted", encoder_first_inverted,
              {.help = sentence(
                   "The first encoder counts against its motor's reference (firmware of 2014 and later differ).")});
    v.boolean("control.encoder_second_inverted", encoder_second_inverted,
              {.help = sentence("The second encoder counts against its motor's reference.")});
  }
};

/// Checks that single ranges cannot express: lists of equal length, at least two points, both rising; travel not empty.
/// The message names the parameter and the value. Profiles are checked with this when they are opened.
[[nodiscard]] FYD_API Result<void> checkControlParameters(const ControlParameters& parameters);

}  // namespace fyd::control
