#include "core/sensing/dark_runs.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace fyd::sensing {
namespace {

/// First column from `x` on whose mark is (not) 0, eight at a time.
int findMark(const std::uint8_t* marks, int x, int width, bool dark) {
  while (x < width) {
    std::uint64_t word = 0;
    std::memcpy(&word, marks + x, sizeof word);
    if constexpr (std::endian::native == std::endian::little) {
      // Marks are 0 or 255, so a byte's lowest bit tells.
      const std::uint64_t hits = (dark ? word : ~word) & 0x0101010101010101ULL;
      if (hits != 0) return std::min(width, x + std::countr_zero(hits) / 8);
      x += 8;
    } else {
      if ((marks[x] != 0) == dark) return x;
      ++x;
    }
  }
  return width;
}

}  // namespace

void DarkRuns::resize(int width, int height) {
  width_ = width;
  const std::size_t most = static_cast<std::size_t>(width / 2 + 1) * static_cast<std::size_t>(height);
  runs_.clear();
  blobs_.clear();
  runs_.reserve(most);
  blobs_.reserve(most);
}

void DarkRuns::clear() {
  runs_.clear();
  blobs_.clear();
  above_ = current_ = 0;
}

std::int32_t DarkRuns::root(std::int32_t run) {
  while (runs_[static_cast<std::size_t>(run)].blob != run) {
    DarkRun& r = runs_[static_cast<std::size_t>(run)];
    r.blob = runs_[static_cast<std::size_t>(r.blob)].blob;  // path halving
    run = r.blob;
  }
  return run;
}

void DarkRuns::join(std::int32_t a, std::int32_t b) {
  a = root(a);
  b = root(b);
  if (a != b) runs_[static_cast<std::size_t>(std::max(a, b))].blob = std::min(a, b);
}

void DarkRuns::addRow(int y, const std::uint8_t* marks) {
  above_ = current_;
  current_ = runs_.size();
  if (above_ == current_ || runs_[above_].y != y - 1) above_ = current_;  // nothing stands directly above
  std::size_t candidate = above_;
  for (int x = findMark(marks, 0, width_, true); x < width_;) {
    const int end = findMark(marks, x, width_, false);
    const auto own = static_cast<std::int32_t>(runs_.size());
    runs_.push_back({.y = y, .begin = x, .end = end, .blob = own});
    while (candidate < current_ && runs_[candidate].end < x) ++candidate;
    for (std::size_t i = candidate; i < current_ && runs_[i].begin <= end; ++i) join(static_cast<std::int32_t>(i), own);
    x = findMark(marks, end, width_, true);
  }
}

void DarkRuns::finish() {
  blobs_.clear();
  // A root precedes all its descendants, so one pass in order gives every run its blob.
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    DarkRun& run = runs_[i];
    if (run.blob == static_cast<std::int32_t>(i)) {
      run.blob = static_cast<std::int32_t>(blobs_.size());
      blobs_.push_back({.left = run.begin, .top = run.y, .right = run.end, .bottom = run.y + 1});
    } else {
      run.blob = runs_[static_cast<std::size_t>(run.blob)].blob;
    }
    DarkBlob& blob = blobs_[static_cast<std::size_t>(run.blob)];
    const int length = run.end - run.begin;
    blob.pixels += length;
    blob.sum_x += 0.5 * length * (run.begin + run.end - 1);
    blob.sum_y += static_cast<double>(length) * run.y;
    blob.left = std::min(blob.left, run.begin);
    blob.right = std::max(blob.right, run.end);
    blob.bottom = std::max(blob.bottom, run.y + 1);
  }
}

}  // namespace fyd::sensing
