// Compressed pictures: what is damaged or cut short is refused, never guessed.
//
// OpenCV and FFmpeg fill the parts of a JPEG that they cannot decode with grey or with the last picture, without an
// error; a finger detector then sees dark places that are not there. Here every warning of the decoder counts as
// damage.
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <string>

#include <opencv2/core/mat.hpp>

#include "core/base/error.h"

namespace fyd::device {

/// @param expected size; empty: any. Another one is refused by the head, before anything is decoded
/// @return 8 bit, grey or BGR as the file says; or an error: damaged, cut short, no JPEG, of another size, or of more than
///         32 million pixels
[[nodiscard]] Result<cv::Mat> decodeJpeg(std::span<const std::uint8_t> bytes, cv::Size expected = {});

/// A picture from a file, 8 bit, grey or BGR as the file says.
/// @return an error that names the file when it cannot be read or its picture is damaged or cut short
[[nodiscard]] Result<cv::Mat> readPicture(const std::string& path);

/// Whether a source of JPEGs can still be trusted. A JPEG carries no checksum: some damaged ones decode without a
/// warning (a bit of the brightness, a code that is valid by chance). Up to two damaged pictures among the last 32 are
/// tolerated; with three or more all pictures of the source are refused, the seemingly whole ones included.
class DamageWatch {
 public:
  void saw(bool damaged) { recent_ = (recent_ << 1U) | (damaged ? 1U : 0U); }
  [[nodiscard]] bool believed() const { return std::popcount(recent_) < kTooMany; }

 private:
  static constexpr int kTooMany = 3;
  std::uint32_t recent_ = 0;  // a bit for each picture, newest lowest; set: damaged
};

}  // namespace fyd::device
