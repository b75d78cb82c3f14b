// Camera calibration from points of a printed target: pixels to millimetres, with a scale of its own for each axis.
//
//   x = scale_x·u + offset_x,   y = scale_y·v + offset_y        (u to the right, v downward in the picture)
//
// A rotation of the camera against the target is found by a full affine fit; when it exceeds its own uncertainty the
// two lines are fitted in the turned frame. The residual angle between the axes (shear) shows a tilted camera.
//
// Points may lie at a depth δ below the untouched cloth: pressed down, they appear H/(H − δ) as far from the axis,
// which is taken to be the touchpad's origin as the detector takes it (core/sensing/contact_cloth.h). Where depths
// differ enough the camera's height H is fitted too, by Gauss–Newton on 1/H with the affine map solved anew for each.
#pragma once

#include <vector>

#include "core/calibration/calibration_parameters.h"
#include "core/calibration/calibration_result.h"

namespace fyd::calibration {

struct CameraSamples {
  std::vector<double> x_px;
  std::vector<double> y_px;
  std::vector<double> x_mm;           ///< in the touchpad's frame: to the right
  std::vector<double> y_mm;           ///< to the back, so that it falls as y_px grows
  std::vector<double> depth_mm = {};  ///< below the untouched cloth; empty: all on it
};

struct CameraCalibration {
  CalibrationResult result;  ///< coefficients: scale_x, scale_y (mm/px), offset_x, offset_y, camera_height (mm) if any
  double rotation_deg = kUnknown;  ///< −180…180, as sensing.finger_rotation_deg
  double rotation_error_deg = kUnknown;
  bool rotated = false;  ///< the turn is beyond its uncertainty and part of the fit
  double shear_deg = kUnknown;
  bool mirrored = false;
  std::vector<double> residual_x_mm;  ///< result.residuals are their lengths
  std::vector<double> residual_y_mm;
};

[[nodiscard]] CameraCalibration calibrateCamera(const CameraSamples& samples, const CalibrationParameters& parameters);

}  // namespace fyd::calibration
