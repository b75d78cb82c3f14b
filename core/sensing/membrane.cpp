#include "core/sensing/membrane.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/portable_math.h"

namespace fyd::sensing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kMirrors = 1;  // either way: −2L, 0, +2L, each with its reflection

/// Green's function (or its regular part) at a point, with its gradient to the source's position.
struct Green {
  double value = 0.0;
  double along = 0.0;   // derivative to the source's coordinate along the strip
  double across = 0.0;  // derivative to the source's coordinate across the strip
};

/// Long side is [0, length], short side [0, breadth]; (x, y) the point, (xs, ys) the source.
/// `regular` leaves out −ln(ρ)/2π, and is meant for the point at the source.
Green green(double length, double breadth, double x, double y, double xs, double ys, bool regular) {
  const double p = kPi / breadth;
  const double cos_sum = math::cos(p * (y + ys));
  const double sin_sum = math::sin(p * (y + ys));
  const double cos_difference = math::cos(p * (y - ys));
  const double sin_difference = math::sin(p * (y - ys));
  double upper = 1.0;  // the logarithms are gathered in two products: one logarithm in all
  double lower = 1.0;
  Green g;
  for (int m = -kMirrors; m <= kMirrors; ++m) {
    for (const double sign : {1.0, -1.0}) {
      const double e = math::exp(p * (x - (2.0 * m * length + sign * xs)));
      const double cosh = 0.5 * (e + 1.0 / e);
      const double sinh = 0.5 * (e - 1.0 / e);
      const double mirrored = cosh - cos_sum;
      const bool own = regular && m == 0 && sign > 0.0;
      // cosh a − cos b → (a² + b²)/2 at the source: p²ρ²/2, whose ρ is what is left out.
      const double direct = own ? 0.5 * p * p : cosh - cos_difference;
      (sign > 0.0 ? upper : lower) *= mirrored;
      (sign > 0.0 ? lower : upper) *= direct;
      g.along -= p * sinh * (1.0 / mirrored - (own ? 0.0 : 1.0 / direct));
      g.across += sign * p * (sin_sum / mirrored + (own ? 0.0 : sin_difference / direct));
    }
  }
  g.value = math::log(upper / lower) / (4.0 * kPi);
  g.along /= 4.0 * kPi;
  g.across /= 4.0 * kPi;
  return g;
}

double sane(double value, double low, double high) { return std::isfinite(value) ? std::clamp(value, low, high) : low; }

}  // namespace

Membrane::Membrane(double half_width_mm, double half_depth_mm, double finger_radius_mm)
    : half_width_mm_(sane(half_width_mm, 1.0, 1000.0)),
      half_depth_mm_(sane(half_depth_mm, 1.0, 1000.0)),
      finger_radius_mm_(sane(finger_radius_mm, 0.1, 0.8 * std::min(half_width_mm_, half_depth_mm_))) {}

double Membrane::shape(double x_mm, double y_mm, double finger_x_mm, double finger_y_mm) const {
  if (!std::isfinite(x_mm) || !std::isfinite(y_mm) || !std::isfinite(finger_x_mm) || !std::isfinite(finger_y_mm)) {
    return 0.0;
  }
  if (std::abs(x_mm) >= half_width_mm_ || std::abs(y_mm) >= half_depth_mm_) return 0.0;
  const double r = finger_radius_mm_;
  const double limit_x = half_width_mm_ - r;
  const double limit_y = half_depth_mm_ - r;
  const double fx = std::clamp(finger_x_mm, -limit_x, limit_x);
  const double fy = std::clamp(finger_y_mm, -limit_y, limit_y);
  if (math::hypot(x_mm - fx, y_mm - fy) <= r) return 1.0;

  double length = 2.0 * half_width_mm_;
  double breadth = 2.0 * half_depth_mm_;
  double x = x_mm + half_width_mm_;
  double y = y_mm + half_depth_mm_;
  double xs = fx + half_width_mm_;
  double ys = fy + half_depth_mm_;
  if (length < breadth) {
    std::swap(length, breadth);
    std::swap(x, y);
    std::swap(xs, ys);
  }
  const Green at_point = green(length, breadth, x, y, xs, ys, false);
  const Green at_finger = green(length, breadth, xs, ys, xs, ys, true);
  const double dipole = -2.0 * kPi * r * r;
  const double level = -math::log(r) / (2.0 * kPi) + at_finger.value +
                       dipole * (at_finger.along * at_finger.along + at_finger.across * at_finger.across);
  const double u = at_point.value + dipole * (at_finger.along * at_point.along + at_finger.across * at_point.across);
  const double ratio = u / level;
  return std::isfinite(ratio) ? std::clamp(ratio, 0.0, 1.0) : 0.0;
}

}  // namespace fyd::sensing
