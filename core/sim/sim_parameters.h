// Parameters of the simulated touchpad, its camera and the simulated robot arm. The defaults are a well-behaved
// device; options for spread, hysteresis, friction, delays and noise make it harder to control and measure, for tests.
#pragma once

#include <array>
#include <string_view>

#include "core/base/parameter.h"
#include "core/sim/cloth_kind.h"
#include "core/sim/finger_vibration_parameters.h"
#include "core/sim/material.h"

namespace fyd::sim {

struct SimParameters {
  int seed = 1;

  // cloth and finger
  ClothKind cloth = ClothKind::membrane;
  FingerKind finger = FingerKind::sphere;
  double cloth_stiffness_scale = 1.0;
  double cloth_slackens_percent_per_min = 0.0;
  double cloth_hysteresis = 0.0;
  double cloth_viscosity_ms = 0.0;
  double cloth_height_mm = 100.0;

  // motors
  double initial_angle_deg = 20.0;
  double motor_speed_limit_deg_s = 180.0;
  double motor_current_limit_mA = 1200.0;
  double motor_friction_percent = 3.0;
  bool reports_position_duty = false;
  FingerVibrationParameters vibration;

  // sensors
  double ir_noise_mV = 10.0;
  double ir_period_ms = 16.5;
  double ir_delay_ms = 0.0;
  double bridge_noise_mV_per_V = 0.0005;
  double bridge_offset_mV_per_V = 0.0;
  double bridge_rate_Hz = 122.0;
  double bridge_delay_ms = 0.0;
  double encoder_delay_ms = 0.0;

  // camera
  double camera_rate_Hz = 30.0;
  double camera_delay_ms = 0.0;
  double camera_noise = 2.0;
  double camera_vignette = 0.20;
  double light = 1.0;
  double light_gradient = 0.0;
  double edge_softness_px = 1.5;

  // robot
  Material material = Material::rubber;
  double material_stiffness_N_per_mm = 0.0;
  double robot_speed_limit_mm_s = 250.0;
  double robot_stiffness_N_per_mm = 1.0;
  double accelerometer_noise_g = 0.004;
  double accelerometer_range_g = 5.0;

