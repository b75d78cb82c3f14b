#include "core/device/camera/frozen_picture.h"

#include <cstring>

namespace fyd::device {
namespace {

bool equal(const cv::Mat& a, const cv::Mat& b) {
  if (a.size() != b.size() || a.type() != b.type()) return false;
  const std::size_t row = static_cast<std::size_t>(a.cols) * a.elemSize();
  for (int y = 0; y < a.rows; ++y) {
    if (std::memcmp(a.ptr(y), b.ptr(y), row) != 0) return false;
  }
  return true;
}

/// One grey throughout: every byte is the first.
bool flat(const cv::Mat& picture) {
  const std::size_t row = static_cast<std::size_t>(picture.cols) * picture.elemSize();
  if (picture.empty()) return true;
  const std::uint8_t first = *picture.ptr(0);
  for (int y = 0; y < picture.rows; ++y) {
    const std::uint8_t* bytes = picture.ptr(y);
    if (bytes[0] != first || std::memcmp(bytes, bytes + 1, row - 1) != 0) return false;
  }
  return true;
}

}  // namespace

bool FrozenPicture::isNews(const cv::Mat& picture, Instant taken) {
  if (limit_ <= Duration::zero()) return true;
  if (last_.empty() || !equal(last_, picture) || flat(picture)) {
    last_ = picture;
    changed_ = taken;
    frozen_ = false;
    return true;
  }
  frozen_ = taken - changed_ > limit_;
  return false;
}

}  // namespace fyd::device
