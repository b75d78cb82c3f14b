// Estimates position and stiffness of a surface from a device's position, velocity and force while it presses.
//
// Least squares over the last distinct points of contact: f = K·(x − surface) + D·v.
// Points are distinct when position and force have changed, so that a press at rest does not push out older points.
// When the measured force no longer fits, the surface has moved or changed: the points are discarded, the stiffness is
// kept, and the surface is set from the newest force.
#pragma once

#include <array>
#include <cstddef>

namespace fyd::teleop {

class SurfaceEstimator {
 public:
  static constexpr double kContact_N = 0.25, kNoContact_N = 0.12;
  /// Further than this beyond the surface without a force: the surface is gone.
  static constexpr double kBeyond_m = 0.002;
  static constexpr double kLeast_N_per_m = 20.0, kMost_N_per_m = 20'000.0;

  /// At each step of 1 ms. Inputs that are not finite are ignored.
  void step(double position_m, double velocity_m_per_s, double force_N);

  [[nodiscard]] bool touching() const { return touching_; }
  [[nodiscard]] bool known() const { return known_; }
  [[nodiscard]] double surface_m() const { return surface_m_; }
  [[nodiscard]] double stiffness_N_per_m() const { return stiffness_; }

 private:
  void fit();

  struct Point {
    double position_m, velocity_m_per_s, force_N;
  };
  static constexpr std::size_t kPoints = 128;
  std::array<Point, kPoints> points_{};
  std::size_t count_ = 0, next_ = 0;
  bool touching_ = false;
  bool known_ = false;
  double surface_m_ = 0.0;
  double stiffness_ = 0.0;
  double smooth_N_ = 0.0;
  double smooth_m_ = 0.0;
  double smooth_m_per_s_ = 0.0;
  bool smoothing_ = false;
  int misfit_steps_ = 0;
  int air_steps_ = 0;
};

}  // namespace fyd::teleop