  template <class Visitor>
  void describe(Visitor& v) {
    v.integer("sim.seed", seed,
              {.minimum = 0, .maximum = 1e9, .help = "Seed of all random numbers of the simulation."});
    v.choice("sim.cloth", cloth, kClothNames,
             {.help = "Which cloth is simulated: held on four sides (membrane) or by two rollers (rollers), both "
                      "solved for large strain, or given by the estimator's own formula (ideal).",
              .before_it_was = 0});
    v.choice("sim.finger", finger, kFingerNames,
             {.help = "Shape of the finger that presses the cloth: a sphere of 8 mm radius, a tilted capsule or a flat "
                      "disc. An ideal cloth ignores it."});
    v.real("sim.cloth_stiffness_scale", cloth_stiffness_scale,
           {.minimum = 0.7,
            .maximum = 1.3,
            .help = "Stiffness of the cloth divided by that of the nominal cloth; more is stiffer.",
            .formerly = "sim.fabric_stiffness_scale"});
    v.real("sim.cloth_slackens_percent_per_min", cloth_slackens_percent_per_min,
           {.unit = "%/min",
            .minimum = 0,
            .maximum = 600,
            .help = "Share of its stiffness that the cloth loses each minute, until a third is left.",
            .formerly = "sim.fabric_slackens_percent_per_min"});
    v.real(
        "sim.cloth_hysteresis", cloth_hysteresis,
        {.minimum = 0,
         .maximum = 0.3,
         .help =
             "Hysteresis of the cloth: share of the force that is added while pressing and missing while letting go.",
         .formerly = "sim.fabric_hysteresis"});
    v.real("sim.cloth_viscosity_ms", cloth_viscosity_ms,
           {.unit = "ms",
            .minimum = 0,
            .maximum = 100,
            .help = "Viscosity of the cloth divided by its stiffness; with more, a fast press meets more force than a "
                    "slow one.",
            .formerly = "sim.fabric_viscosity_ms"});
    v.real(
        "sim.cloth_height_mm", cloth_height_mm,
        {.unit = "mm", .minimum = 60, .maximum = 150, .help = "Height of the untouched cloth above the IR sensors."});
    v.real("sim.initial_angle_deg", initial_angle_deg,
           {.unit = "°", .minimum = 0, .maximum = 120, .help = "Stretch angle at which the simulated motors start."});
    v.real("sim.motor_speed_limit_deg_s", motor_speed_limit_deg_s,
           {.unit = "°/s", .minimum = 1, .maximum = 2000, .help = "Highest speed of a motor's output shaft."});
    v.real("sim.motor_current_limit_mA", motor_current_limit_mA,
           {.unit = "mA", .minimum = 50, .maximum = 5000, .help = "Highest current of a motor."});
    v.real("sim.motor_friction_percent", motor_friction_percent,
           {.unit = "%",
            .minimum = 0,
            .maximum = 40,
            .help = "Friction of a motor: the duty cycle that it needs before it turns."});
    v.boolean(
        "sim.reports_position_duty", reports_position_duty,
        {.help = "Whether the motor board reports the duty cycle of its position loop (the thesis' board does not)."});
    vibration.describe(v);
    v.real("sim.ir_noise_mV", ir_noise_mV,
           {.unit = "mV", .minimum = 0, .maximum = 200, .help = "Noise of an IR sensor's output, standard deviation."});
    v.real("sim.ir_period_ms", ir_period_ms,
           {.unit = "ms", .minimum = 1, .maximum = 200, .help = "Time between two measurements of an IR sensor."});
    v.real(
        "sim.ir_delay_ms", ir_delay_ms,
        {.unit = "ms",
         .minimum = 0,
         .maximum = 500,
         .help = "Delay of the IR sensors: a reading shows the cloth as it was this long before the reading's time."});
    v.real(
        "sim.bridge_noise_mV_per_V", bridge_noise_mV_per_V,
        {.unit = "mV/V", .minimum = 0, .maximum = 0.1, .help = "Noise of the load cell's bridge, standard deviation."});
    v.real("sim.bridge_offset_mV_per_V", bridge_offset_mV_per_V,
           {.unit = "mV/V", .minimum = -1, .maximum = 1, .help = "Zero error of the load cell, which taring removes."});
    v.real("sim.bridge_rate_Hz", bridge_rate_Hz,
           {.unit = "Hz", .minimum = 1, .maximum = 122, .help = "Samples of the load cell per second."});
    v.real(
        "sim.bridge_delay_ms", bridge_delay_ms,
        {.unit = "ms",
         .minimum = 0,
         .maximum = 500,
         .help = "Delay of the load cell: a reading shows the force as it was this long before the reading's time."});
    v.real("sim.encoder_delay_ms", encoder_delay_ms,
           {.unit = "ms",
            .minimum = 0,
            .maximum = 500,
            .help =
                "Delay of the encoders: a reading shows the angles as they were this long before the reading's time."});
    v.real("sim.camera_rate_Hz", camera_rate_Hz,
           {.unit = "Hz", .minimum = 1, .maximum = 120, .help = "Pictures of the camera per second."});
    v.real("sim.camera_delay_ms", camera_delay_ms,
           {.unit = "ms",
            .minimum = 0,
            .maximum = 500,
            .help = "Delay of the camera: a picture shows the cloth as it was this long before the picture's time."});
    v.real("sim.camera_noise", camera_noise,
           {.minimum = 0, .maximum = 30, .help = "Noise of a pixel in grey levels, standard deviation."});
    v.real("sim.camera_vignette", camera_vignette,
           {.minimum = 0,
            .maximum = 0.9,
            .help = "Vignetting of the lens: share of the light that is missing in the picture's corners."});
    v.real("sim.light", light,
           {.minimum = 0, .maximum = 3, .help = "Brightness of the picture: 1 is as intended, 0 is dark."});
    v.real("sim.light_gradient", light_gradient,
           {.minimum = -0.9,
            .maximum = 0.9,
            .help = "Share by which the brightness changes from the picture's left edge to its right; above 0 the "
                    "right is brighter."});
    v.real("sim.edge_softness_px", edge_softness_px,
           {.unit = "px",
            .minimum = 0.1,
            .maximum = 20,
            .help = "Width of the finger's blurred edge in the picture; more is softer."});
    v.choice("sim.material", material, kMaterialNames, {.help = "Material under the simulated robot's tool."});
    v.real("sim.material_stiffness_N_per_mm", material_stiffness_N_per_mm,
           {.unit = "N/mm",
            .minimum = 0,
            .maximum = 1000,
            .help = "Stiffness of the material under the tool; 0: the material's own."});
    v.real("sim.robot_speed_limit_mm_s", robot_speed_limit_mm_s,
           {.unit = "mm/s", .minimum = 1, .maximum = 2000, .help = "Highest speed of the simulated robot's tool."});
    v.real("sim.robot_stiffness_N_per_mm", robot_stiffness_N_per_mm,
           {.unit = "N/mm",
            .minimum = 0.05,
            .maximum = 5,
            .help = "Stiffness of the simulated robot's impedance control; with less, the arm yields more."});
    v.real("sim.accelerometer_noise_g", accelerometer_noise_g,
           {.unit = "g", .minimum = 0, .maximum = 1, .help = "Noise of the tool's accelerometer, standard deviation."});
    v.real("sim.accelerometer_range_g", accelerometer_range_g,
           {.unit = "g",
            .minimum = 1,
            .maximum = 16,
            .help = "Range of the tool's accelerometer: larger accelerations, of either sign, are cut off here."});
  }
};

}  // namespace fyd::sim
