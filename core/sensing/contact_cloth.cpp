#include "core/sensing/contact_cloth.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"

namespace fyd::sensing {
namespace {

// No contact is outside of these; beyond them the fourth powers of ratios are no numbers any more.
constexpr double kLeastContact_mm = 0.01;
constexpr double kLargestContact_mm = 1e3;
constexpr double kUnknownRadiusSigma = 1.1;  // of ln r: a fingertip looks like 1 to 7 mm
constexpr double kRadiusSigma_mm = 0.1;      // of the contact's radius from its area
constexpr double kLeastOwnSigma = 0.006;     // σ of a share's own error with the finger over the sensor
constexpr double kWiden_per_mm = 0.085;      // w, from finite strain; nearly the same for every finger and stretch
constexpr double kWidenFrom = 1.0,
                 kWidenTo = 1.5;  // contact radii from its middle between which the sensors see it widen
constexpr double kDeepest_mm = 15.0;
constexpr double kLeastCompliance = 0.05;
constexpr double kLeastLevel = 0.5;       // of 2πU: nearer to the frame the finger nearly fills the cloth
constexpr double kMiddleRadius_mm = 2.8;  // contact radius under a sphere of 8 mm pressed 3 mm deep, widening included
// Near the frame the effective radius, as seen by the sensors or by the force, is limited to this part of the distance
// to the frame.
constexpr double kWidestForShares = 1.2;
constexpr double kWidestForForce = 0.6;
constexpr double kLogComplianceSigma = 0.03;        // of ln compliance, far from the frame …
constexpr double kLogComplianceSigmaAtFrame = 0.1;  // … and where its neighbourhood limits the radius

/// A little less than the smaller of the two where they are near.
double smoothMinimum(double radius, double widest) {
  return radius / std::sqrt(std::sqrt(1.0 + math::square(math::square(radius / widest))));
}

}  // namespace

Contact withoutPerspective(const Contact& seen, double indentation_mm, double camera_height_mm) {
  const double nearer = 1.0 - indentation_mm / camera_height_mm;
  if (!(nearer > 0.0 && nearer < 2.0)) return seen;
  return {.x_mm = seen.x_mm * nearer, .y_mm = seen.y_mm * nearer, .area_mm2 = seen.area_mm2 * nearer * nearer};
}

ContactCloth::ContactCloth(const IndentationParameters& p)
    : sensors_(p.sensors()),
      membrane_(p.frame_half_width_mm, p.frame_half_depth_mm, p.finger_radius_mm, p.cloth_edges, p.cloth_tension_ratio),
      other_ratio_(p.frame_half_width_mm, p.frame_half_depth_mm, p.finger_radius_mm, p.cloth_edges,
                   p.cloth_tension_ratio * math::exp(p.cloth_tension_ratio_sigma)),
      radius_share_(p.contact_radius_share),
      radius_share_sigma_(p.contact_radius_share_sigma / p.contact_radius_share),
      own_sigma_(p.cloth_share_sigma),
      unknown_radius_mm_(p.finger_radius_mm) {
  for (std::size_t i = 0; i < sensors_; ++i) positions_[i] = {p.ir_x_mm[i], p.ir_y_mm[i]};
  middle_level_ = membrane_.press(0.0, 0.0, kMiddleRadius_mm, radius_share_ * kMiddleRadius_mm).level();
}

void ContactCloth::press(const Contact& contact, double indentation_mm) {
  const double deep = std::isfinite(indentation_mm) ? std::clamp(indentation_mm, 0.0, kDeepest_mm) : 0.0;
  const bool known = contact.area_mm2 > 0.0 && std::isfinite(contact.area_mm2);
  const double outer =
      known ? std::clamp(std::sqrt(contact.area_mm2 / std::numbers::pi), kLeastContact_mm, kLargestContact_mm)
            : unknown_radius_mm_;
  const double inner = known ? radius_share_ * outer : outer;
  const double sigma = known ? math::hypot(radius_share_sigma_, kRadiusSigma_mm / outer) : kUnknownRadiusSigma;
  Membrane::Press press = membrane_.press(contact.x_mm, contact.y_mm, outer, inner);
  const double level = std::max(2.0 * std::numbers::pi * press.level(), kLeastLevel);
  const double wide = inner * (1.0 + kWiden_per_mm * deep / level);
  const double room =
      std::max(outer, membrane_.toHeldEdge(contact.x_mm, contact.y_mm));  // the contact lies on the cloth
  const double widest = kWidestForForce * room;
  press.setEffectiveRadius(smoothMinimum(wide, widest));
  relative_compliance_ = std::max(press.level() / middle_level_, kLeastCompliance);
  const double limited = math::square(math::square(wide / widest));
  log_compliance_sigma_ = math::hypot(kLogComplianceSigma, kLogComplianceSigmaAtFrame * limited / (1.0 + limited));
  Membrane::Press other = other_ratio_.press(contact.x_mm, contact.y_mm, outer, inner);
  for (std::size_t i = 0; i < sensors_; ++i) {
    const double radii =
        std::sqrt(math::square(positions_[i].x_mm - contact.x_mm) + math::square(positions_[i].y_mm - contact.y_mm)) /
        outer;
    const double far = std::clamp((radii - kWidenFrom) / (kWidenTo - kWidenFrom), 0.0, 1.0);
    const double seen = smoothMinimum(inner + far * (wide - inner), kWidestForShares * room);
    press.setEffectiveRadius(seen);
    other.setEffectiveRadius(seen);
    const MembraneShare here = press.share(positions_[i].x_mm, positions_[i].y_mm);
    const double there = other.share(positions_[i].x_mm, positions_[i].y_mm).value;
    shares_[i] = {.value = here.value,
                  // Where the finger nearly fills the cloth this derivative is unbounded; a share is at most 1.
                  .by_radius = std::clamp(here.per_log_radius * sigma, -1.0, 1.0),
                  .by_ratio = there - here.value,
                  .own = own_sigma_ + (kLeastOwnSigma - own_sigma_) * here.value};
  }
}

ClothDepth ContactCloth::solve(const Contact& contact, std::span<const Drop> drops) {
  constexpr int kRounds = 4;  // shares and weights follow the depth; it moves little after the first
  const std::size_t count = std::min(drops.size(), sensors_);
  std::array<double, kMaximumIrSensors> weights{};
  ClothDepth out;
  double noise = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    const double before = out.indentation_mm;
    press(contact, before);
    double information = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      const double variance = math::square(drops[i].sigma_mm) + math::square(before * shareSigma(i));
      weights[i] = drops[i].used && variance > 0.0 ? share(i) / variance : 0.0;
      information += weights[i] * share(i);
    }
    if (!(information > 0.0)) return {};
    out.indentation_mm = 0.0;
    noise = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
      weights[i] /= information;
      if (!drops[i].used) continue;
      out.indentation_mm += weights[i] * drops[i].drop_mm;
      noise += math::square(weights[i] * drops[i].sigma_mm);
    }
  }
  out.variance_mm2 = noise + math::square(out.indentation_mm * weightedSigma(std::span(weights).first(count)));
  return out;
}

double ContactCloth::shareSigma(std::size_t sensor) const {
  const Share& s = shares_[sensor];
  return std::sqrt(s.by_radius * s.by_radius + s.by_ratio * s.by_ratio + s.own * s.own);
}

double ContactCloth::weightedSigma(std::span<const double> weights) const {
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
