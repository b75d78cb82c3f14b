// A picture of the camera and what the finger detector made of it.
#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "core/base/time.h"
#include "core/sensing/finger_types.h"

namespace fyd::station {

/// A picture as the detector saw it.
struct CameraView {
  cv::Mat picture;      ///< 8 bit, grey or BGR; empty before the first
  cv::Mat finger_mask;  ///< 8 bit, the region of interest's size; 255 where the detector sees finger
  cv::Rect region;      ///< of interest, in the picture
  sensing::FingerDetection finger;
  Instant taken{};
  std::uint64_t number = 0;
};

}  // namespace fyd::station
