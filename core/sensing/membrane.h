// Shape of the cloth under the finger: a stretched membrane clamped on its frame and pushed by a flat disc.
//
// Small displacements u of a membrane under even tension obey Laplace's equation ∇²u = 0 between the frame
// (u = 0) and the disc (u = 1). Off the disc
//
//   u(x) = [G(x, x₀) + D·∇₀G(x, x₀)] / U,    D = −2πr² g,    U = −ln(r)/2π + h − 2πr²|g|²
//
// where G is Green's function of the rectangle, h and g its regular part and that part's gradient at the finger
// x₀, r the disc's radius. The dipole D makes the disc's rim level to first order in r over the distance to the
// frame. G is summed from the closed form for an infinite strip, mirrored at the two short sides; terms of the
// series fall by exp(−2πL/B) (L long, B short side): one mirror either way leaves 1e−6 for the 100 × 70 mm frame.
// Against a finite-difference solution: 0.03 at worst at the disc's rim while the finger keeps 1.5 r from the frame.
//
// The theory is for an unstretched, linear membrane; hysteresis, the roller's sag and wrinkles are not in it.
#pragma once

namespace fyd::sensing {

class Membrane {
 public:
  /// Half sides of the frame and the radius of the finger's disc, mm. Values that make no membrane (not finite,
  /// not positive, a disc wider than the frame) are brought to the nearest that do.
  explicit Membrane(double half_width_mm = 50, double half_depth_mm = 35, double finger_radius_mm = 7);

  /// Displacement at (x, y) per unit of displacement at the finger, 0…1: 1 under the disc, 0 on and beyond the
  /// frame. A disc that would overlap the frame is moved inwards until it touches. Anything not finite gives 0.
  [[nodiscard]] double shape(double x_mm, double y_mm, double finger_x_mm, double finger_y_mm) const;

  [[nodiscard]] double halfWidth_mm() const { return half_width_mm_; }
  [[nodiscard]] double halfDepth_mm() const { return half_depth_mm_; }
  [[nodiscard]] double fingerRadius_mm() const { return finger_radius_mm_; }

 private:
  double half_width_mm_;
  double half_depth_mm_;
  double finger_radius_mm_;
};

}  // namespace fyd::sensing
