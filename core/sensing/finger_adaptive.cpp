#include "core/sensing/finger_adaptive.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

#include "core/sensing/row_loops.h"

namespace fyd::sensing {
namespace {

constexpr int kCell_px = 16;         // columns and rows of a cell, about
constexpr int kLimitRows = 5;        // rows that share one row of limits: the light changes slowly
constexpr float kJump = 0.06F;       // of the light: a change that calls for a second pass
constexpr float kMarkStep = 0.05F;   // of the light: a wrong mark that calls for a second pass
constexpr int kForget_pictures = 5;  // without a finger, after which its place no longer counts
constexpr int kSpeck_px = 12;        // smaller blobs are noise
constexpr float kBlack = 12.0F;      // grey: no light
constexpr float kSaturated = 253.5F;
constexpr double kBlurred_px = 4.0;

}  // namespace

void AdaptiveFinger::reset() {
  light_known_ = false;
  has_last_ = false;
  chosen_ = -1;
  runs_.clear();
}

void AdaptiveFinger::resize(const RegionOfInterest& region, int stride) {
  region_ = region;
  stride_ = stride;
  width_ = (region.width + stride - 1) / stride;
  height_ = (region.height + stride - 1) / stride;
  cell_columns_ = std::clamp(width_ / kCell_px, 8, 24);
  cell_rows_ = std::clamp(height_ / kCell_px, 6, 24);
  light_.setRegion(width_, height_);
  runs_.resize(width_, height_);
  meter_.resize(width_, height_);
  const auto columns = static_cast<std::size_t>(width_);
  cells_.assign(static_cast<std::size_t>(cell_columns_) * static_cast<std::size_t>(cell_rows_), {});
  for (int j = 0; j < cell_rows_; ++j) {
    const int top = j * height_ / cell_rows_, bottom = (j + 1) * height_ / cell_rows_;
    for (int i = 0; i < cell_columns_; ++i) {
      const int place = j * cell_columns_ + i;
      const int left = i * width_ / cell_columns_, right = (i + 1) * width_ / cell_columns_;
      LightSurface::Cell& cell = cells_[static_cast<std::size_t>(place)];
      cell.u = light_.toU(0.5F * static_cast<float>(left + right - 1));
      cell.v = light_.toV(0.5F * static_cast<float>(top + bottom - 1));
    }
  }
  cell_light_.assign(cells_.size(), 0.0F);
  column_sums_.assign(columns, 0);
  column_least_.assign(columns, 0);
  column_most_.assign(columns, 0);
  marks_.assign(columns + sizeof(std::uint64_t), 0);
  limits_.assign(columns, 0);
  grey_.assign(columns, 0);
  light_row_.assign(columns, 0.0F);
  reset();
}

/// Colour is made grey once; the passes and the look at the blob then read grey rows in place.
void AdaptiveFinger::takePicture(const ImageView& picture) {
  if (picture.channels == 1) {
    top_left_ = picture.row(region_.y) + region_.x;
    pitch_ = picture.stride;
    return;
  }
  const cv::Mat colour(region_.height, region_.width, CV_8UC3,
                       const_cast<std::uint8_t*>(picture.row(region_.y) + std::ptrdiff_t{3} * region_.x),  // read only
                       static_cast<std::size_t>(picture.stride));
  cv::cvtColor(colour, luma_, cv::COLOR_BGR2GRAY);
  top_left_ = luma_.data;
  pitch_ = static_cast<std::ptrdiff_t>(luma_.step);
}

const std::uint8_t* AdaptiveFinger::greyRow(int y, std::uint8_t* buffer) const {
  const std::uint8_t* row = top_left_ + std::ptrdiff_t{y} * stride_ * pitch_;
  if (stride_ == 1) return row;
  for (int x = 0; x < width_; ++x) buffer[x] = row[std::ptrdiff_t{x} * stride_];
  return buffer;
}

void AdaptiveFinger::pass() {
  runs_.clear();
  std::fill(column_sums_.begin(), column_sums_.end(), std::uint16_t{0});
  std::fill(column_least_.begin(), column_least_.end(), std::uint8_t{255});
  std::fill(column_most_.begin(), column_most_.end(), std::uint8_t{0});
  int cell_row = 0;
  int cell_end = height_ / cell_rows_;
  for (int y = 0; y < height_; ++y) {
    if (light_known_ && y % kLimitRows == 0) {
      light_.row(std::min(y + kLimitRows / 2, height_ - 1), 0, width_, mark_below_, light_row_.data());
      toLimits(light_row_.data(), width_, limits_.data());
    }
    const std::uint8_t* grey = greyRow(y, grey_.data());
    gather(grey, width_, column_sums_.data(), column_least_.data(), column_most_.data());
    if (light_known_ && mark(grey, limits_.data(), width_, marks_.data()) != 0) runs_.addRow(y, marks_.data());
    if (y + 1 == cell_end) {
      closeCells(cell_row++);
      cell_end = (cell_row + 1) * height_ / cell_rows_;
    }
  }
  runs_.finish();
  darkest_ = *std::min_element(column_least_.begin(), column_least_.end());
  brightest_ = *std::max_element(column_most_.begin(), column_most_.end());
}

void AdaptiveFinger::closeCells(int row) {
  const int rows = (row + 1) * height_ / cell_rows_ - row * height_ / cell_rows_;
  for (int i = 0; i < cell_columns_; ++i) {
    const int begin = i * width_ / cell_columns_;
    const int end = (i + 1) * width_ / cell_columns_;
    std::uint32_t sum = 0;
    for (int x = begin; x < end; ++x) sum += column_sums_[static_cast<std::size_t>(x)];
    const int place = row * cell_columns_ + i;
    LightSurface::Cell& cell = cells_[static_cast<std::size_t>(place)];
    cell.grey = static_cast<float>(sum) / static_cast<float>(rows * (end - begin));
    cell.weight = 1.0F;
  }
  std::fill(column_sums_.begin(), column_sums_.end(), std::uint16_t{0});
}

/// Cells that a blob or its soft edge touches say nothing about the light.
void AdaptiveFinger::coverCells() {
  constexpr int kRim_px = 6;
  for (const DarkBlob& blob : runs_.blobs()) {
    if (blob.pixels < kSpeck_px) continue;
    for (int j = 0; j < cell_rows_; ++j) {
      if ((j + 1) * height_ / cell_rows_ <= blob.top - kRim_px || j * height_ / cell_rows_ >= blob.bottom + kRim_px)
        continue;
      for (int i = 0; i < cell_columns_; ++i) {
        if ((i + 1) * width_ / cell_columns_ <= blob.left - kRim_px) continue;
        if (i * width_ / cell_columns_ >= blob.right + kRim_px) continue;
        const int place = j * cell_columns_ + i;
        cells_[static_cast<std::size_t>(place)].weight = 0.0F;
      }
    }
  }
}

/// A share of the light as a mark: never darker than `kDarkest`, and pale enough for the least contrast alone.
float AdaptiveFinger::markBelow(float share) const {
  constexpr float kDarkest = 0.3F;
  const float widest = 1.0F - static_cast<float>(parameters_.minimum_contrast);
  return std::clamp(share, std::min(kDarkest, widest), widest);
}

/// @return whether the light that the pass used matches this picture's
bool AdaptiveFinger::learnLight() {
  float darkest_share = 1.0F;
  if (light_known_) {
    coverCells();
    for (std::size_t i = 0; i < cells_.size(); ++i) cell_light_[i] = light_.at(cells_[i].u, cells_[i].v);
    // Most uncovered cells must still match the learned light; otherwise it is learned anew.
    std::size_t off = 0;
    std::size_t bare = 0;
    for (std::size_t i = 0; i < cells_.size(); ++i) {
      if (!(cells_[i].weight > 0.0F)) continue;
      ++bare;
      if (std::abs(cells_[i].grey - cell_light_[i]) > kJump * cell_light_[i]) ++off;
    }
    if (2 * bare >= cells_.size() && 8 * off < bare && light_.fit(cells_)) return true;
  }
  if (!light_.fitUnknown(cells_)) return true;  // nothing better to be had from this picture
  for (const LightSurface::Cell& cell : cells_) {
    darkest_share = std::min(darkest_share, cell.grey / light_.at(cell.u, cell.v));
  }
  mark_below_ = markBelow(0.5F * (1.0F + darkest_share));
  light_known_ = true;
  return false;
}

FingerDetection AdaptiveFinger::detect(const ImageView& picture, const RegionOfInterest& region,
                                       const FingerParameters& parameters) {
  parameters_ = parameters;
  const int stride = std::clamp(parameters.stride_px, 1, std::max(1, std::min(region.width, region.height) / 16));
  if (region.x != region_.x || region.y != region_.y || region.width != region_.width ||
      region.height != region_.height || stride != stride_) {
    resize(region, stride);
  }
  takePicture(picture);
  const FingerDetection out = look();
  ++since_last_;
  if (out.contact) {
    since_last_ = 0;
    has_last_ = true;
  } else if (since_last_ > kForget_pictures) {
    has_last_ = false;
  }
  top_left_ = nullptr;  // the caller's pixels are not kept
  return out;
}

FingerDetection AdaptiveFinger::look() {
  chosen_ = -1;
  pass();
  FingerDetection out;
  if (unusable(out)) {
    light_known_ = false;
    return out;
  }
  if (!learnLight()) passAgain();
  if (!light_known_) {
    out.reason = FingerReason::light_unknown;  // nothing was marked: it cannot be said that nothing touches the cloth
    return out;
  }
  const float marked_below = mark_below_;
  out = judge();
  // Marks made for a darker finger miss parts of this one, or all of it; those made for a paler one take in its soft
  // edge.
  if (mark_below_ > marked_below + kMarkStep || mark_below_ < marked_below - 2.0F * kMarkStep) {
    passAgain();
    out = judge();
  }
  return out;
}

void AdaptiveFinger::passAgain() {
  pass();
  coverCells();
  (void)light_.fit(cells_);  // too few bare cells: the light stands as it was
}

bool AdaptiveFinger::unusable(FingerDetection& out) const {
  if (static_cast<float>(brightest_) < kBlack) {
    out.reason = FingerReason::black_picture;
  } else if (darkest_ >= 250) {
    out.reason = FingerReason::saturated;
  } else if (darkest_ == brightest_) {
    out.reason = FingerReason::flat_picture;
  } else {
    float sum = 0.0F;
    float least = std::numeric_limits<float>::max();
    for (const LightSurface::Cell& cell : cells_) {
      sum += cell.grey;
      least = std::min(least, cell.grey);
    }
    const float mean = sum / static_cast<float>(cells_.size());
    if (mean < kBlack) {
      out.reason = FingerReason::black_picture;
    } else if (least > kSaturated) {
      out.reason = FingerReason::saturated;
    } else {
      return false;
    }
  }
  return true;
}

double AdaptiveFinger::smallestArea_px() const {
  const double one_px_mm2 = parameters_.scale_x_mm_per_px * parameters_.scale_y_mm_per_px * stride_ * stride_;
  return parameters_.minimum_area_mm2 / one_px_mm2;
}

int AdaptiveFinger::chooseBlob(int& candidates) const {
  const double smallest_px = smallestArea_px();
  const auto blobs = runs_.blobs();
  candidates = 0;
  int largest = -1;
  int nearest = -1;
  double nearest_distance = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < blobs.size(); ++i) {
    const DarkBlob& blob = blobs[i];
    if (blob.pixels < kSpeck_px) continue;
    if (largest < 0 || blob.pixels > blobs[static_cast<std::size_t>(largest)].pixels) largest = static_cast<int>(i);
    if (blob.pixels < 0.7 * smallest_px) continue;
    ++candidates;
    const double distance = std::hypot(blob.x() - last_x_, blob.y() - last_y_);
    if (distance < nearest_distance) {
      nearest_distance = distance;
      nearest = static_cast<int>(i);
    }
  }
  return has_last_ && nearest >= 0 ? nearest : largest;
}

