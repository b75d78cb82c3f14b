// Proposes PID gains from a recorded safe excitation. Proposes only: applying them is the operator's own act.
//
// Identified model: fabric_identification.h. The controller takes the measurement's lag and noise off with its observer
// (stiffness_controller.h), so what is left for the PID is the motors' lag M (Rivera, Morari and Skogestad 1986):
//
//   ki = 1/(max(1, g)·λ),   kp = kMotorLag_s·ki,   kd = 0
//
// with the closed loop's time constant λ ≥ 0.2 s the smallest for which the gain margin is ≥ 2 and the phase margin
// ≥ 60°, also with ±30 % of g, ±30 % of the lag and 50 ms more dead time.
#pragma once

#include <functional>
#include <span>

#include "core/control/loop_prediction.h"

namespace fyd::control {

struct TuneProposal {
  IdentifiedFabric fabric;
  ControlParameters
      proposed;           ///< the present parameters with kp, ki, kd and what was identified of the sensors replaced
  LoopPrediction before;  ///< with the present parameters
  LoopPrediction after;   ///< with the proposed ones
};

/// Asked now and then with the share of the work that is done; false ends it.
using TuneProgress = std::function<bool(double done)>;

/// @param progress empty: the work goes on to its end
/// @return the errors of identifyFabric, that no λ up to 10 s keeps the margins, or that `progress` ended it
[[nodiscard]] Result<TuneProposal> proposeGains(std::span<const TuneSample> recording, const ControlParameters& present,
                                                const TuneProgress& progress = {});

}  // namespace fyd::control
