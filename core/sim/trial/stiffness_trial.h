// One trial of the stiffness loop in virtual time: a finger presses and holds, the motors start at rest, a target is
// set, and the whole chain (sensors with noise and delay, pipeline, motors with friction and speed limit) controls to
// it. The result is judged by the cloth's true stiffness, which no sensor of the chain measures.
#pragma once

#include <vector>

#include "core/control/auto_tune.h"
#include "core/pipeline/parameters.h"
#include "core/sim/sim_parameters.h"

namespace fyd::sim {

struct StiffnessTrial {
  pipeline::Parameters parameters;
  SimParameters sim;
  double target_N_per_mm = 0.6;
  double x_mm = 0.0;  ///< where the finger presses
  double y_mm = 0.0;
  double press_mm = 6.0;
  double duration_s = 8.0;  ///< from the moment the motors are engaged
};

struct TrialPoint {
  double time_s = 0.0;
  double true_N_per_mm = 0.0;
  double measured_N_per_mm = 0.0;  ///< NaN while not observable
  double stretch_deg = 0.0;        ///< of the rollers, true
};

struct TrialResult {
  double settling_s = 0.0;                 ///< into ±5 % of the target for good; NaN: not within the trial
  double overshoot_percent = 0.0;          ///< largest excess beyond the target, seen from the start, of the target
  double steady_error_percent = 0.0;       ///< mean distance from the target over the last quarter, of the target
  bool stable = false;                     ///< bounded and not oscillating, wherever it came to rest (see isStable)
  bool target_clamped = false;             ///< the pipeline reported at the end that the target is out of reach
  double reachable_target_N_per_mm = 0.0;  ///< reachable target as reported by the controller
  bool at_limit = false;                   ///< the stretch ended at an end of its travel
  bool reachable = false;                  ///< the true cloth gives the target, here and this deep, within that travel
  double final_true_N_per_mm = 0.0;        ///< mean over the last quarter
  double final_stretch_deg = 0.0;          ///< mean over the last quarter
  double stretch_swing_deg = 0.0;          ///< highest less lowest over the last quarter
};

/// @param course when given: one point per millisecond
[[nodiscard]] TrialResult runTrial(const StiffnessTrial& trial, std::vector<TrialPoint>* course = nullptr);

/// Finite, and in the second half of the course no more than three swings up or down larger than 3 % of its mean.
[[nodiscard]] bool isStable(const std::vector<double>& stiffness_N_per_mm);

/// The safe excitation of auto-tune on the same chain, as the sensors measured it.
/// @param progress called ten times a virtual second; false ends the excitation early
[[nodiscard]] std::vector<control::TuneSample> recordExcitation(const StiffnessTrial& trial,
                                                                const control::TuneProgress& progress = {});

/// Sets the mode `thesis` with the thesis' own static law: the behaviour of the pipeline of 2014 with these gains.
void useThesisController(control::ControlParameters& parameters);
/// Factor on the noise of distance sensors, load cell and camera, within the simulation's ranges.
void scaleNoise(SimParameters& sim, double factor);
/// The same dead time in every sensor: distance, load cell, encoders, camera.
void delaySensors(SimParameters& sim, double delay_ms);

}  // namespace fyd::sim
