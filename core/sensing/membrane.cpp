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
// A strip longer than this is cut to a part around the finger: the products in `green` grow by exp(10πL/B) and stay finite
// up to L/B = 22, and what lies 10 B away adds less than 1e−13.
constexpr double kLongestStrip = 20.0;  // L/B
constexpr double kLeastRadius_mm = 0.1;
constexpr double kLargestRatio = 50.0;
constexpr double kWidestPart = 0.8;  // of the frame's shorter half: a disc's largest radius

/// Green's function (or its regular part) at a point, with its gradient to the source's position.
struct Green {
  double value = 0.0;
  double along = 0.0;   // derivative to the source's coordinate along the strip
  double across = 0.0;  // derivative to the source's coordinate across the strip
};

/// The strip's length is [0, length], its breadth [0, breadth]; (x, y) the point, (xs, ys) the source; a mirror at
/// an end has the sign `mirror`. `regular` leaves out −ln(ρ)/2π, and is meant for the point at the source.
Green green(double length, double breadth, double mirror, double x, double y, double xs, double ys, bool regular) {
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
      const double source = sign > 0.0 ? 1.0 : mirror;
      (source > 0.0 ? upper : lower) *= mirrored;
      (source > 0.0 ? lower : upper) *= direct;
      g.along -= source * sign * p * sinh * (1.0 / mirrored - (own ? 0.0 : 1.0 / direct));
      g.across += source * p * (sin_sum / mirrored + (own ? 0.0 : sin_difference / direct));
    }
  }
  g.value = math::log(upper / lower) / (4.0 * kPi);
  g.along /= 4.0 * kPi;
  g.across /= 4.0 * kPi;
  return g;
}

double sane(double value, double low, double high) { return std::isfinite(value) ? std::clamp(value, low, high) : low; }

}  // namespace

Membrane::Membrane(double half_width_mm, double half_depth_mm, double finger_radius_mm, ClothEdges edges,
                   double tension_ratio)
    : half_width_mm_(sane(half_width_mm, 1.0, 1000.0)),
      half_depth_mm_(sane(half_depth_mm, 1.0, 1000.0)),
      finger_radius_mm_(
          sane(finger_radius_mm, kLeastRadius_mm, kWidestPart * std::min(half_width_mm_, half_depth_mm_))) {
  const double ratio =
      std::isfinite(tension_ratio) ? std::clamp(tension_ratio, 1.0 / kLargestRatio, kLargestRatio) : 1.0;
  scale_y_ = std::sqrt(std::sqrt(ratio));
  scale_x_ = 1.0 / scale_y_;
  const double width = 2.0 * half_width_mm_ * scale_x_;
  const double depth = 2.0 * half_depth_mm_ * scale_y_;
  // Free sides must be the strip's ends; held ones are where the series falls fastest.
  across_is_x_ = edges == ClothEdges::rollers || width < depth;
  mirror_ = edges == ClothEdges::rollers ? 1.0 : -1.0;
  breadth_ = across_is_x_ ? width : depth;
  whole_length_ = across_is_x_ ? depth : width;
  length_ = std::min(whole_length_, kLongestStrip * breadth_);
}

Membrane::Place Membrane::place(double x_mm, double y_mm) const {
  const double x = (x_mm + half_width_mm_) * scale_x_;
  const double y = (y_mm + half_depth_mm_) * scale_y_;
  return across_is_x_ ? Place{y, x} : Place{x, y};
}

double Membrane::toHeldEdge(double x_mm, double y_mm) const {
  const double x = half_width_mm_ - std::abs(x_mm);
  const bool free_front_and_back = mirror_ > 0.0;
  return free_front_and_back ? x : std::min(x, half_depth_mm_ - std::abs(y_mm));
}

double Membrane::shape(double x_mm, double y_mm, double finger_x_mm, double finger_y_mm) const {
  const double r = finger_radius_mm_;
  const double fx = std::clamp(finger_x_mm, r - half_width_mm_, half_width_mm_ - r);
  const double fy = std::clamp(finger_y_mm, r - half_depth_mm_, half_depth_mm_ - r);
  if (math::hypot(x_mm - fx, y_mm - fy) <= r && std::abs(x_mm) < half_width_mm_ && std::abs(y_mm) < half_depth_mm_) {
    return 1.0;
  }
  return press(finger_x_mm, finger_y_mm, r, r).outside(x_mm, y_mm).value;
}

