// Two desktop arms, a hand that follows a recording, a network and perhaps a wall, in virtual time: the same run gives
// the same figures to the bit. Real sockets: teleop_end.h takes any.
#pragma once

#include <vector>

#include "core/sim/network_emulator.h"
#include "core/sim/teleop_end.h"
#include "core/teleop/prediction_trial.h"

namespace fyd::sim {

struct TeleopRunSettings {
  double period_ms = 10.0;  ///< 1 … 10 000, of messages both ways
  NetworkProfile path;      ///< forward: from the hand
  teleop::PredictorChoice predictor = teleop::PredictorChoice::experts;
  teleop::CouplingChoice coupling = teleop::CouplingChoice::model;
  double smooth_ms = 15.0;
  double wall_N_per_m = 0.0;  ///< across the middle of the first axis; 0: none
};

/// @return an error that names the value and its range
[[nodiscard]] Result<void> checkTeleopRun(const TeleopRunSettings& settings);

struct TeleopRow {
  double t_s = 0.0;
  teleop::Position hand_mm{}, far_mm{}, wanted_mm{};  ///< the devices, and where the far end believes the hand to be
  double hand_force_N = 0.0, far_force_N = 0.0;       ///< along the first axis: felt, and of the wall
};

/// What is not known (nothing moved, no wall) is NaN.
struct TeleopFigures {
  double seconds = 0.0;
  double scale = 1.0;                                   ///< of the recording, to fit the workspace
  double linked_share = 0.0;                            ///< of the ticks, at the far end
  double rms_error_mm = 0.0, max_error_mm = 0.0;        ///< far device − hand, now
  double believed_rms_mm = 0.0, believed_max_mm = 0.0;  ///< where the far end believes the hand to be − hand
  double added_delay_ms = 0.0;                          ///< by which the far device's motion fits the hand's best
  double jerk_ratio = 0.0, vibration_ratio = 0.0, largest_step_mm = 0.0;  ///< of the far device, as of `fyd predict`
  double orientation_rms_deg = 0.0, orientation_held_rms_deg = 0.0;       ///< predicted, and held
  double least_energy_J = 0.0, energy_J = 0.0,
         dissipated_J = 0.0;              ///< put in by the hand: least, at the end; by couplings
  double drag_N = 0.0;                    ///< mean of the hand's felt force while nothing is touched
  double packets_per_s = 0.0;             ///< one way, from the hand
  double message_bits = 0.0;              ///< longest, with IPv4 and UDP headers
  double deadband_packets_percent = 0.0;  ///< of the steps, at 10 % on the far force; against one a step
  double deadband_worst = 0.0;            ///< error / band wherever the hand's end knows the force; over the same path
};

/// @param rows takes a row a millisecond; null: not kept
[[nodiscard]] TeleopFigures runTeleop(const teleop::Trace& trace, const TeleopRunSettings& settings,
                                      std::vector<TeleopRow>* rows);

}  // namespace fyd::sim
