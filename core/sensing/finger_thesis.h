// The finger detector as printed [thesis §4.1.1], with the same OpenCV calls. See finger_detector.h.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/image.h"
#include "core/sensing/finger_parameters.h"
#include "core/sensing/finger_types.h"

namespace fyd::sensing {

class ThesisFinger {
 public:
  static constexpr int kWidth = 160;
  static constexpr int kHeight = 120;
  static constexpr double kMillimetresPerPixel = 0.46875;  ///< the one printed scale, wrong for at least one axis

  /// @param last the previous detection: its position is kept while there is no contact
  [[nodiscard]] FingerDetection detect(const ImageView& picture, const RegionOfInterest& region,
                                       const FingerParameters& parameters, const FingerDetection& last);

  /// Dark pixels of the last picture, 160 × 120, 255 where dark.
  [[nodiscard]] const cv::Mat& binary() const { return binary_; }

 private:
  cv::Mat grey_;
  cv::Mat small_;
  cv::Mat binary_;
};

}  // namespace fyd::sensing
