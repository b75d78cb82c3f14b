#include "core/sensing/blob_measure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fyd::sensing {
namespace {

constexpr int kWidestRim = 8;  // px: 2.5 standard deviations of the blur where "blurred" begins
constexpr int kNarrowestRim = 3;
constexpr int kEdgeReach = 4;          // px outside the blob in which its edge is looked at
constexpr int kEnoughInside = 12;      // px that give D; of a small blob a quarter
constexpr double kLeastPlateau = 0.6;  // of D: below it a blob is all edge
constexpr int kSpeck = 12;             // px: smaller blobs are noise

/// What blur leaves of a small disc's darkness in its middle: the mean over `core_px` about the middle of a disc
/// convolved with a Gaussian of standard deviation σ, over the sharp disc's. Series of Marcum's Q to the second order.
/// @param apparent_px Σd over that mean: the area as it looks before
double plateauShare(double apparent_px, double core_px, double sigma_px) {
  const double variance = 2.0 * sigma_px * sigma_px;
  double share = 1.0;
  for (int round = 0; round < 4; ++round) {
    const double q = share * apparent_px / (std::numbers::pi * variance);
    if (!(q < 12.0)) return share;
    const double lost = std::exp(-q) * (1.0 + 0.5 * q * core_px / (std::numbers::pi * variance));
    share = std::clamp(1.0 - lost, kLeastPlateau, 1.0);
  }
  return share;
}

}  // namespace

void BlobMeter::resize(int width, int height) {
  width_ = width;
  height_ = height;
  extent_.assign(static_cast<std::size_t>(height), {});
  darkness_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F);
  light_row_.assign(static_cast<std::size_t>(width), 1.0F);
  grey_.assign(static_cast<std::size_t>(width), 0);
}

const float* BlobMeter::darkness(int y) const {
  return darkness_.data() + static_cast<std::size_t>(y - top_) * static_cast<std::size_t>(right_ - left_);
}

void BlobMeter::place(const DarkRuns& runs, int index) {
  const DarkBlob& blob = runs.blobs()[static_cast<std::size_t>(index)];
  left_ = std::max(0, blob.left - kWidestRim);
  top_ = std::max(0, blob.top - kWidestRim);
  right_ = std::min(width_, blob.right + kWidestRim);
  bottom_ = std::min(height_, blob.bottom + kWidestRim);
  std::fill(extent_.begin() + top_, extent_.begin() + bottom_, Span{});
  for (const DarkRun& run : runs.runs()) {
    if (run.blob != index) continue;
    Span& row = extent_[static_cast<std::size_t>(run.y)];
    row = row.begin == row.end ? Span{run.begin, run.end}
                               : Span{std::min(row.begin, run.begin), std::max(row.end, run.end)};
  }
}

void BlobMeter::readRow(int y, const std::uint8_t* grey, const LightSurface& light) {
  const int count = right_ - left_;
  light.row(y, left_, count, 1.0F, light_row_.data());
  float* out = darkness_.data() + static_cast<std::size_t>(y - top_) * static_cast<std::size_t>(count);
  for (int i = 0; i < count; ++i) out[i] = 1.0F - static_cast<float>(grey[i]) / light_row_[static_cast<std::size_t>(i)];
}

void BlobMeter::eraseOthers(const DarkRuns& runs, int index) {
  constexpr int kRim = 2;
  const int count = right_ - left_;
  for (const DarkRun& run : runs.runs()) {
    if (run.blob == index || runs.blobs()[static_cast<std::size_t>(run.blob)].pixels < kSpeck) continue;
    const int from = std::max(left_, run.begin - kRim);
    const int to = std::min(right_, run.end + kRim);
    for (int y = std::max(top_, run.y - kRim); y < std::min(bottom_, run.y + kRim + 1); ++y) {
      float* row = darkness_.data() + static_cast<std::size_t>(y - top_) * static_cast<std::size_t>(count) - left_;
      for (int x = from; x < to; ++x) row[x] = 0.0F;
    }
  }
}

BlobMeter::Span BlobMeter::widened(int y, int by) const {
  Span out{right_, left_};
  for (int i = std::max(top_, y - by); i < std::min(bottom_, y + by + 1); ++i) {
    const Span& row = extent_[static_cast<std::size_t>(i)];
    if (row.begin == row.end) continue;
    out = {std::min(out.begin, row.begin), std::max(out.end, row.end)};
  }
  if (out.begin >= out.end) return {};
  return {std::max(left_, out.begin - by), std::min(right_, out.end + by)};
}

