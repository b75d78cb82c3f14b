// Shape of the cloth under the finger: a stretched membrane on its frame, pushed by a finger.
//
// Small displacements u of a membrane under even tension obey Laplace's equation ∇²u = 0 between the frame
// (u = 0) and a disc (u = 1). Off the disc
//
//   u(x) = [G(x, x₀) + D·∇₀G(x, x₀)] / U,    D = −2πr² g,    U = −ln(r)/2π + h − 2πr²|g|²
//
// where G is Green's function of the rectangle, h and g its regular part and that part's gradient at the finger
// x₀, r the disc's radius. The dipole D makes the disc's rim level to first order in r over the distance to the
// frame. G is summed from the closed form for an infinite strip, mirrored at its two ends; terms of the
// series fall by exp(−2πL/B) (L the strip's length, B its breadth): one mirror either way leaves 1e−6 for the
// 100 × 70 mm frame. Against a finite-difference solution: 0.03 at worst at the disc's rim while the finger keeps
// 1.5 r from the frame.
//
// Different tensions along x and y: (Tx·∂²/∂x² + Ty·∂²/∂y²)u = 0 becomes Laplace's equation in x·(Ty/Tx)^¼,
// y·(Tx/Ty)^¼. Free front and back edges (a cloth between two rollers): ∂u/∂n = 0 there, mirrors without their sign.
//
// A round finger touches more and more of the cloth as it presses. Off a contact of radius a the cloth looks as if
// pushed by a smaller disc, r = κ·a (a paraboloid on an even membrane: κ = e^−½ = 0.61; a flat disc: κ = 1). Inside
// the contact the cloth follows the finger: u = 1 − (d/a)²·(1 − u(a)), which meets the outer part at its rim.
//
// The theory is linear; hysteresis, wrinkles and the growth of tension with depth are not in it.
// Stability: may change
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "core/base/api.h"

namespace fyd::sensing {

enum class ClothEdges : std::uint8_t {
  held,     ///< on all four sides
  rollers,  ///< held left and right by the rollers; front and back free
};
inline constexpr std::array<std::string_view, 2> kClothEdgesNames = {"held", "rollers"};

/// Share of the indentation at a place, and how it follows the effective radius.
struct MembraneShare {
  double value = 0.0;           ///< 0…1
  double per_log_radius = 0.0;  ///< d value / d ln r
};

class FYD_API Membrane {
 public:
  /// Half sides of the frame and the radius of the finger's disc, mm; tension along x over that along y. Values that
  /// make no membrane (not finite, not positive, a disc wider than the frame) are brought to the nearest that do.
  explicit Membrane(double half_width_mm = 50, double half_depth_mm = 35, double finger_radius_mm = 7,
                    ClothEdges edges = ClothEdges::held, double tension_ratio = 1);

  /// Displacement at (x, y) per unit of displacement at the finger, 0…1: 1 under the disc, 0 on and beyond the
  /// frame. A disc that would overlap the frame is moved inwards until it touches. Anything not finite gives 0.
  [[nodiscard]] double shape(double x_mm, double y_mm, double finger_x_mm, double finger_y_mm) const;

  /// The cloth pressed by a round finger at one place; what depends on the finger alone is computed once.
  class Press {
   public:
    /// Share at (x, y), as `shape`, with the contact's own shape inside it.
    [[nodiscard]] MembraneShare share(double x_mm, double y_mm) const;
    /// Indentation times tension per force: U above.
    [[nodiscard]] double level() const { return level_; }
    /// The same press with another effective radius.
    void setEffectiveRadius(double radius_mm);

   private:
    friend class Membrane;
    [[nodiscard]] MembraneShare outside(double x_mm, double y_mm) const;

    const Membrane* membrane_ = nullptr;  // outlives the press
    bool known_ = false;
    double x_mm_ = 0.0;
    double y_mm_ = 0.0;
    double contact_mm_ = 0.0;
    double dipole_ = 0.0;
    double regular_ = 0.0;  // at the finger, and its gradient
    double along_ = 0.0;
    double across_ = 0.0;
    double from_ = 0.0;  // where along the frame the strip begins
    double level_ = 1.0;
    double level_per_log_radius_ = 0.0;
  };
  /// @param contact_radius_mm of the patch that touches; @param effective_radius_mm r of the disc it looks like from
  ///        afar
  [[nodiscard]] Press press(double finger_x_mm, double finger_y_mm, double contact_radius_mm,
                            double effective_radius_mm) const;

  /// Distance to the nearest edge that is held; negative outside.
  [[nodiscard]] double toHeldEdge(double x_mm, double y_mm) const;

 private:
  struct Place {
    double along = 0.0;   // of the frame, from its end
    double across = 0.0;  // from its side
  };
  [[nodiscard]] Place place(double x_mm, double y_mm) const;

  double half_width_mm_;
  double half_depth_mm_;
  double finger_radius_mm_;
  double scale_x_ = 1.0;
  double scale_y_ = 1.0;
  double length_ = 0.0;        // of the strip, scaled
  double breadth_ = 0.0;       // of the strip, scaled
  double whole_length_ = 0.0;  // of the frame along the strip, scaled
  double mirror_ = -1.0;       // sign of a mirror at the strip's ends: +1 where they are free
  bool across_is_x_ = false;
};

}  // namespace fyd::sensing
