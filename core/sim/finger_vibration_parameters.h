// Parameters of the simulated path from a motor's duty to the finger's acceleration (finger_vibration.h). The defaults
// are assumptions, not measured on hardware.
#pragma once

#include "core/base/parameter.h"

namespace fyd::sim {

struct FingerVibrationParameters {
  double breakaway_percent = 15.0;
  double sliding_share = 0.75;
  double stribeck_deg_s = 6.0;
  double presliding_deg = 0.0;
  double free_speed_deg_s = 207.0;
  double time_constant_ms = 15.0;
  double position_gain = 25.0;
  double second_strength = 0.93;
  double second_friction = 1.15;
  double roller_radius_mm = 10.0;
  double backlash_deg = 1.0;
  double tension_percent = 4.0;
  double resonance_Hz = 70.0;
  double damping = 0.3;
  double resonance_Hz_per_deg = 0.5;
  double finger_loading = 0.15;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("sim.vibration_breakaway_percent", breakaway_percent,
           {.unit = "%", .minimum = 0, .maximum = 60, .help = "Duty below which the vibrating motors stand still."});
    v.real("sim.vibration_sliding_share", sliding_share,
           {.minimum = 0.1, .maximum = 1, .help = "Friction of a turning motor over its breakaway."});
    v.real("sim.vibration_stribeck_deg_s", stribeck_deg_s,
           {.unit = "°/s",
            .minimum = 0.01,
            .maximum = 500,
            .help = "Speed at which friction has fallen from breakaway to sliding (Stribeck)."});
    v.real("sim.vibration_presliding_deg", presliding_deg,
           {.unit = "°",
            .minimum = 0,
            .maximum = 0.5,
            .help = "How far the gear gives like a spring before it slides; 0: it sticks."});
    v.real("sim.vibration_free_speed_deg_s", free_speed_deg_s,
           {.unit = "°/s", .minimum = 10, .maximum = 5000, .help = "Speed at full duty without load."});
    v.real("sim.vibration_time_constant_ms", time_constant_ms,
           {.unit = "ms", .minimum = 1, .maximum = 200, .help = "Time constant of the vibrating motors."});
    v.real("sim.vibration_position_gain", position_gain,
           {.unit = "%/°", .minimum = 0, .maximum = 200, .help = "Gain of the board's position loop beside it."});
    v.real("sim.vibration_second_strength", second_strength,
           {.minimum = 0, .maximum = 2, .help = "Torque of the second motor over the first's; 0: it is dead."});
    v.real("sim.vibration_second_friction", second_friction,
           {.minimum = 0, .maximum = 4, .help = "Friction of the second motor over the first's."});
    v.real("sim.vibration_roller_radius_mm", roller_radius_mm,
           {.unit = "mm", .minimum = 1, .maximum = 100, .help = "Radius of the rollers, cloth included."});
    v.real("sim.vibration_backlash_deg", backlash_deg,
           {.unit = "°", .minimum = 0, .maximum = 10, .help = "Play of a gear, closed by the cloth's tension."});
    v.real("sim.vibration_tension_percent", tension_percent,
           {.unit = "%",
            .minimum = 0,
            .maximum = 50,
            .help = "Duty that holds the cloth's tension at a stretch of 45°; 0: slack, the play is open."});
    v.real("sim.vibration_resonance_Hz", resonance_Hz,
           {.unit = "Hz",
            .minimum = 5,
            .maximum = 400,
            .help = "Resonance of the cloth with a finger of 1 N on it, at a stretch of 45°."});
    v.real("sim.vibration_damping", damping, {.minimum = 0.02, .maximum = 2, .help = "Its damping ratio."});
    v.real("sim.vibration_resonance_Hz_per_deg", resonance_Hz_per_deg,
           {.unit = "Hz/°", .minimum = -5, .maximum = 5, .help = "How much a degree of stretch moves it."});
    v.real("sim.vibration_finger_loading", finger_loading,
           {.minimum = 0,
            .maximum = 1,
            .help = "How much a heavier finger lowers it: the exponent of 1 N over the force."});
  }
};

}  // namespace fyd::sim
