// Parameters of the finger detector [thesis §4.1.1] [authors' program].
// Stability: may change
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/base/message.h"
#include "core/base/parameter.h"

namespace fyd::sensing {

enum class FingerMode : std::uint8_t { adaptive, thesis };
inline constexpr std::array<std::string_view, 2> kFingerModeNames = {"adaptive", "thesis"};

struct FingerParameters {
  FingerMode mode = FingerMode::adaptive;
  int roi_x_px = 40;
  int roi_y_px = 45;
  int roi_width_px = 220;
  int roi_height_px = 150;
  int threshold = 210;
  double minimum_area_px = 150.0;
  double minimum_area_mm2 = 4.0;
  double minimum_contrast = 0.15;
  int stride_px = 1;
  double centre_x_px = 150.0;
  double centre_y_px = 120.0;
  double scale_x_mm_per_px = 100.0 / 220.0;
  double scale_y_mm_per_px = 70.0 / 150.0;
  double rotation_deg = 0.0;
  bool mirror = false;

  template <class Visitor>
  void describe(Visitor& v) {
    v.choice("sensing.finger_mode", mode, kFingerModeNames,
             {.name = sentence("Finger mode"),
              .help = sentence("adaptive follows uneven and changing light; thesis is the printed algorithm."),
              .live = true});
    v.integer("sensing.roi_x_px", roi_x_px,
              {.unit = "px",
               .minimum = 0,
               .maximum = 4000,
               .help = sentence("Left edge of the cloth in the camera's picture.")});
    v.integer("sensing.roi_y_px", roi_y_px,
              {.unit = "px",
               .minimum = 0,
               .maximum = 4000,
               .help = sentence("Top edge of the cloth in the camera's picture.")});
    v.integer("sensing.roi_width_px", roi_width_px,
              {.unit = "px",
               .minimum = 16,
               .maximum = 1920,
               .help = sentence("Width of the cloth in the camera's picture.")});
    v.integer("sensing.roi_height_px", roi_height_px,
              {.unit = "px",
               .minimum = 16,
               .maximum = 1080,
               .help = sentence("Height of the cloth in the camera's picture.")});
    v.integer("sensing.finger_threshold", threshold,
              {.name = sentence("Finger threshold"),
               .minimum = 1,
               .maximum = 255,
               .help = sentence("Thesis mode: grey values below it are the finger."),
               .live = true});
    v.real("sensing.finger_minimum_area_px", minimum_area_px,
           {.name = sentence("Finger minimum area"),
            .unit = "px",
            .minimum = 1,
            .maximum = 19200,
            .help = sentence("Thesis mode: smallest dark area that counts as a touch, in pixels of its 160 × 120 "
                             "picture."),
            .live = true});
    v.real("sensing.finger_minimum_area_mm2", minimum_area_mm2,
           {.name = sentence("Finger smallest contact"),
            .unit = "mm²",
            .minimum = 0.5,
            .maximum = 1000,
            .help = sentence("Adaptive mode: smallest dark area that counts as a touch, on the cloth."),
            .live = true,
            .before_it_was = 54.6875});  // 150 of 160 × 120 pixels of 100 × 70 mm
    v.real("sensing.finger_minimum_contrast", minimum_contrast,
           {.name = sentence("Finger minimum contrast"),
            .minimum = 0.05,
            .maximum = 0.9,
            .help = sentence("Adaptive mode: a finger is darker than the lit cloth by at least this part of it."),
            .live = true});
    v.integer("sensing.finger_stride_px", stride_px,
              {.unit = "px",
               .minimum = 1,
               .maximum = 8,
               .help = sentence("Adaptive mode: use every n-th pixel and row, for slow computers.")});
    v.real("sensing.finger_centre_x_px", centre_x_px,
           {.name = sentence("Finger centre x"),
            .unit = "px",
            .minimum = -4000,
            .maximum = 8000,
            .help = sentence("Picture column of the touchpad's origin."),
            .live = true});
    v.real("sensing.finger_centre_y_px", centre_y_px,
           {.name = sentence("Finger centre y"),
            .unit = "px",
            .minimum = -4000,
            .maximum = 8000,
            .help = sentence("Picture row of the touchpad's origin."),
            .live = true});
    v.real("sensing.finger_scale_x_mm_per_px", scale_x_mm_per_px,
           {.name = sentence("Finger scale x"),
            .unit = "mm/px",
            .minimum = 0.01,
            .maximum = 10,
            .help = sentence("Millimetres per pixel along a picture row."),
            .live = true});
    v.real("sensing.finger_scale_y_mm_per_px", scale_y_mm_per_px,
           {.name = sentence("Finger scale y"),
            .unit = "mm/px",
            .minimum = 0.01,
            .maximum = 10,
            .help = sentence("Millimetres per pixel along a picture column."),
            .live = true});
    v.real("sensing.finger_rotation_deg", rotation_deg,
           {.name = sentence("Finger rotation"),
            .unit = "°",
            .minimum = -180,
            .maximum = 180,
            .help = sentence("Turn from the picture's axes to the touchpad's, counter-clockwise seen from above."),
            .live = true});
    v.boolean("sensing.finger_mirror", mirror,
              {.name = sentence("Finger mirror"),
               .help = sentence("The camera sees the cloth mirrored left to right."),
               .live = true});
  }
};

/// From a place in the picture to one on the cloth: x = ±(u − u₀)·sx, y = −(v − v₀)·sy, then turned by the rotation.
inline void toMillimetres(const FingerParameters& parameters, double u_px, double v_px, double& x_mm, double& y_mm) {
  const double across =
      (u_px - parameters.centre_x_px) * parameters.scale_x_mm_per_px * (parameters.mirror ? -1.0 : 1.0);
  const double back = -(v_px - parameters.centre_y_px) * parameters.scale_y_mm_per_px;
  const double angle = parameters.rotation_deg * std::numbers::pi / 180.0;
  x_mm = std::cos(angle) * across - std::sin(angle) * back;
  y_mm = std::sin(angle) * across + std::cos(angle) * back;
}

}  // namespace fyd::sensing
