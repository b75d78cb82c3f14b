// Brightness, contrast and exposure of a camera: as the profile wants them, and as the source set them.
// All in percent of the driver's own range, because that differs from camera to camera; the thesis had brightness and
// contrast at their maximum. An exposure that is set switches the camera's automatic one off.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "core/device/device_parameters.h"
#include "core/device/device_report.h"

namespace fyd::device {

/// Percent; negative: leave as it is.
struct CameraSettings {
  double brightness_percent = -1.0;
  double contrast_percent = -1.0;
  double exposure_percent = -1.0;
};

[[nodiscard]] CameraSettings cameraSettings(const DeviceParameters& parameters);

/// The source's side, with OpenCV's property numbers and values as shares of the range, 0…1.
struct ControlAccess {
  std::function<bool(int property, double share)> set;
  std::function<double(int property)> get;  ///< negative: has none
};

/// Sets the wanted values and reads back the actual ones.
[[nodiscard]] std::vector<CameraControl> applyControls(const CameraSettings& settings, const ControlAccess& access);

/// For a source without controls.
/// @param words "a video file has none"
[[nodiscard]] std::vector<CameraControl> noControls(const CameraSettings& settings, const Message& words);

/// "brightness: a video file has none": what is wanted and was not granted; empty when all was.
[[nodiscard]] Message missingControls(const std::vector<CameraControl>& controls);

}  // namespace fyd::device
