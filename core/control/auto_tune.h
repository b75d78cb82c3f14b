// Proposes PID gains from a recorded safe excitation. It never applies them; the operator does.
//
// Identified model: cloth_identification.h. The controller's observer compensates the measurement's lag and noise
// (stiffness_controller.h), so the PID sees only the motors' lag M [Rivera 1986]:
//
//   ki = 1/(max(1, g)·λ),   kp = kMotorLag_s·ki,   kd = 0
//
// with the closed loop's time constant λ ≥ 0.2 s the smallest for which the gain margin is ≥ 2 and the phase margin
// ≥ 60°, also with ±30 % of g, ±30 % of the lag and 50 ms more dead time.
// Stability: may change
#pragma once

#include <functional>
#include <span>

#include "core/base/api.h"
#include "core/control/loop_prediction.h"

namespace fyd::control {

struct TuneProposal {
  IdentifiedCloth cloth;
  ControlParameters
      proposed;           ///< the present parameters with kp, ki, kd and what was identified of the sensors replaced
  LoopPrediction before;  ///< with the present parameters, in mode default
  LoopPrediction after;   ///< with the proposed ones
};

/// Called now and then with the completed share of the work, 0…1; returning false cancels it.
using TuneProgress = std::function<bool(double done)>;

/// @param progress empty: no reports, no cancelling
/// @return the errors of identifyCloth, that no λ up to 10 s keeps the margins, or that `progress` ended it
[[nodiscard]] FYD_API Result<TuneProposal> proposeGains(std::span<const TuneSample> recording,
                                                        const ControlParameters& present,
                                                        const TuneProgress& progress = {});

}  // namespace fyd::control