FingerDetection AdaptiveFinger::judge() {
  FingerDetection out;
  int candidates = 0;
  chosen_ = chooseBlob(candidates);
  out.reason = FingerReason::no_finger;
  const float widest = markBelow(1.0F);
  if (chosen_ < 0) {
    mark_below_ = widest;
    return out;
  }
  const BlobMeasure m =
      meter_.measure(runs_, chosen_, light_, [this](int y, std::uint8_t* b) { return greyRow(y, b); });
  const double pixels = static_cast<double>(width_) * height_;
  const double area = std::min(m.area_px, pixels);
  out.area_px = area * stride_ * stride_;
  const bool dark_enough = m.contrast >= parameters_.minimum_contrast;
  if (!dark_enough || !(area > smallestArea_px())) {
    out.reason = dark_enough ? FingerReason::too_small : FingerReason::no_finger;
    chosen_ = -1;
    mark_below_ = widest;
    return out;
  }
  mark_below_ = markBelow(1.0F - 0.5F * static_cast<float>(m.contrast));
  last_x_ = m.x;
  last_y_ = m.y;
  out.contact = true;
  out.x_px = region_.x + m.x * stride_;
  out.y_px = region_.y + m.y * stride_;
  toMillimetres(parameters_, out.x_px, out.y_px, out.x_mm, out.y_mm);

  const DarkBlob& blob = runs_.blobs()[static_cast<std::size_t>(chosen_)];
  const bool cut = blob.left == 0 || blob.top == 0 || blob.right == width_ || blob.bottom == height_;
  const bool blurred = m.edge_px * stride_ > kBlurred_px;
  out.reason = candidates > 1 ? FingerReason::several
               : cut          ? FingerReason::at_edge
               : blurred      ? FingerReason::blurred
                              : FingerReason::found;
  out.quality = std::min(1.0, m.contrast / 0.4) * (candidates > 1 ? 0.7 : 1.0) * (cut ? 0.6 : 1.0) *
                std::min(1.0, 2.0 / std::max(m.edge_px * stride_, 0.1));
  return out;
}

}  // namespace fyd::sensing
