// Proposes PID gains from a recorded safe excitation. Proposes only: applying them is the operator's own act.
//
// Identified model: fabric_identification.h. Gains by internal-model tuning (Rivera, Morari and Skogestad 1986): the
// controller compensates the measurement's lag itself, so what is left for the PID is the motors' lag M and the gain g,
//
//   ki = 1/(g·λ),   kp = kMotorLag_s·ki,   kd = 0
//
// with the closed loop's time constant λ ≥ 0.35 s the smallest for which the gain margin is ≥ 2 and the phase margin
// ≥ 60° also with ±30 % of g, with ±30 % of the lag and with 50 ms more dead time, and for which the noise seen in the
// recording moves the stiffness by less than 1 % RMS.
#pragma once

#include <span>

#include "core/control/loop_prediction.h"

namespace fyd::control {

struct TuneProposal {
  IdentifiedFabric fabric;
  ControlParameters proposed;  ///< the present parameters with kp, ki, kd, measurement lag and delay replaced
  LoopPrediction before;       ///< with the present parameters
  LoopPrediction after;        ///< with the proposed ones
};

/// @return the errors of identifyFabric, or that no λ up to 10 s keeps the margins
[[nodiscard]] Result<TuneProposal> proposeGains(std::span<const TuneSample> recording,
                                                const ControlParameters& present);

}  // namespace fyd::control
