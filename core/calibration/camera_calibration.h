// Camera calibration from points of a printed target: pixels to millimetres, with a scale of its own for each axis.
//
//   x = scale_x·u + offset_x,   y = scale_y·v + offset_y        (u to the right, v downward in the picture)
//
// A turn of the camera against the target is told from a full affine fit; when it is beyond its own uncertainty the two
// lines are fitted in the turned frame. The residual angle between the axes (shear) is a diagnostic: a tilted camera.
#pragma once

#include <vector>

#include "core/calibration/calibration_parameters.h"
#include "core/calibration/calibration_result.h"

namespace fyd::calibration {

struct CameraSamples {
  std::vector<double> x_px;
  std::vector<double> y_px;
  std::vector<double> x_mm;  ///< in the touchpad's frame: to the right
  std::vector<double> y_mm;  ///< to the back, so that it falls as y_px grows
};

struct CameraCalibration {
  CalibrationResult result;        ///< coefficients: scale_x, scale_y (mm/px), offset_x, offset_y (mm)
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
