// The light on the untouched cloth as a smooth surface over the region of interest, fitted to the mean greys of cells.
//
//   B(u, v) = c₀ + c₁u + c₂v + c₃u² + c₄uv + c₅v² + (c₆u + c₇v)·r² + c₈r⁴,   r² = u² + v²
//
// with (u, v) from the region's middle in half widths: a slope and a lens' fall-off, and the product of both.
#pragma once

#include <array>
#include <span>

namespace fyd::sensing {

class LightSurface {
 public:
  struct Cell {
    float u = 0.0F;  ///< middle of the cell, half widths from the region's middle
    float v = 0.0F;
    float grey = 0.0F;  ///< mean
    float weight = 0.0F;
  };

  /// @param width,height of the region, px
  void setRegion(int width, int height);

  /// Least squares over the cells with weight > 0; leaves out those that then stand more than 3 % off, once.
  /// @return false, and nothing changed, when too few cells are left
  bool fit(std::span<Cell> cells);
  /// The same when nothing is known of where the finger is: follows the brighter cells. Sets the weights.
  bool fitUnknown(std::span<Cell> cells);

  /// Light at columns first … first + count − 1 of a row, times `factor`; at least 1.
  void row(int y, int first, int count, float factor, float* out) const;
  [[nodiscard]] float at(float u, float v) const;
  [[nodiscard]] float toU(float x) const { return (x - middle_x_) * scale_; }
  [[nodiscard]] float toV(float y) const { return (y - middle_y_) * scale_; }

 private:
  static constexpr int kTerms = 9;
  [[nodiscard]] bool solve(std::span<const Cell> cells, int terms);
  [[nodiscard]] bool findUnknown(std::span<Cell> cells);

  std::array<float, kTerms> c_{};
  float middle_x_ = 0.0F;
  float middle_y_ = 0.0F;
  float scale_ = 1.0F;
};

}  // namespace fyd::sensing
