// Capture devices, video files and streams through OpenCV's VideoCapture.
#pragma once

#include <optional>
#include <string>

#include <opencv2/videoio.hpp>

#include "core/device/camera.h"
#include "core/device/pacer.h"

namespace fyd::device {

enum class CaptureKind : std::uint8_t { device, video, stream };

class CaptureCamera final : public Camera {
 public:
  /// @param number of a device; for the other kinds, and for devices by path, unused
  /// @return an error when it does not open, or (video) holds no picture
  [[nodiscard]] static Result<std::unique_ptr<Camera>> open(CaptureKind kind, const std::string& source,
                                                            std::optional<int> number = std::nullopt);

  [[nodiscard]] std::string description() const override;
  /// After an error each call waits until a second has passed since the last attempt and opens the source again.
  /// A video is played again from its start when it ends.
  [[nodiscard]] Result<CameraFrame> next() override;

 private:
  CaptureCamera(CaptureKind kind, std::string source, std::optional<int> number)
      : kind_(kind), source_(std::move(source)), number_(number), pacer_(kUsualRate_Hz) {}
  [[nodiscard]] Result<void> openCapture();
  [[nodiscard]] bool read(cv::Mat& picture);
  [[nodiscard]] std::string name() const;

  CaptureKind kind_;
  std::string source_;
  std::optional<int> number_;
  Pacer pacer_;
  cv::VideoCapture capture_;
  cv::Size size_;
  Instant last_attempt_{};
  std::uint64_t frames_ = 0;
};

}  // namespace fyd::device
