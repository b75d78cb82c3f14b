// A cloth pressed by a finger, as solved once by finite elements and tabulated: force, contact patch and shape over
// place, depth and stretch. resources/cloths/make_cloths.py makes the tables and documents their contents; the
// estimator (core/sensing) must not use them.
//
// Interpolation: over places a cubic through four nodes (Hermite, slopes from three points), mirrored where the cloth
// is symmetric; over depth a monotone cubic (Fritsch and Carlson) from 0 at the surface; over stretch linear, also
// beyond the ends. Places beyond the outermost node take its values.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/base/error.h"

namespace fyd::sim {

/// What the finger feels and the camera sees.
struct Pressing {
  double force_N = 0.0;
  double area_mm2 = 0.0;     ///< of the contact, seen from straight below
  double centre_x_mm = 0.0;  ///< of the contact, from the finger's tip
  double centre_y_mm = 0.0;
};

class ClothTable {
 public:
  /// @return an error that names the fault and its place in the text
  [[nodiscard]] static Result<ClothTable> parse(std::string_view text);

  /// @param depth_mm ≤ 0 and NaN: nothing is pressed
  /// @param reference_N_per_mm identifies the stretch: the stiffness that a sphere of 8 mm meets 3 mm deep in the
  /// middle
  [[nodiscard]] Pressing press(double x_mm, double y_mm, double depth_mm, double reference_N_per_mm) const;

  /// Deflection at (x, y) over the depth of the finger, 0…1.
  [[nodiscard]] double shape(double x_mm, double y_mm, double finger_x_mm, double finger_y_mm, double depth_mm) const;

  [[nodiscard]] double deepest_mm() const { return depths_.back(); }

 private:
  /// Up to four nodes and their weights.
  struct Taps {
    std::array<std::size_t, 4> node{};
    std::array<double, 4> weight{};
  };

  static constexpr std::size_t kQuantities = 4, kStretches = 2, kMostNodes = 64;
  using Depths = std::array<double, kMostNodes>;

  ClothTable() = default;
  [[nodiscard]] static Taps tapsAt(const std::vector<double>& axis, double at, bool mirrored);
  [[nodiscard]] double overDepth(const Depths& values, bool from_nothing, double depth_mm) const;
  [[nodiscard]] double morphed(double distance_mm, double finger_mm, double edge_mm) const;

  double half_width_mm_ = 0.0;
  double half_depth_mm_ = 0.0;
  double near_mm_ = 0.0;
  bool mirrored_y_ = true;
  bool whole_at_once_ = false;  // a disc touches with all its area from the start
  std::array<double, kStretches> reference_{};
  std::vector<double> x_, y_, depths_, grid_;
  std::vector<double> pressings_;  // [x][y][quantity][stretch][depth]
  std::vector<double> shapes_;     // [x][y][depth][grid x][grid y]
};

}  // namespace fyd::sim
