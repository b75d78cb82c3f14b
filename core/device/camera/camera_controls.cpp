#include "core/device/camera/camera_controls.h"

#include <array>
#include <cmath>

#include <opencv2/videoio.hpp>

namespace fyd::device {
namespace {

struct Control {
  std::string_view name;
  int property;
  double CameraSettings::*wanted;
};

constexpr std::array<Control, 3> kControls = {
    {{sentence("brightness"), cv::CAP_PROP_BRIGHTNESS, &CameraSettings::brightness_percent},
     {sentence("contrast"), cv::CAP_PROP_CONTRAST, &CameraSettings::contrast_percent},
     {sentence("exposure"), cv::CAP_PROP_EXPOSURE, &CameraSettings::exposure_percent}}};

constexpr double kManualExposure = 0.25;  // OpenCV's value for V4L2_EXPOSURE_MANUAL when ranges are shares
constexpr double kTolerance_percent = 2.0;

bool isWanted(double percent) { return percent >= 0.0; }

CameraControl apply(const Control& control, double wanted, const ControlAccess& access) {
  CameraControl out{.name = phrase(control.name)};
  const bool asked = isWanted(wanted);
  bool granted = false;
  if (asked) {
    out.wanted = wanted;
    if (control.property == cv::CAP_PROP_EXPOSURE) {
      static_cast<void>(access.set(cv::CAP_PROP_AUTO_EXPOSURE, kManualExposure));
    }
    granted = access.set(control.property, wanted / 100.0);
  }
  const double share = access.get(control.property);
  const bool readable = std::isfinite(share) && share >= 0.0 && share <= 1.0;
  // OpenCV reads 0 for an absent control, so a control that was not asked for and reads 0 counts as absent.
  out.supported = asked ? granted : readable && share > 0.0;
  if (out.supported && readable) out.actual = 100.0 * share;
  if (!asked) {
    out.words = say("left as it is");
  } else if (!granted) {
    out.words = say("this camera has none, or refuses the value");
  } else if (readable && std::abs(out.actual - wanted) > kTolerance_percent) {
    out.words = say("asked for {:.0f} %, the camera took {:.0f} %", wanted, out.actual);
  } else {
    out.words = say("set to {:.0f} %", wanted);
  }
  return out;
}

}  // namespace

CameraSettings cameraSettings(const DeviceParameters& parameters) {
  return {.brightness_percent = parameters.camera_brightness_percent,
          .contrast_percent = parameters.camera_contrast_percent,
          .exposure_percent = parameters.camera_exposure_percent};
}

std::vector<CameraControl> applyControls(const CameraSettings& settings, const ControlAccess& access) {
  std::vector<CameraControl> out;
  out.reserve(kControls.size());
  for (const Control& control : kControls) out.push_back(apply(control, settings.*control.wanted, access));
  return out;
}

std::vector<CameraControl> noControls(const CameraSettings& settings, const Message& words) {
  std::vector<CameraControl> out;
  for (const Control& control : kControls) {
    CameraControl none{.name = phrase(control.name)};
    if (isWanted(settings.*control.wanted)) none.wanted = settings.*control.wanted;
    none.words = words;
    out.push_back(std::move(none));
  }
  return out;
}

Message missingControls(const std::vector<CameraControl>& controls) {
  std::vector<Message> out;
  for (const CameraControl& control : controls) {
    if (std::isnan(control.wanted) || control.supported) continue;
    out.push_back(about(control.name, control.words));
  }
  return listed(std::move(out));
}

}  // namespace fyd::device
