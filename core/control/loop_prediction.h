// What the stiffness loop would do with a set of gains, before anybody feels it.
//
// Margins: of the loop in default mode, linear in logarithms,
//
//   L(s) = (kp + ki/s + kd·s/(Tf·s + 1))·M(s)·(1 + O(s)·(g·G(s) − Ĝ(s)))
//   G = e^(−Ts)/(τs + 1),   M = 1/(0.03 s + 1),   O = K/(s + K),  K = 1/(2·Tc)
//
// with G the identified measurement, Ĝ the controller's own model of it (control.measurement_*), M the motors and O
// the observer of the fabric's scale at the quickest it learns once a touch has begun.
// Overshoot and settling: the controller itself, run on the identified model with motors at the rate limit, on a cloth
// 30 % softer than the law says: the case that the loop and not the feed-forward carries.
#pragma once

#include "core/control/control_parameters.h"
#include "core/control/fabric_identification.h"

namespace fyd::control {

struct LoopMargins {
  double gain_margin = 0.0;       ///< factor; infinite when the phase never crosses −180°
  double phase_margin_deg = 0.0;  ///< 180 when the loop gain never reaches 1
};

struct LoopPrediction {
  LoopMargins margins;
  double overshoot_percent = 0.0;  ///< of the target
  double settling_s = 0.0;         ///< into ±5 % of the target for good; NaN: not within 10 s
  bool stable = false;             ///< both margins positive and the run settles
};

inline constexpr double kMotorLag_s = 0.03;

[[nodiscard]] LoopMargins loopMargins(const IdentifiedFabric& fabric, const ControlParameters& parameters);
[[nodiscard]] LoopPrediction predictLoop(const IdentifiedFabric& fabric, const ControlParameters& parameters);

}  // namespace fyd::control
