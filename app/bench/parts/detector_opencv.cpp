#include "app/bench/parts/detector_opencv.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "core/sensing/finger_detector.h"

namespace fyd::bench {
namespace {

constexpr int kColumns = 13;
constexpr int kRows = 9;

std::size_t placeOf(int column, int row) {
  return static_cast<std::size_t>(row) * kColumns + static_cast<std::size_t>(column);
}

}  // namespace

OpenCvFinger::OpenCvFinger(const sensing::FingerParameters& parameters) : parameters_(parameters) {
  light_.setRegion(parameters.roi_width_px, parameters.roi_height_px);
  cells_.resize(std::size_t{kColumns} * kRows);
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      auto& cell = cells_[placeOf(i, j)];
      cell.u = light_.toU(static_cast<float>((i + 0.5) * parameters.roi_width_px / kColumns - 0.5));
      cell.v = light_.toV(static_cast<float>((j + 0.5) * parameters.roi_height_px / kRows - 0.5));
    }
  }
  light_picture_.create(parameters.roi_height_px, parameters.roi_width_px, CV_32F);
}

void OpenCvFinger::lightPicture() {
  for (int y = 0; y < light_picture_.rows; ++y) {
    light_.row(y, 0, light_picture_.cols, 1.0F, light_picture_.ptr<float>(y));
  }
}

void OpenCvFinger::markDark(const cv::Mat& grey) {
  grey.convertTo(grey_, CV_32F);
  lightPicture();
  cv::divide(grey_, light_picture_, share_);
  cv::compare(share_, mark_below_, marks_, cv::CMP_LT);
  (void)cv::connectedComponentsWithStats(marks_, labels_, stats_, centroids_, 8, CV_32S);
}

void OpenCvFinger::coverCells() {
  constexpr int kRim = 6;
  constexpr int kSpeck = 12;
  for (int blob = 1; blob < stats_.rows; ++blob) {
    if (stats_.at<int>(blob, cv::CC_STAT_AREA) < kSpeck) continue;
    const cv::Rect box(stats_.at<int>(blob, cv::CC_STAT_LEFT) - kRim, stats_.at<int>(blob, cv::CC_STAT_TOP) - kRim,
                       stats_.at<int>(blob, cv::CC_STAT_WIDTH) + 2 * kRim,
                       stats_.at<int>(blob, cv::CC_STAT_HEIGHT) + 2 * kRim);
    for (int j = 0; j < kRows; ++j) {
      for (int i = 0; i < kColumns; ++i) {
        const cv::Rect cell(i * marks_.cols / kColumns, j * marks_.rows / kRows, marks_.cols / kColumns + 1,
                            marks_.rows / kRows + 1);
        if ((cell & box).area() > 0) cells_[placeOf(i, j)].weight = 0.0F;
      }
    }
  }
}

int OpenCvFinger::largestBlob() const {
  int best = 0;
  int best_area = 11;
  for (int blob = 1; blob < stats_.rows; ++blob) {
    const int area = stats_.at<int>(blob, cv::CC_STAT_AREA);
    if (area <= best_area) continue;
    best = blob;
    best_area = area;
  }
  return best;
}

sensing::FingerDetection OpenCvFinger::detect(const ImageView& picture) {
  const cv::Mat whole(picture.height, picture.width, CV_8UC1, const_cast<std::uint8_t*>(picture.data),
                      static_cast<std::size_t>(picture.stride));
  const cv::Mat grey =
      whole(cv::Rect(parameters_.roi_x_px, parameters_.roi_y_px, parameters_.roi_width_px, parameters_.roi_height_px));
  sensing::FingerDetection out;
  out.reason = sensing::FingerReason::no_finger;

  // Light: mean grey of cells, known from the last picture or found anew.
  cv::resize(grey, cell_greys_, {kColumns, kRows}, 0, 0, cv::INTER_AREA);
  int off = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    auto& cell = cells_[i];
    cell.grey = cell_greys_.data[i];
    cell.weight = 1.0F;
    if (std::abs(cell.grey - light_.at(cell.u, cell.v)) > 0.06F * cell.grey) ++off;
  }
  if (!light_known_ || off > 40) {
    if (!light_.fitUnknown(cells_)) return out;
    light_known_ = true;
    for (auto& cell : cells_) cell.weight = 1.0F;
  }
  markDark(grey);
  coverCells();
  (void)light_.fit(cells_);
  lightPicture();
  cv::divide(grey_, light_picture_, share_);
  cv::subtract(cv::Scalar(1.0), share_, darkness_);

  const int chosen = largestBlob();
  if (chosen == 0) return out;
  cv::compare(labels_, chosen, blob_, cv::CMP_EQ);
  const double radius = std::sqrt(stats_.at<int>(chosen, cv::CC_STAT_AREA) / CV_PI);
  const int inside = std::max(1, static_cast<int>(std::lround(0.4 * radius)));
  const auto square = [](int by) { return cv::getStructuringElement(cv::MORPH_RECT, {2 * by + 1, 2 * by + 1}); };
  cv::erode(blob_, core_, square(inside));
  const double contrast = cv::mean(darkness_, core_)[0];
  cv::dilate(blob_, rim_, square(5));
  weights_.create(darkness_.size(), CV_32F);
  weights_.setTo(0.0);
  darkness_.copyTo(weights_, rim_);
  const cv::Moments sums = cv::moments(weights_, false);
  if (!(sums.m00 > 0.0) || !(contrast >= parameters_.minimum_contrast)) return out;
  mark_below_ = static_cast<float>(1.0 - 0.5 * contrast);

  out.area_px = sums.m00 / contrast;
  out.contact =
      out.area_px * parameters_.scale_x_mm_per_px * parameters_.scale_y_mm_per_px > parameters_.minimum_area_mm2;
  out.x_px = parameters_.roi_x_px + sums.m10 / sums.m00;
  out.y_px = parameters_.roi_y_px + sums.m01 / sums.m00;
  sensing::toMillimetres(parameters_, out.x_px, out.y_px, out.x_mm, out.y_mm);
  out.quality = 1.0;
  out.reason = sensing::FingerReason::found;
  return out;
}

}  // namespace fyd::bench
