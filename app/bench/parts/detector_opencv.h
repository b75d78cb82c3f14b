// The algorithm of the adaptive finger detector as separate OpenCV calls with whole intermediate pictures: the baseline
// of the detector's benchmark. Same background surface, components, rim and sums as
// core/sensing/finger_adaptive.h.
#pragma once

#include <opencv2/core/mat.hpp>

#include "core/base/image.h"
#include "core/sensing/finger_parameters.h"
#include "core/sensing/finger_types.h"
#include "core/sensing/light_surface.h"

namespace fyd::bench {

class OpenCvFinger {
 public:
  explicit OpenCvFinger(const sensing::FingerParameters& parameters = {});
  [[nodiscard]] sensing::FingerDetection detect(const ImageView& picture);

 private:
  void markDark(const cv::Mat& grey);
  void coverCells();
  void lightPicture();
  [[nodiscard]] int largestBlob() const;

  sensing::FingerParameters parameters_;
  sensing::LightSurface light_;
  bool light_known_ = false;
  float mark_below_ = 0.85F;
  std::vector<sensing::LightSurface::Cell> cells_;
  cv::Mat cell_greys_;
  cv::Mat light_picture_;
  cv::Mat grey_;
  cv::Mat share_;
  cv::Mat darkness_;
  cv::Mat marks_;
  cv::Mat labels_;
  cv::Mat stats_;
  cv::Mat centroids_;
  cv::Mat blob_;
  cv::Mat rim_;
  cv::Mat core_;
  cv::Mat weights_;
};

}  // namespace fyd::bench
