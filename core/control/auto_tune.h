// Identifies fabric and measurement from a recorded excitation and proposes PID gains. Proposes only: applying them
// is the operator's own act.
//
// Model of what the controller sees, in logarithms (see stiffness_controller.h):
//
//   ln k̂(t) = ln S + g·[ ln law(θ) through a dead time T and one time constant τ ](t) + noise
//
// S: fabric scale; g: 1 when the law's shape holds on this fabric. T and τ by search, S and g by least squares.
// Gains by internal-model tuning with closed-loop time constant λ (Rivera, Morari, Skogestad 1986), λ the smallest
// for which both margins hold: gain margin ≥ 2, phase margin ≥ 60°, with ±30 % of g and 50 ms more dead time.
#pragma once

#include <span>

#include "core/base/error.h"
#include "core/control/control_parameters.h"

namespace fyd::control {

/// One instant of the excitation, rising in time.
struct TuneSample {
  double time_s = 0.0;
  double angle_deg = 0.0;           ///< commanded or measured stretch
  double stiffness_N_per_mm = 0.0;  ///< measured; NaN while not observable
};

struct IdentifiedFabric {
  double scale = 1.0;                  ///< S
  double shape_gain = 1.0;             ///< g
  double delay_s = 0.0;                ///< T
  double lag_s = 0.0;                  ///< τ
  double slope_N_per_mm_deg = 0.0;     ///< mean dk/dθ over the excited span
  double residual_rms_relative = 0.0;  ///< of the fit; noise of k̂ when the model holds
};

/// What the loop would do with a set of gains, computed on the identified model.
struct LoopPrediction {
  double overshoot_percent =
      0.0;                   ///< of a fabric 30 % off the law, the case the loop (and not the feed-forward) carries
  double settling_s = 0.0;   ///< into ±5 % of the target, same case; NaN: never within 20 s
  double gain_margin = 0.0;  ///< factor; infinite when the phase never crosses
  double phase_margin_deg = 0.0;
  bool stable = false;
};

struct TuneProposal {
  IdentifiedFabric fabric;
  ControlParameters proposed;  ///< the present parameters with kp, ki, kd, measurement lag and delay replaced
  LoopPrediction before;       ///< with the present gains
  LoopPrediction after;        ///< with the proposed gains
};

/// @return an error that says what the recording lacks: too few samples, time not rising, too little excitation
///         (the stretch must move the law by at least 5 %), or a fit too poor to tune on
[[nodiscard]] Result<TuneProposal> proposeGains(std::span<const TuneSample> recording,
                                                const ControlParameters& present);

/// The prediction alone, for gains tried by hand.
[[nodiscard]] LoopPrediction predictLoop(const IdentifiedFabric& fabric, const ControlParameters& parameters);

}  // namespace fyd::control
