#include "core/sensing/finger_detector.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/sensing/finger_adaptive.h"
#include "core/sensing/finger_thesis.h"

namespace fyd::sensing {

struct FingerDetector::State {
  FingerParameters parameters;
  RegionOfInterest region;
  AdaptiveFinger adaptive;
  ThesisFinger thesis;
  FingerDetection last;  // thesis mode holds its position
  bool seen = false;     // `region` is that of the last picture, which was usable
};

FingerDetector::FingerDetector(const FingerParameters& parameters) : state_(std::make_unique<State>()) {
  state_->parameters = parameters;
}
FingerDetector::~FingerDetector() = default;
FingerDetector::FingerDetector(FingerDetector&&) noexcept = default;
FingerDetector& FingerDetector::operator=(FingerDetector&&) noexcept = default;

void FingerDetector::configure(const FingerParameters& parameters) {
  if (parameters.mode != state_->parameters.mode) reset();
  state_->parameters = parameters;
}

void FingerDetector::reset() {
  state_->adaptive.reset();
  state_->last = {};
  state_->seen = false;
}

RegionOfInterest FingerDetector::region() const { return state_->region; }

FingerDetection FingerDetector::detect(const ImageView& picture) {
  State& s = *state_;
  s.seen = false;
  FingerDetection out;
  if (picture.empty() || (picture.channels != 1 && picture.channels != 3)) return out;
  if (std::abs(picture.stride) < std::ptrdiff_t{picture.width} * picture.channels) return out;

  constexpr int kSmallest_px = 16;
  const FingerParameters& p = s.parameters;
  const int left = std::clamp(p.roi_x_px, 0, picture.width);
  const int top = std::clamp(p.roi_y_px, 0, picture.height);
  const int right = std::clamp(p.roi_x_px + p.roi_width_px, left, picture.width);
  const int bottom = std::clamp(p.roi_y_px + p.roi_height_px, top, picture.height);
  s.region = {left, top, right - left, bottom - top};
  if (s.region.width < kSmallest_px || s.region.height < kSmallest_px) return out;

  s.seen = true;
  out = p.mode == FingerMode::thesis ? s.thesis.detect(picture, s.region, p, s.last)
                                     : s.adaptive.detect(picture, s.region, p);
  s.last = out;
  // Thesis mode counts the pixels of its working picture, which shows the same region.
  const double per_px = p.mode == FingerMode::thesis ? static_cast<double>(s.region.width) * s.region.height /
                                                           (ThesisFinger::kWidth * ThesisFinger::kHeight)
                                                     : 1.0;
  const double area_mm2 = out.area_px * per_px * p.scale_x_mm_per_px * p.scale_y_mm_per_px;
  out.area_mm2 = showsCloth(out.reason) ? area_mm2 : std::numeric_limits<double>::quiet_NaN();
  return out;
}

void FingerDetector::drawOverlay(std::span<std::uint8_t> mask) const {
  const State& s = *state_;
  const auto size = static_cast<std::size_t>(s.region.width) * static_cast<std::size_t>(s.region.height);
  if (mask.size() < size) return;
  std::fill_n(mask.begin(), size, std::uint8_t{0});
  if (!s.seen) return;
  const auto put = [&](int x, int y, std::uint8_t value) {
    mask[static_cast<std::size_t>(y) * static_cast<std::size_t>(s.region.width) + static_cast<std::size_t>(x)] = value;
  };
  if (s.parameters.mode == FingerMode::thesis) {
    const cv::Mat& binary = s.thesis.binary();
    if (binary.empty()) return;
    for (int y = 0; y < s.region.height; ++y) {
      for (int x = 0; x < s.region.width; ++x) {
        put(x, y, binary.at<std::uint8_t>(y * binary.rows / s.region.height, x * binary.cols / s.region.width));
      }
    }
    return;
  }
  const int stride = std::max(1, s.adaptive.stride());
  for (const DarkRun& run : s.adaptive.runs().runs()) {
    const std::uint8_t value = run.blob == s.adaptive.chosen() ? 255 : 128;
    for (int y = run.y * stride; y < std::min((run.y + 1) * stride, s.region.height); ++y) {
      for (int x = run.begin * stride; x < std::min(run.end * stride, s.region.width); ++x) put(x, y, value);
    }
  }
}

}  // namespace fyd::sensing
