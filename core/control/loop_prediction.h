// Predicts the stiffness loop's behaviour with a set of gains, before they are used.
//
// Margins: of the loop in default mode, linear in logarithms,
//
//   L(s) = (kp + ki/s + kd·s/(Tf·s + 1))·M(s)·(1 + O(s)·(g·G(s) − Ĝ(s)))
//   G = e^(−Ts)/(τs + 1),   M = 1/(0.03 s + 1),   O = K/(s + K),  K = 1/(2·Tc)
//
// with G the identified measurement, Ĝ the controller's own model of it (control.measurement_*), M the motors and O
// the observer of the cloth's scale at the highest rate at which it learns once a touch has begun.
// Step response and its figures: the controller itself, run on the identified model with motors at the rate limit, on a
// cloth 30 % softer than the law says, so that the loop and not the feed-forward does the work. The model's measurement
// is right on average, so control.measurement_bias counts as 0.
#pragma once

#include <vector>

#include "core/control/cloth_identification.h"
#include "core/control/control_parameters.h"

namespace fyd::control {

struct LoopMargins {
  double gain_margin = 0.0;       ///< factor; infinite when the phase never crosses −180°
  double phase_margin_deg = 0.0;  ///< 180 when the loop gain never reaches 1
};

struct LoopPrediction {
  LoopMargins margins;
  double rise_s = 0.0;                ///< from 10 % to 90 % of the way to the target; NaN: not within 10 s
  double overshoot_percent = 0.0;     ///< of the target
  double settling_s = 0.0;            ///< into ±5 % of the target for good; NaN: not within 10 s
  double steady_error_percent = 0.0;  ///< mean distance from the target over the last 2 s, of the target
  bool stable = false;                ///< both margins positive and the run settles
};

/// One instant of the run.
struct LoopPoint {
  double time_s = 0.0;
  double relative = 0.0;     ///< stiffness of the cloth as a share of the target; 1: target reached
  double stretch_deg = 0.0;  ///< of the rollers
};

inline constexpr double kMotorLag_s = 0.03;

[[nodiscard]] LoopMargins loopMargins(const IdentifiedCloth& cloth, const ControlParameters& parameters);
/// @param course when given: receives the run, one point every 10 ms
[[nodiscard]] LoopPrediction predictLoop(const IdentifiedCloth& cloth, const ControlParameters& parameters,
                                         std::vector<LoopPoint>* course = nullptr);

/// Model from the parameters alone, for use before an excitation was recorded: the law holds exactly, and the
/// measurement has the lag, delay and noise that the parameters state.
[[nodiscard]] IdentifiedCloth assumedCloth(const ControlParameters& parameters);

}  // namespace fyd::control
