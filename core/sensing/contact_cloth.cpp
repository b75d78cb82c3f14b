#include "core/sensing/contact_cloth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"

namespace fyd::sensing {
namespace {

constexpr double kUnknownRadiusSigma = 0.8;  // of ln r: a fingertip looks like 2 to 7 mm
constexpr double kRadiusSigma_mm = 0.1;      // of the contact's radius from its area
constexpr double kLeastOwn = 0.006;          // a share's own error over the sensor …
constexpr double kMostOwn = 0.02;            // … and far from it
constexpr double kMiddleRadius_mm = 2.8;     // of the contact under a fingertip pressed 3 mm deep

}  // namespace

Contact withoutPerspective(const Contact& seen, double indentation_mm, double camera_height_mm) {
  const double nearer = 1.0 - indentation_mm / camera_height_mm;
  if (!(nearer > 0.0 && nearer < 2.0)) return seen;
  return {.x_mm = seen.x_mm * nearer, .y_mm = seen.y_mm * nearer, .area_mm2 = seen.area_mm2 * nearer * nearer};
}

ContactCloth::ContactCloth(const IndentationParameters& p)
    : sensors_(std::min({p.ir_x_mm.size(), p.ir_y_mm.size(), kMaximumIrSensors})),
      membrane_(p.frame_half_width_mm, p.frame_half_depth_mm, p.finger_radius_mm, p.cloth_edges, p.cloth_tension_ratio),
      other_ratio_(p.frame_half_width_mm, p.frame_half_depth_mm, p.finger_radius_mm, p.cloth_edges,
                   p.cloth_tension_ratio * math::exp(p.cloth_tension_ratio_sigma)),
      radius_share_(p.contact_radius_share),
      radius_share_sigma_(p.contact_radius_share_sigma / p.contact_radius_share),
      unknown_radius_mm_(p.finger_radius_mm) {
  for (std::size_t i = 0; i < sensors_; ++i) positions_[i] = {p.ir_x_mm[i], p.ir_y_mm[i]};
  middle_level_ = membrane_.press(0.0, 0.0, kMiddleRadius_mm, radius_share_ * kMiddleRadius_mm).level();
}

void ContactCloth::press(const Contact& contact) {
  const bool known = contact.area_mm2 > 0.0 && std::isfinite(contact.area_mm2);
  const double outer = known ? std::sqrt(contact.area_mm2 / std::numbers::pi) : unknown_radius_mm_;
  const double inner = known ? radius_share_ * outer : outer;
  const double sigma = known ? math::hypot(radius_share_sigma_, kRadiusSigma_mm / outer) : kUnknownRadiusSigma;
  const Membrane::Press press = membrane_.press(contact.x_mm, contact.y_mm, outer, inner);
  const Membrane::Press other = other_ratio_.press(contact.x_mm, contact.y_mm, outer, inner);
  reach_ = press.level() / middle_level_;
  if (!(reach_ > 0.0) || !std::isfinite(reach_)) reach_ = 1.0;
  for (std::size_t i = 0; i < sensors_; ++i) {
    const MembraneShare here = press.share(positions_[i].x_mm, positions_[i].y_mm);
    const double there = other.share(positions_[i].x_mm, positions_[i].y_mm).value;
    shares_[i] = {.value = here.value,
                  .by_radius = here.per_log_radius * sigma,
                  .by_ratio = there - here.value,
                  .own = kMostOwn + (kLeastOwn - kMostOwn) * here.value};
  }
}

double ContactCloth::doubt(std::size_t sensor) const {
  const Share& s = shares_[sensor];
  return std::sqrt(s.by_radius * s.by_radius + s.by_ratio * s.by_ratio + s.own * s.own);
}

double ContactCloth::doubt(std::span<const double> weights) const {
  double by_radius = 0.0;
  double by_ratio = 0.0;
  double own = 0.0;
  for (std::size_t i = 0; i < std::min(weights.size(), sensors_); ++i) {
    by_radius += weights[i] * shares_[i].by_radius;
    by_ratio += weights[i] * shares_[i].by_ratio;
    own += math::square(weights[i] * shares_[i].own);
  }
  return std::sqrt(by_radius * by_radius + by_ratio * by_ratio + own);
}

}  // namespace fyd::sensing
