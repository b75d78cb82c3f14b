// The adaptive finger detector behind finger_detector.h: one pass over the region makes marks, runs, blobs and cell
// means from the light learned so far; the light is then fitted to this picture's own cells, and the chosen blob
// measured against that. When the light or the finger's darkness has jumped, or is not known yet, the pass is made
// again.
#pragma once

#include <cstdint>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/base/image.h"
#include "core/sensing/blob_measure.h"
#include "core/sensing/dark_runs.h"
#include "core/sensing/finger_parameters.h"
#include "core/sensing/finger_types.h"
#include "core/sensing/light_surface.h"

namespace fyd::sensing {

class AdaptiveFinger {
 public:
  void reset();
  [[nodiscard]] FingerDetection detect(const ImageView& picture, const RegionOfInterest& region,
                                       const FingerParameters& parameters);

  [[nodiscard]] const DarkRuns& runs() const { return runs_; }
  /// Blob of the last finger, −1 without one.
  [[nodiscard]] int chosen() const { return chosen_; }
  [[nodiscard]] int stride() const { return stride_; }

 private:
  void resize(const RegionOfInterest& region, int stride);
  void takePicture(const ImageView& picture);
  /// One row of the working grid as grey.
  [[nodiscard]] const std::uint8_t* greyRow(int y, std::uint8_t* buffer) const;
  void pass();
  void passAgain();
  /// What the picture shows.
  [[nodiscard]] FingerDetection look();
  [[nodiscard]] float markBelow(float share) const;
  void closeCells(int row);
  void coverCells();
  [[nodiscard]] bool learnLight();
  /// Least area of a touch, in pixels of the working grid.
  [[nodiscard]] double smallestArea_px() const;
  [[nodiscard]] int chooseBlob(int& candidates) const;
  [[nodiscard]] FingerDetection judge();
  [[nodiscard]] bool unusable(FingerDetection& out) const;

  FingerParameters parameters_;
  RegionOfInterest region_;
  const std::uint8_t* top_left_ = nullptr;  // of the region, grey
  std::ptrdiff_t pitch_ = 0;
  cv::Mat luma_;  // of the region, when the picture has colours
  int stride_ = 0;
  int width_ = 0;  // of the working grid
  int height_ = 0;
  int cell_columns_ = 0;
  int cell_rows_ = 0;

  LightSurface light_;
  bool light_known_ = false;
  float mark_below_ = 0.85F;  // of the light: darker pixels are marked
  bool has_last_ = false;     // a recent finger is known, at (last_x_, last_y_)
  double last_x_ = 0.0;
  double last_y_ = 0.0;
  int since_last_ = 0;  // pictures
  int chosen_ = -1;
  std::uint8_t darkest_ = 0;
  std::uint8_t brightest_ = 0;

  DarkRuns runs_;
  BlobMeter meter_;
  std::vector<LightSurface::Cell> cells_;
  std::vector<float> cell_light_;           // that the pass used
  std::vector<std::uint16_t> column_sums_;  // of the present row of cells
  std::vector<std::uint8_t> column_least_;
  std::vector<std::uint8_t> column_most_;
  std::vector<std::uint8_t> marks_;
  std::vector<std::uint8_t> limits_;
  std::vector<std::uint8_t> grey_;
  std::vector<float> light_row_;
};

}  // namespace fyd::sensing
