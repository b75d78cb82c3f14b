#include "core/sensing/finger_thesis.h"

#include <cmath>

#include <opencv2/imgproc.hpp>

namespace fyd::sensing {
namespace {

/// OpenCV has no view of constant pixels; nothing here writes to them.
cv::Mat wrap(const ImageView& picture) {
  return {picture.height, picture.width, picture.channels == 3 ? CV_8UC3 : CV_8UC1,
          const_cast<std::uint8_t*>(picture.data), static_cast<std::size_t>(picture.stride)};
}

}  // namespace

FingerDetection ThesisFinger::detect(const ImageView& picture, const RegionOfInterest& region,
                                     const FingerParameters& parameters, const FingerDetection& last) {
  const cv::Mat cloth = wrap(picture)(cv::Rect(region.x, region.y, region.width, region.height));
  if (picture.channels == 3) {
    cv::cvtColor(cloth, grey_, cv::COLOR_BGR2GRAY);
    cv::resize(grey_, small_, {kWidth, kHeight});
  } else {
    cv::resize(cloth, small_, {kWidth, kHeight});
  }
  cv::threshold(small_, binary_, parameters.threshold - 1, 255, cv::THRESH_BINARY_INV);

  FingerDetection out = last;
  out.contact = false;
  out.quality = 0.0;
  out.area_px = cv::countNonZero(binary_);
  double darkest = 0.0;
  double brightest = 0.0;
  cv::minMaxLoc(small_, &darkest, &brightest);
  if (brightest == darkest) {
    out.reason = brightest == 0.0     ? FingerReason::black_picture
                 : brightest == 255.0 ? FingerReason::saturated
                                      : FingerReason::flat_picture;
    return out;
  }
  if (!(out.area_px > parameters.minimum_area_px)) {
    out.reason = out.area_px > 0.0 ? FingerReason::too_small : FingerReason::no_finger;
    return out;
  }
  const double sigma = (brightest - darkest) / 5.0;
  double sum = 0.0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (binary_.at<std::uint8_t>(y, x) == 0) continue;
      const double off = small_.at<std::uint8_t>(y, x) - darkest;
      const double weight = std::exp(-off * off / (2.0 * sigma * sigma));
      sum += weight;
      sum_x += weight * x;
      sum_y += weight * y;
    }
  }
  const double x = sum_x / sum;  // the darkest pixel is dark unless the whole region is bright: then area is 0
  const double y = sum_y / sum;
  out.contact = true;
  out.x_px = region.x + (x + 0.5) * region.width / kWidth - 0.5;
  out.y_px = region.y + (y + 0.5) * region.height / kHeight - 0.5;
  out.x_mm = (x - kWidth / 2.0) * kMillimetresPerPixel;
  out.y_mm = -(y - kHeight / 2.0) * kMillimetresPerPixel;
  out.quality = 1.0;
  out.reason = FingerReason::found;
  return out;
}

}  // namespace fyd::sensing
