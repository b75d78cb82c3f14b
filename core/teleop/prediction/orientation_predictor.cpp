#include "core/teleop/prediction/orientation_predictor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"

namespace fyd::teleop {
namespace {

constexpr double kLengthTolerance = 0.1;  // a quaternion's length may be this far from 1

Orientation product(const Orientation& a, const Orientation& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Orientation inverse(const Orientation& q) { return {q.w, -q.x, -q.y, -q.z}; }

double length(const Orientation& q) { return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z); }

Orientation unit(const Orientation& q) {
  const double by = 1.0 / length(q);
  return {q.w * by, q.x * by, q.y * by, q.z * by};
}

/// The shortest rotation as a vector, rad.
Position rotationVector(const Orientation& q) {
  const double sine = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z);
  const double sign = q.w < 0.0 ? -1.0 : 1.0;
  // 2·atan2(sine, |w|) / sine, and 2 / |w| where sine vanishes.
  const double by = sign * (sine > 1e-12 ? 2.0 * math::atan2(sine, std::abs(q.w)) / sine : 2.0);
  return {by * q.x, by * q.y, by * q.z};
}

Orientation rotationBy(const Position& rad) {
  const double angle = std::sqrt(rad[0] * rad[0] + rad[1] * rad[1] + rad[2] * rad[2]);
  const double by = angle > 1e-12 ? math::sin(0.5 * angle) / angle : 0.5;
  return {math::cos(0.5 * angle), by * rad[0], by * rad[1], by * rad[2]};
}

}  // namespace

double angle_deg(const Orientation& from, const Orientation& to) {
  const Position by = rotationVector(product(inverse(from), to));
  return std::sqrt(by[0] * by[0] + by[1] * by[1] + by[2] * by[2]) * 180.0 / std::numbers::pi;
}

Orientation fromAngles(double alpha, double beta, double gamma) {
  return product(rotationBy({0.0, 0.0, gamma}), product(rotationBy({0.0, beta, 0.0}), rotationBy({alpha, 0.0, 0.0})));
}

void OrientationPredictor::message(double date_s, const Orientation& orientation) {
  const double size = length(orientation);
  if (!std::isfinite(date_s) || !(std::abs(size - 1.0) <= kLengthTolerance)) return;
  const Orientation now = unit(orientation);
  std::size_t later = 0;
  while (later < count_ && back(later).date_s > date_s) ++later;
  if (count_ > 0 && later == count_) return;  // older than all that is kept
  if (later < count_ && back(later).date_s == date_s) return;
  PathPoint point{.date_s = date_s, .orientation = now, .path_mm = {}};
  if (later < count_) {
    const PathPoint& before = back(later);
    const Position by = rotationVector(product(inverse(before.orientation), now));
    for (std::size_t a = 0; a < kMostAxes; ++a) point.path_mm[a] = before.path_mm[a] + kMillimetresPerRadian * by[a];
  }
  end_ = (end_ + 1) % kCapacity;
  count_ = std::min(count_ + 1, kCapacity);
  for (std::size_t i = 0; i < later; ++i) path_[(end_ + kCapacity - 1 - i) % kCapacity] = back(i + 1);
  path_[(end_ + kCapacity - 1 - later) % kCapacity] = point;
  predictor_->message(date_s, point.path_mm);
}

Orientation OrientationPredictor::predict(double time_s) {
  if (count_ == 0) return {};
  const PathPoint& newest = back(0);
  Position by = predictor_->predict(time_s);
  for (std::size_t a = 0; a < kMostAxes; ++a) by[a] = (by[a] - newest.path_mm[a]) / kMillimetresPerRadian;
  return unit(product(newest.orientation, rotationBy(by)));
}

}  // namespace fyd::teleop
