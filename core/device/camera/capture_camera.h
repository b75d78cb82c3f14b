// Capture devices, video files and streams through OpenCV's VideoCapture.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <opencv2/videoio.hpp>

#include "core/device/camera/camera.h"
#include "core/device/camera/camera_controls.h"
#include "core/device/camera/picture_decoder.h"
#include "core/device/pacer.h"
#include "core/device/stable_name.h"

namespace fyd::device {

enum class CaptureKind : std::uint8_t { device, video, stream };

struct CaptureChoice {
  CaptureKind kind = CaptureKind::device;
  std::string source;         ///< path, "id=SERIAL" (device), or URL (stream)
  std::optional<int> number;  ///< of a device; for the other kinds, and for devices by path, unused
};

/// Switches off OpenCV's and FFmpeg's messages to the console: failures are returned as errors. Makes OpenCV take
/// camera controls as shares of their range, which means the same for every camera. Does so in the environment, so it is
/// called before there are threads.
void prepareCaptures();

class CaptureCamera final : public Camera {
 public:
  /// @return an error when it does not open, or (video) holds no picture
  [[nodiscard]] static Result<std::unique_ptr<Camera>> open(const CaptureChoice& choice,
                                                            const DeviceParameters& parameters);

  [[nodiscard]] Message description() const override;
  [[nodiscard]] Message kind() const override;
  [[nodiscard]] std::vector<CameraControl> controls() const override { return controls_; }
  [[nodiscard]] bool live() const override { return kind_ != CaptureKind::video; }
  [[nodiscard]] std::uint64_t damaged() const override { return damaged_; }
  /// After an error each call waits until a second has passed since the last attempt and opens the source again.
  /// A video is played again from its start when it ends. Damaged pictures are skipped; a second without an accepted
  /// one is an error.
  [[nodiscard]] Result<CameraFrame> next() override;

 private:
  CaptureCamera(const CaptureChoice& choice, const DeviceParameters& parameters)
      : kind_(choice.kind),
        source_(choice.source),
        shown_(withoutSecrets(choice.source)),
        number_(choice.number),
        settings_(cameraSettings(parameters)),
        by_id_(folderOr(parameters.cameras_by_id, kCamerasById)),
        pacer_(kUsualRate_Hz) {}
  [[nodiscard]] Result<void> openCapture();
  void openDevice(const std::string& path);
  void setUpDevice();
  void takeJpegsUndecoded();
  enum class Got : std::uint8_t { picture, damaged, nothing };
  [[nodiscard]] Got read(cv::Mat& picture);
  [[nodiscard]] bool grab(cv::Mat& out);
  [[nodiscard]] Result<void> rewind();
  [[nodiscard]] tl::unexpected<Error> ended();
  [[nodiscard]] Message name() const;

  CaptureKind kind_;
  std::string source_;
  std::string shown_;  // without a password
  std::optional<int> number_;
  CameraSettings settings_;
  std::string by_id_;  // folder of the stable device names
  std::vector<CameraControl> controls_;
  Pacer pacer_;
  std::unique_ptr<cv::VideoCapture> capture_;  // there from the first time it is opened
  cv::Size size_;
  bool jpegs_ = false;  // the source delivers them undecoded
  DamageWatch watch_;
  Message damage_;  // of the newest damaged picture
  std::uint64_t damaged_ = 0;
  Instant last_attempt_{};
  std::uint64_t frames_ = 0;
};

}  // namespace fyd::device
