// Connected dark blobs from rows of marks: runs of dark pixels, joined to touching runs of the row above
// (diagonals count) by union-find. One pass; no allocation after resize.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace fyd::sensing {

struct DarkRun {
  std::int32_t y = 0;
  std::int32_t begin = 0;  ///< first column
  std::int32_t end = 0;    ///< column after the last
  std::int32_t blob = -1;  ///< index into blobs() after finish()
};

struct DarkBlob {
  std::int32_t pixels = 0;
  double sum_x = 0.0;
  double sum_y = 0.0;
  std::int32_t left = 0;
  std::int32_t top = 0;
  std::int32_t right = 0;   ///< column after the last
  std::int32_t bottom = 0;  ///< row after the last

  [[nodiscard]] double x() const { return sum_x / pixels; }
  [[nodiscard]] double y() const { return sum_y / pixels; }
};

class DarkRuns {
 public:
  /// Room for any picture of this size.
  void resize(int width, int height);
  void clear();

  /// @param marks `width` bytes, not 0 where dark, followed by 8 bytes of 0. Rows come in order; rows without a
  ///   dark pixel need not be added.
  void addRow(int y, const std::uint8_t* marks);
  /// Joins and measures the blobs.
  void finish();

  [[nodiscard]] std::span<const DarkRun> runs() const { return {runs_.data(), runs_.size()}; }
  [[nodiscard]] std::span<const DarkBlob> blobs() const { return {blobs_.data(), blobs_.size()}; }

 private:
  [[nodiscard]] std::int32_t root(std::int32_t run);
  void join(std::int32_t a, std::int32_t b);

  int width_ = 0;
  std::vector<DarkRun> runs_;  // .blob holds the parent's index until finish()
  std::vector<DarkBlob> blobs_;
  std::size_t above_ = 0;    // first run of the row above
  std::size_t current_ = 0;  // first run of the present row
};

}  // namespace fyd::sensing
