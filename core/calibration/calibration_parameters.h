// What a calibration must reach to be accepted, and when it counts as old.
#pragma once

#include "core/base/parameter.h"

namespace fyd::calibration {

struct CalibrationParameters {
  double condition_limit = 1e4;
  double widest_gap_percent = 50.0;
  int ir_fewest_distances = 5;
  double ir_least_span_mm = 40.0;
  double ir_held_out_mm = 5.0;
  int force_fewest_loads = 3;
  double force_least_span_N = 0.5;
  double force_held_out_N = 0.1;
  double force_hysteresis_percent = 2.0;
  int stiffness_fewest_angles = 3;
  int stiffness_fewest_presses = 3;
  double stiffness_held_out_N = 0.3;
  double stiffness_interval_percent = 20.0;
  double cloth_beside_mm = 2.5;
  double cloth_least_depth_mm = 2.0;
  double cloth_depth_ratio = 1.4;
  double cloth_share_percent = 8.0;
  double cloth_ratio_percent = 15.0;
  double cloth_held_out_mm = 0.2;
  int camera_fewest_points = 4;
  double camera_least_span_px = 40.0;
  double camera_held_out_mm = 1.0;
  double camera_height_percent = 10.0;
  double encoder_least_sweep_deg = 20.0;
  double encoder_scale_percent = 3.0;
  double encoder_held_out_deg = 1.0;
  int rest_fewest_samples = 100;
  double rest_sigma_g = 0.05;
  double rest_magnitude_g = 0.05;
  int ageing_days = 90;
  int old_days = 365;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real(
        "calibration.condition_limit", condition_limit,
        {.minimum = 10, .maximum = 1e9, .help = "A fit whose scaled design has a larger condition number is refused."});
    v.real("calibration.widest_gap_percent", widest_gap_percent,
           {.unit = "%", .minimum = 10, .maximum = 100, .help = "Widest part of the measured span without a point."});
    v.integer("calibration.ir_fewest_distances", ir_fewest_distances,
              {.minimum = 4, .maximum = 100, .help = "Distance sensor: fewest different distances."});
    v.real("calibration.ir_least_span_mm", ir_least_span_mm,
           {.unit = "mm", .minimum = 5, .maximum = 260, .help = "Distance sensor: shortest span of distances."});
    v.real("calibration.ir_held_out_mm", ir_held_out_mm,
           {.unit = "mm", .minimum = 0.01, .maximum = 50, .help = "Distance sensor: largest held-out error."});
    v.integer("calibration.force_fewest_loads", force_fewest_loads,
              {.minimum = 2, .maximum = 100, .help = "Load cell: fewest different weights."});
    v.real("calibration.force_least_span_N", force_least_span_N,
           {.unit = "N", .minimum = 0.01, .maximum = 50, .help = "Load cell: smallest span of weights."});
    v.real("calibration.force_held_out_N", force_held_out_N,
           {.unit = "N", .minimum = 0.001, .maximum = 10, .help = "Load cell: largest held-out error."});
    v.real("calibration.force_hysteresis_percent", force_hysteresis_percent,
           {.unit = "%",
            .minimum = 0.1,
            .maximum = 50,
            .help = "Load cell: hysteresis and drift beyond this part of the span are pointed out."});
    v.integer("calibration.stiffness_fewest_angles", stiffness_fewest_angles,
              {.minimum = 2, .maximum = 16, .help = "Stiffness map: fewest stretch angles."});
    v.integer(
        "calibration.stiffness_fewest_presses", stiffness_fewest_presses,
        {.minimum = 2, .maximum = 100, .help = "Stiffness map: fewest presses of 0.5 mm and more at each angle."});
    v.real(
        "calibration.stiffness_held_out_N", stiffness_held_out_N,
        {.unit = "N", .minimum = 0.001, .maximum = 10, .help = "Stiffness map: largest held-out error of the force."});
    v.real("calibration.stiffness_interval_percent", stiffness_interval_percent,
           {.unit = "%",
            .minimum = 1,
            .maximum = 100,
            .help = "Stiffness map: widest half 95 % interval of an angle's stiffness."});
    v.real("calibration.cloth_beside_mm", cloth_beside_mm,
           {.unit = "mm",
            .minimum = 0.5,
            .maximum = 10,
            .help = "Cloth: a press farther than this beside a distance sensor tells no depth."});
    v.real(
        "calibration.cloth_least_depth_mm", cloth_least_depth_mm,
        {.unit = "mm", .minimum = 0.5, .maximum = 20, .help = "Cloth: least depth of the deepest press of a sensor."});
    v.real("calibration.cloth_depth_ratio", cloth_depth_ratio,
           {.minimum = 1.1, .maximum = 5, .help = "Cloth: deepest over shallowest press of a sensor, at least."});
    v.real("calibration.cloth_share_percent", cloth_share_percent,
           {.unit = "%", .minimum = 0.5, .maximum = 100, .help = "Cloth: largest uncertainty of the radius share."});
    v.real("calibration.cloth_ratio_percent", cloth_ratio_percent,
           {.unit = "%", .minimum = 0.5, .maximum = 100, .help = "Cloth: largest uncertainty of the tension ratio."});
    v.real("calibration.cloth_held_out_mm", cloth_held_out_mm,
           {.unit = "mm",
            .minimum = 0.01,
            .maximum = 20,
            .help = "Cloth: largest held-out error of a reading beside the finger."});
    v.integer("calibration.camera_fewest_points", camera_fewest_points,
              {.minimum = 4, .maximum = 1000, .help = "Camera: fewest points of the printed target."});
    v.real("calibration.camera_least_span_px", camera_least_span_px,
           {.unit = "px", .minimum = 4, .maximum = 2000, .help = "Camera: smallest span of the points, each way."});
    v.real("calibration.camera_held_out_mm", camera_held_out_mm,
           {.unit = "mm", .minimum = 0.01, .maximum = 20, .help = "Camera: largest held-out error."});
    v.real("calibration.camera_height_percent", camera_height_percent,
           {.unit = "%", .minimum = 0.5, .maximum = 50, .help = "Camera: largest uncertainty of its height."});
    v.real("calibration.encoder_least_sweep_deg", encoder_least_sweep_deg,
           {.unit = "deg", .minimum = 5, .maximum = 180, .help = "Encoders: smallest commanded sweep."});
    v.real(
        "calibration.encoder_scale_percent", encoder_scale_percent,
        {.unit = "%", .minimum = 0.1, .maximum = 30, .help = "Encoders: largest departure from 4096 counts a turn."});
    v.real("calibration.encoder_held_out_deg", encoder_held_out_deg,
           {.unit = "deg", .minimum = 0.05, .maximum = 20, .help = "Encoders: largest held-out error."});
    v.integer("calibration.rest_fewest_samples", rest_fewest_samples,
              {.minimum = 10, .maximum = 100000, .help = "Accelerometer at rest: fewest samples."});
    v.real("calibration.rest_sigma_g", rest_sigma_g,
           {.unit = "g", .minimum = 0.0001, .maximum = 1, .help = "Accelerometer at rest: largest spread of an axis."});
    v.real("calibration.rest_magnitude_g", rest_magnitude_g,
           {.unit = "g", .minimum = 0.001, .maximum = 1, .help = "Accelerometer at rest: largest departure from 1 g."});
    v.integer("calibration.ageing_days", ageing_days,
              {.unit = "days", .minimum = 1, .maximum = 10000, .help = "A calibration older than this is ageing."});
    v.integer(
        "calibration.old_days", old_days,
        {.unit = "days", .minimum = 1, .maximum = 10000, .help = "A calibration older than this is old: repeat it."});
  }
};

}  // namespace fyd::calibration
