// Two desktop arms, a hand that follows a recording, a network and perhaps a wall, in virtual time: the same run gives
// the same figures to the bit. Real sockets: teleop_end.h takes any.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "core/sim/network/network_emulator.h"
#include "core/sim/teleop/teleop_end.h"
#include "core/teleop/coupling/coupling_choice.h"
#include "core/teleop/prediction/prediction_trial.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::sim {

struct TeleopRunSettings {
  double period_ms = 10.0;  ///< 1 … 10 000, of messages both ways
  NetworkProfile path;      ///< forward: from the hand
  teleop::PredictorChoice predictor = teleop::PredictorChoice::experts;
  teleop::CouplingChoice coupling = teleop::CouplingChoice::model;
  std::optional<double> smooth_ms;  ///< none: by period and delay (core/teleop/prediction/smooth_output.h)
  double wall_N_per_m = 0.0;        ///< across the middle of the first axis; 0: none
  double deadband_percent = 0.0;    ///< 0 … 100, what an end does not send (teleop_end.h); 0: a message each period
};

/// @return an error that names the value and its range
[[nodiscard]] Result<void> checkTeleopRun(const TeleopRunSettings& settings);

/// Of a run, which keeps each millisecond of it in memory.
inline constexpr double kLongestRun_s = 3600.0;

struct TeleopRow {
  double t_s = 0.0;
  teleop::Position hand_mm{}, far_mm{}, wanted_mm{};  ///< the devices, and the hand as predicted at the far end
  double hand_force_N = 0.0, far_force_N = 0.0;       ///< along the first axis: felt, and of the wall
  /// With a deadband, along the first axis: this moment's values as the other end knew them kQueryDelay_s later; else
  /// NaN.
  double told_x_mm = std::numeric_limits<double>::quiet_NaN();        ///< the far end, of the hand
  double told_x_mm_per_s = std::numeric_limits<double>::quiet_NaN();  ///< its speed, as it was sent
  double told_force_N = std::numeric_limits<double>::quiet_NaN();     ///< the hand's end, of the wall
};
/// Plus the delay of the path.
inline constexpr double kQueryDelay_s = 0.15;

/// Figures that cannot be computed (never linked, nothing moved, no wall, no row that is no gap) are NaN.
struct TeleopFigures {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  double seconds = 0.0;
  double scale = 1.0;                                             ///< of the recording, to fit the workspace
  double linked_share = kUnknown;                                 ///< of the ticks, at the far end
  double rms_error_mm = kUnknown;                                 ///< far device − hand, now, since the first link
  double max_error_mm = kUnknown;                                 ///< likewise
  double believed_rms_mm = kUnknown, believed_max_mm = kUnknown;  ///< the hand as predicted at the far end − hand
  double added_delay_ms = kUnknown;  ///< shift at which the far device's motion fits the hand's best
  double jerk_ratio = kUnknown, vibration_ratio = kUnknown, largest_step_mm = kUnknown;  ///< as of `fyd predict`
  double orientation_rms_deg = kUnknown, orientation_held_rms_deg = kUnknown;            ///< predicted, and held
  double least_energy_J = kUnknown, energy_J = kUnknown,
         dissipated_J = kUnknown;  ///< put in by the hand: least, at the end; by couplings
  double drag_N = kUnknown;        ///< mean of the hand's felt force while nothing is touched
  double packets_per_s = kUnknown, back_packets_per_s = kUnknown;  ///< from the hand, and to it (force)
  double packets_without_per_s = kUnknown;                         ///< a message each period, either way
  double message_bits = 0.0;                                       ///< longest, with IPv4 and UDP headers
  /// With a deadband, of the moments at which both ends were linked; along the first axis.
  double told_share = kUnknown, told_force_share = kUnknown;          ///< known kQueryDelay_s later
  double deadband_worst = kUnknown, deadband_force_worst = kUnknown;  ///< error / band, where known
};

/// @param trace of kLongestRun_s at most
/// @param rows takes a row a millisecond; null: not kept
[[nodiscard]] TeleopFigures runTeleop(const teleop::Trace& trace, const TeleopRunSettings& settings,
                                      std::vector<TeleopRow>* rows);

}  // namespace fyd::sim
