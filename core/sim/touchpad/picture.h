// The picture under the cloth: 320 × 240 grey, bright cloth, the finger a dark disc with a soft edge.
//
//   place   x_mm = (u − 150)·100/220, y_mm = −(v − 120)·70/150   (u right, v down; the region of interest is 220 × 150
//           at (40, 45))
//   cloth   245·light·(1 + gradient·(u/319 − ½))·(1 − vignette·(r/200)²), r in px from the picture's middle
//   finger  darkest grey 60, reached from 0.1 N on. Ideal cloth: radius 3.5 mm + 2.5 mm·(F/1 N)^⅓ about the finger, as
//           if the camera stood far away. The others: a disc of the contact's area about its centre, seen from
//           sim.cloth_height_mm below
//   noise   Gaussian, from a fixed table read at random offsets (each row another), so that a picture takes less than
//           0.5 ms
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/sim/sim_parameters.h"
#include "core/sim/touchpad/touchpad_world.h"

namespace fyd::sim {

inline constexpr int kPictureWidth_px = 320;
inline constexpr int kPictureHeight_px = 240;
inline constexpr double kMmPerPx_u = 100.0 / 220.0;  // along a row …
inline constexpr double kMmPerPx_v = 70.0 / 150.0;   // … and along a column

struct PicturePoint {
  double u_px = 0.0;
  double v_px = 0.0;
};

/// Where a point of the cloth appears.
[[nodiscard]] PicturePoint pictureOf(double x_mm, double y_mm);

/// A round spot on the cloth.
struct Spot {
  double x_mm = 0.0;
  double y_mm = 0.0;
  double area_mm2 = 0.0;
};
/// Place and size at which a spot depth_mm below the cloth's plane appears on that plane: both its distance from the
/// axis and its width are multiplied by H/(H − depth).
/// @param height_mm H, of the unpressed cloth over the camera, above depth_mm
[[nodiscard]] Spot seenFromBelow(const Spot& spot, double depth_mm, double height_mm);

/// The contact as the camera shows it, on the plane of the unpressed cloth. Lifted: no area.
[[nodiscard]] Spot seenSpot(const WorldSnapshot& world, const SimParameters& parameters);

class PictureRenderer {
 public:
  explicit PictureRenderer(const SimParameters& parameters);

  /// Deterministic in its arguments. Allocates only when `picture` is not yet 320 × 240, 8 bit, 1 channel.
  void render(const WorldSnapshot& world, std::mt19937_64& random, cv::Mat& picture) const;

 private:
  SimParameters parameters_;
  double edge_softness_mm_;
  std::int16_t finger_;              // grey × 16
  std::vector<std::int16_t> cloth_;  // grey × 16
  std::vector<std::int16_t> noise_;  // grey × 16
};

}  // namespace fyd::sim
