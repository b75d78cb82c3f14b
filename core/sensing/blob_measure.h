// Area and centroid of one blob from its pixels' darkness d = 1 − I/B, not from a threshold:
//   D = mean of d well inside the blob,  area = Σd/D,  centroid = Σd·(x, y)/Σd
// over the blob and a rim around it. Blur spreads darkness without changing these sums, and noise averages out of them.
#pragma once

#include <cstdint>
#include <vector>

#include "core/sensing/dark_runs.h"
#include "core/sensing/light_surface.h"

namespace fyd::sensing {

struct BlobMeasure {
  double area_px = 0.0;  ///< of the working grid
  double x = 0.0;        ///< centroid, column of the working grid
  double y = 0.0;
  double contrast = 0.0;  ///< D, 0…1
  double edge_px = 0.0;   ///< standard deviation of the edge's blur, approximate
};

class BlobMeter {
 public:
  /// Room for any blob of a region of this size.
  void resize(int width, int height);

  /// @param greyRow called as greyRow(y, buffer) for a row of the region; returns its `width` greys, in buffer or
  /// elsewhere
  /// @param blob index into runs.blobs()
  template <class GreyRow>
  [[nodiscard]] BlobMeasure measure(const DarkRuns& runs, int blob, const LightSurface& light, GreyRow&& greyRow) {
    place(runs, blob);
    for (int y = top_; y < bottom_; ++y) readRow(y, greyRow(y, grey_.data()) + left_, light);
    eraseOthers(runs, blob);
    return weigh(runs.blobs()[static_cast<std::size_t>(blob)]);
  }

 private:
  struct Span {
    int begin = 0;
    int end = 0;
  };

  void place(const DarkRuns& runs, int blob);
  void readRow(int y, const std::uint8_t* grey, const LightSurface& light);
  void eraseOthers(const DarkRuns& runs, int blob);
  [[nodiscard]] BlobMeasure weigh(const DarkBlob& blob) const;
  [[nodiscard]] Span widened(int y, int by) const;
  [[nodiscard]] Span narrowed(int y, int by) const;
  [[nodiscard]] double meanInside(int by, int& pixels) const;
  [[nodiscard]] const float* darkness(int y) const;

  int width_ = 0;
  int height_ = 0;
  int left_ = 0;  // of the patch read, in the region
  int top_ = 0;
  int right_ = 0;
  int bottom_ = 0;
  std::vector<Span> extent_;     // of the blob in each row; empty: begin = end
  std::vector<float> darkness_;  // patch
  std::vector<float> light_row_;
  std::vector<std::uint8_t> grey_;
};

}  // namespace fyd::sensing
