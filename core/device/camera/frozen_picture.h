// Detects a frozen live camera: one that delivers the same picture again and again. A sensor's noise makes two pictures
// that are equal bit for bit impossible; a driver, a network camera or a decoder that hangs delivers them.
//
// An equal picture does not count as new, and its time stays that of the first. A picture of one grey only (black,
// saturated) always counts as new: noise is cut off there, and the detector reports that it sees nothing.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/time.h"

namespace fyd::device {

class FrozenPicture {
 public:
  /// @param limit time of equal pictures after which they count as frozen; zero: never, and every picture is new
  explicit FrozenPicture(Duration limit) : limit_(limit) {}

  /// @param picture is kept (shared, not copied) until another follows
  /// @return whether it differs from the one before
  [[nodiscard]] bool isNews(const cv::Mat& picture, Instant taken);
  /// Equal pictures for longer than the limit.
  [[nodiscard]] bool frozen() const { return frozen_; }
  /// The source was opened anew.
  void reset() { *this = FrozenPicture(limit_); }

 private:
  Duration limit_;
  cv::Mat last_;
  Instant changed_{};
  bool frozen_ = false;
};

}  // namespace fyd::device
