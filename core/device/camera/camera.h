// A source of pictures: simulated, a device, a file, a folder or a stream.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/base/error.h"
#include "core/base/image.h"
#include "core/base/time.h"
#include "core/device/device_report.h"

namespace fyd::device {

struct CameraFrame {
  cv::Mat picture;  ///< 8 bit, grey or BGR
  Instant taken{};
  std::uint64_t number = 0;  ///< from 1
};

[[nodiscard]] inline ImageView viewOf(const cv::Mat& picture) {
  return {.data = picture.data,
          .width = picture.cols,
          .height = picture.rows,
          .stride = static_cast<std::ptrdiff_t>(picture.step),
          .channels = picture.channels()};
}

/// Used by one thread at a time (the station's camera thread).
class Camera {
 public:
  virtual ~Camera() = default;
  [[nodiscard]] virtual Message description() const = 0;

  /// "simulated", "camera device", "video file", "folder", "stream".
  [[nodiscard]] virtual Message kind() const = 0;

  /// Brightness, contrast and exposure as the profile wants them and as the source set them at its last opening.
  [[nodiscard]] virtual std::vector<CameraControl> controls() const { return {}; }

  /// Whether the pictures come from an image sensor now, so that noise makes two equal ones impossible.
  [[nodiscard]] virtual bool live() const { return false; }

  /// Pictures that were refused as damaged or cut short since the start.
  [[nodiscard]] virtual std::uint64_t damaged() const { return 0; }

  /// Waits for the next picture, at most about a second.
  /// @return an error when the source ended, vanished or is silent; the caller may try again later
  [[nodiscard]] virtual Result<CameraFrame> next() = 0;
};

}  // namespace fyd::device