Membrane::Press Membrane::press(double finger_x_mm, double finger_y_mm, double contact_radius_mm,
                                double effective_radius_mm) const {
  Press out;
  out.membrane_ = this;
  out.known_ = std::isfinite(finger_x_mm) && std::isfinite(finger_y_mm) && std::isfinite(contact_radius_mm) &&
               std::isfinite(effective_radius_mm);
  if (!out.known_) return out;
  const double widest = kWidestPart * std::min(half_width_mm_, half_depth_mm_);
  out.contact_mm_ = std::clamp(contact_radius_mm, kLeastRadius_mm, widest);
  const double r = std::clamp(effective_radius_mm, kLeastRadius_mm, widest);
  const double limit_x = half_width_mm_ - r;
  const double limit_y = half_depth_mm_ - r;
  out.x_mm_ = std::clamp(finger_x_mm, -limit_x, limit_x);
  out.y_mm_ = std::clamp(finger_y_mm, -limit_y, limit_y);
  Place source = place(out.x_mm_, out.y_mm_);
  out.from_ = std::clamp(source.along - 0.5 * length_, 0.0, whole_length_ - length_);
  source.along -= out.from_;
  const Green at_finger =
      green(length_, breadth_, mirror_, source.along, source.across, source.along, source.across, true);
  out.regular_ = at_finger.value;
  out.along_ = at_finger.along;
  out.across_ = at_finger.across;
  out.setEffectiveRadius(r);
  return out;
}

void Membrane::Press::setEffectiveRadius(double radius_mm) {
  const Membrane& m = *membrane_;
  if (!known_ || !std::isfinite(radius_mm)) return;
  const double r = std::clamp(radius_mm, kLeastRadius_mm, kWidestPart * std::min(m.half_width_mm_, m.half_depth_mm_));
  // A circle on the cloth is an ellipse in the scaled plane; from afar it acts like a disc whose radius is the mean of
  // the semi-axes.
  const double scaled = r * 0.5 * (m.scale_x_ + m.scale_y_);
  dipole_ = -2.0 * kPi * scaled * scaled;
  const double bend = dipole_ * (along_ * along_ + across_ * across_);
  level_ = -math::log(scaled) / (2.0 * kPi) + regular_ + bend;
  level_per_log_radius_ = -1.0 / (2.0 * kPi) + 2.0 * bend;
}

MembraneShare Membrane::Press::outside(double x_mm, double y_mm) const {
  const Membrane& m = *membrane_;
  if (!known_ || !std::isfinite(x_mm) || !std::isfinite(y_mm)) return {};
  if (std::abs(x_mm) >= m.half_width_mm_ || std::abs(y_mm) >= m.half_depth_mm_) return {};
  Place point = m.place(x_mm, y_mm);
  Place source = m.place(x_mm_, y_mm_);
  point.along -= from_;
  source.along -= from_;
  if (point.along < 0.0 || point.along > m.length_) return {};  // too far from the finger to move
  const Green at_point =
      green(m.length_, m.breadth_, m.mirror_, point.along, point.across, source.along, source.across, false);
  const double moved = dipole_ * (along_ * at_point.along + across_ * at_point.across);
  const double ratio = (at_point.value + moved) / level_;
  if (!std::isfinite(ratio)) return {};
  return {.value = std::clamp(ratio, 0.0, 1.0),
          .per_log_radius = (2.0 * moved - ratio * level_per_log_radius_) / level_};
}

MembraneShare Membrane::Press::share(double x_mm, double y_mm) const {
  if (!known_ || !std::isfinite(x_mm) || !std::isfinite(y_mm)) return {};
  const double dx = x_mm - x_mm_;
  const double dy = y_mm - y_mm_;
  const double distance = math::hypot(dx, dy);
  if (distance >= contact_mm_) return outside(x_mm, y_mm);
  if (!(distance > 0.0)) return {.value = 1.0};
  const double out = contact_mm_ / distance;
  const MembraneShare rim = outside(x_mm_ + dx * out, y_mm_ + dy * out);
  const double part = 1.0 / (out * out);
  return {.value = 1.0 - part * (1.0 - rim.value), .per_log_radius = part * rim.per_log_radius};
}

}  // namespace fyd::sensing
