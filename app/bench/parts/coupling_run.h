// Simulation of a hand, two devices, a network and a wall, for the bench of couplings. Its mechanics share no formula
// with core/teleop.
#pragma once

#include <cstdint>
#include <vector>

#include "core/teleop/coupling/coupling.h"
#include "core/teleop/coupling/coupling_choice.h"

namespace fyd::bench {

/// Press, release, press again.
struct CouplingRun {
  double delay_s = 0.0;   ///< one way
  double jitter_s = 0.0;  ///< additional delay, uniform from 0 to this; messages may overtake each other
  double loss = 0.2;      ///< share of the messages
  double wall_N_per_m = 500.0;
  double hand_kg = 1.0;
  double hand_N_s_per_m = 5.0;
  double hand_N_per_m = 300.0;  ///< stiffness between the hand and its target position
  std::uint64_t seed = 1;
};

[[nodiscard]] CouplingRun drawCouplingRun(std::uint64_t seed);

struct CouplingRow {
  double t_s, hand_m, hand_m_per_s, hand_N, far_m, far_N;
};

struct CouplingFigures {
  double least_energy_J = 0.0;  ///< minimum over time of the energy put in by the hand
  double oscillation_mm = 0.0;  ///< peak to peak, last second of the first press
  double rest_difference_mm = 0.0;
  double drag_N = 0.0;      ///< largest in free motion
  double felt_share = 0.0;  ///< of the wall's stiffness, second press
  double dissipated_J = 0.0;
  bool unstable = false;  ///< swings by more than 20 mm, or gave back more than 0.1 J
  [[nodiscard]] bool good() const {
    return least_energy_J >= -1e-3 && oscillation_mm <= 0.5 && rest_difference_mm <= 0.5 && drag_N <= 0.3 &&
           felt_share >= 0.9 && felt_share <= 1.1;
  }
};

/// @param rows takes a row a millisecond; null: not kept
[[nodiscard]] CouplingFigures simulate(const CouplingRun& run, teleop::CouplingChoice choice,
                                       std::vector<CouplingRow>* rows);

}  // namespace fyd::bench
