// Predicts the stiffness loop's behaviour with a set of gains, before they are used.
//
// Margins: of the loop that the parameters' mode closes. Mode default, linear in logarithms:
//
//   L(s) = (kp + ki/s + kd·s/(Tf·s + 1))·M(s)·e^(−Ta·s)·(1 + O(s)·(g·G(s) − Ĝ(s)))
//   G = e^(−Ts)/(τs + 1),   M = 1/(0.015 s + 1)²,   O = K/(s + K),  K = 1/(2·Tc)
//
// with G the identified measurement, Ĝ the controller's own model of it (control.measurement_*), M the motors (gear and
// position loop, 0.015 s each), Ta the time from the encoders through the step to the motors (LoopTiming), and O the
// observer of the cloth's scale at the highest rate at which it learns once a touch has begun. Mode thesis: the PID acts
// on the measurement itself, in degrees for N/mm, and holds its output for a period P:
//
//   L(s) = (kp + ki/s + kd·s/(Tf·s + 1))·g·(steepest dk/dθ of the law)·G(s)·M(s)·e^(−(Ta + P/2)·s)
//
// There is always dead time, so a loop with any gain has a finite gain margin.
// Step response and its figures: the controller itself, run on the identified model with that dead time and motors that
// reach 180°/s, on a cloth 30 % softer than the law says, so that the loop and not the feed-forward does the work. The
// model's measurement is right on average, so control.measurement_bias counts as 0, and as that cloth
// does not contradict the law, control.correction_limit as none.
// Stability: may change
#pragma once

#include <vector>

#include "core/base/api.h"
#include "core/control/cloth_identification.h"
#include "core/control/control_parameters.h"

namespace fyd::control {

/// What delays the loop and stands in no parameter of the control.
struct LoopTiming {
  /// Mean age of the encoders' reading when a step uses it; a command waits as long for the motors' next exchange.
  /// Without a measured one: half an exchange at 250 Hz.
  double motors_age_s = 0.002;
  /// Ta: reading and command, and the step that holds its command.
  [[nodiscard]] double deadTime_s() const { return 2 * motors_age_s + kStep_s; }
  static constexpr double kStep_s = 0.001;
};

struct LoopMargins {
  double gain_margin = 0.0;       ///< factor; infinite only without any gain
  double phase_margin_deg = 0.0;  ///< 180 when the loop gain never reaches 1
};

enum class LoopVerdict : std::uint8_t {
  settles,
  rings,            ///< settles after more than three swings of 1.5° or more
  does_not_settle,  ///< neither within ±5 % after 10 s nor swinging: too weak
  unstable,         ///< a margin is used up, or the stretch still swings after 5 s
};

struct LoopPrediction {
  LoopMargins margins;
  double rise_s = 0.0;                ///< from 10 % to 90 % of the way to the target; NaN: not within 10 s
  double overshoot_percent = 0.0;     ///< of the target
  double settling_s = 0.0;            ///< into ±5 % of the target for good; NaN: not within 10 s
  double steady_error_percent = 0.0;  ///< mean distance from the target over the last 2 s, of the target
  LoopVerdict verdict = LoopVerdict::does_not_settle;
  [[nodiscard]] bool stable() const { return verdict == LoopVerdict::settles || verdict == LoopVerdict::rings; }
};

/// One instant of the run.
struct LoopPoint {
  double time_s = 0.0;
  double relative = 0.0;     ///< stiffness of the cloth as a share of the target; 1: target reached
  double stretch_deg = 0.0;  ///< of the rollers
};

inline constexpr double kMotorLag_s = 0.03;  ///< of the motors in all

[[nodiscard]] FYD_API LoopMargins loopMargins(const IdentifiedCloth& cloth, const ControlParameters& parameters,
                                              const LoopTiming& timing = {});
/// @param course when given: receives the run, one point every 10 ms
[[nodiscard]] FYD_API LoopPrediction predictLoop(const IdentifiedCloth& cloth, const ControlParameters& parameters,
                                                 const LoopTiming& timing = {},
                                                 std::vector<LoopPoint>* course = nullptr);

/// Model from the parameters alone, for use before an excitation was recorded: the law holds exactly, and the
/// measurement has the lag, delay and noise that the parameters state.
[[nodiscard]] FYD_API IdentifiedCloth assumedCloth(const ControlParameters& parameters);

}  // namespace fyd::control
