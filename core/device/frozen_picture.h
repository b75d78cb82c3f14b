// Tells a live camera that goes on delivering one and the same picture. A sensor's noise makes two pictures that are
// equal bit for bit impossible; a driver, a network camera or a decoder that hangs delivers just that.
//
// An equal picture is no news: it proves nothing about the present, so its time stays that of the first. A picture of
// one grey only (black, saturated) is news: there noise is cut off, and the detector reports it as blind.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/time.h"

namespace fyd::device {

class FrozenPicture {
 public:
  /// @param limit of equal pictures until they count as frozen; zero: never, and every picture is news
  explicit FrozenPicture(Duration limit) : limit_(limit) {}

  /// @param picture is kept until another follows
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