BlobMeter::Span BlobMeter::narrowed(int y, int by) const {
  // The region's border is no edge of the finger: a row beyond it counts as filled.
  const auto row = [&](int i) {
    if (i < 0 || i >= height_) return Span{0, width_};
    if (i < top_ || i >= bottom_) return Span{};
    return extent_[static_cast<std::size_t>(i)];
  };
  const Span own = row(y);
  const Span up = row(y - by);
  const Span down = row(y + by);
  return {std::max({own.begin == 0 ? 0 : own.begin + by, up.begin, down.begin}),
          std::min({own.end == width_ ? width_ : own.end - by, up.end, down.end})};
}

double BlobMeter::meanInside(int by, int& pixels) const {
  double sum = 0.0;
  pixels = 0;
  for (int y = top_; y < bottom_; ++y) {
    const Span span = narrowed(y, by);
    const float* d = darkness(y) - left_;
    float row_sum = 0.0F;
    for (int x = span.begin; x < span.end; ++x) row_sum += d[x];
    if (span.end > span.begin) pixels += span.end - span.begin;
    sum += static_cast<double>(row_sum);
  }
  return pixels > 0 ? sum / pixels : 0.0;
}

BlobMeasure BlobMeter::weigh(const DarkBlob& blob) const {
  BlobMeasure out;
  const double radius = std::sqrt(blob.pixels / std::numbers::pi);
  const int enough = std::clamp(blob.pixels / 4, 4, kEnoughInside);
  int inside = 0;
  for (int by = std::max(1, static_cast<int>(std::lround(0.4 * radius))); by >= 0 && enough > inside;
       by = by > 0 ? by / 2 : -1) {
    out.contrast = meanInside(by, inside);
  }
  const int looked = inside;
  if (!(out.contrast > 0.0)) return out;

  // Width of the edge: pixels between a quarter and three quarters dark, over the length of the edge.
  const auto low = static_cast<float>(0.25 * out.contrast);
  const auto high = static_cast<float>(0.75 * out.contrast);
  int between = 0;
  int border = 0;
  for (int y = top_; y < bottom_; ++y) {
    const Span span = widened(y, kEdgeReach);
    const float* d = darkness(y) - left_;
    for (int x = span.begin; x < span.end; ++x) between += d[x] > low && d[x] < high ? 1 : 0;
    const Span own = extent_[static_cast<std::size_t>(y)];
    border += (own.end > own.begin && own.begin > 0 ? 1 : 0) + (own.end > own.begin && own.end < width_ ? 1 : 0);
  }
  // Rows cross the edge twice; a disc's edge is π/2 times as long as its rows' crossings.
  const double edge_length = std::max(1.0, border * std::numbers::pi / 2.0);
  out.edge_px = between / edge_length / 1.35;  // a Gaussian edge goes from 1/4 to 3/4 in 1.35 σ

  const int rim = std::clamp(static_cast<int>(std::ceil(2.5 * out.edge_px + 1.0)), kNarrowestRim, kWidestRim);
  const int by = std::min(static_cast<int>(std::lround(2.5 * out.edge_px)), static_cast<int>(0.6 * radius));
  const double refined = meanInside(std::max(1, by), inside);
  int core = looked;
  if (inside >= enough && refined > 0.0) {
    out.contrast = refined;
    core = inside;
  }

  double sum = 0.0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  for (int y = top_; y < bottom_; ++y) {
    const Span span = widened(y, rim);
    const float* d = darkness(y) - left_;
    float row_sum = 0.0F;
    float row_x = 0.0F;
    for (int x = span.begin; x < span.end; ++x) {
      row_sum += d[x];
      row_x += d[x] * static_cast<float>(x - left_);
    }
    sum += static_cast<double>(row_sum);
    sum_x += static_cast<double>(row_x);
    sum_y += static_cast<double>(row_sum) * y;
  }
  if (!(sum > 0.0)) return out;
  out.contrast /= plateauShare(sum / out.contrast, core, out.edge_px);
  out.area_px = sum / out.contrast;
  out.x = std::clamp(left_ + sum_x / sum, 0.0, width_ - 1.0);
  out.y = std::clamp(sum_y / sum, 0.0, height_ - 1.0);
  return out;
}

}  // namespace fyd::sensing
