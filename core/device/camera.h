// A source of pictures: simulated, a device, a file, a folder or a stream.
#pragma once

#include <memory>
#include <string>

#include <opencv2/core/mat.hpp>

#include "core/base/error.h"
#include "core/base/image.h"
#include "core/base/time.h"

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
  [[nodiscard]] virtual std::string description() const = 0;

  /// Waits for the next picture, at most about a second.
  /// @return an error when the source ended, vanished or is silent; the caller may try again later
  [[nodiscard]] virtual Result<CameraFrame> next() = 0;
};

}  // namespace fyd::device
