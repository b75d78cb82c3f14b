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
           {.unit = "%",
            .minimum = 0,
            .maximum = 60,
            .help = "Static friction of the vibrating motors: the duty below which they stand still."});
    v.real("sim.vibration_sliding_share", sliding_share,
           {.minimum = 0.1,
            .maximum = 1,
            .help = "Friction of a turning motor divided by its static friction; with less, it turns more easily once "
                    "it moves."});
    v.real("sim.vibration_stribeck_deg_s", stribeck_deg_s,
           {.unit = "°/s",
            .minimum = 0.01,
            .maximum = 500,
            .help = "Stribeck speed: by about this speed, friction has fallen from static to sliding."});
    v.real("sim.vibration_presliding_deg", presliding_deg,
           {.unit = "°",
            .minimum = 0,
            .maximum = 0.5,
            .help = "Angle by which the gear yields like a spring before it slides; 0: it does not yield."});
    v.real("sim.vibration_free_speed_deg_s", free_speed_deg_s,
           {.unit = "°/s",
            .minimum = 10,
            .maximum = 5000,
            .help = "Speed of a vibrating motor at full duty without load."});
    v.real("sim.vibration_time_constant_ms", time_constant_ms,
           {.unit = "ms",
            .minimum = 1,
            .maximum = 200,
            .help = "Time constant of a vibrating motor's speed; with more, it follows the duty more slowly."});
    v.real("sim.vibration_position_gain", position_gain,
           {.unit = "%/°",
            .minimum = 0,
            .maximum = 200,
            .help =
                "Gain of the board's position loop, which acts besides the vibration: duty for each degree of error."});
    v.real("sim.vibration_second_strength", second_strength,
           {.minimum = 0,
            .maximum = 2,
            .help = "Torque of the second motor divided by the first's; 0: the second gives none."});
    v.real("sim.vibration_second_friction", second_friction,
           {.minimum = 0, .maximum = 4, .help = "Friction of the second motor divided by the first's."});
    v.real("sim.vibration_roller_radius_mm", roller_radius_mm,
           {.unit = "mm", .minimum = 1, .maximum = 100, .help = "Radius of the rollers with the cloth on them."});
    v.real("sim.vibration_backlash_deg", backlash_deg,
           {.unit = "°", .minimum = 0, .maximum = 10, .help = "Backlash of each gear; the cloth's tension closes it."});
    v.real("sim.vibration_tension_percent", tension_percent,
           {.unit = "%",
            .minimum = 0,
            .maximum = 50,
            .help = "Duty that balances the cloth's tension at a stretch of 45°; 0: the cloth is slack and the "
                    "backlash open."});
    v.real("sim.vibration_resonance_Hz", resonance_Hz,
           {.unit = "Hz",
            .minimum = 5,
            .maximum = 400,
            .help = "Resonance frequency of the cloth at a stretch of 45° while a finger presses it with 1 N."});
    v.real("sim.vibration_damping", damping,
           {.minimum = 0.02,
            .maximum = 2,
            .help = "Damping ratio of the cloth's resonance; with more, vibration near it is weaker."});
    v.real("sim.vibration_resonance_Hz_per_deg", resonance_Hz_per_deg,
           {.unit = "Hz/°",
            .minimum = -5,
            .maximum = 5,
            .help = "Change of the resonance frequency for each degree of stretch."});
    v.real("sim.vibration_finger_loading", finger_loading,
           {.minimum = 0,
            .maximum = 1,
            .help = "How much a firmer press lowers the resonance frequency, which is multiplied by (1 N / force) to "
                    "the power of this; 0: not at all."});
  }
};

}  // namespace fyd::sim
