#include "core/scene/gesture/racket.h"

#include "core/base/portable_math.h"

namespace fyd::scene {
namespace {

constexpr double kMostTurn_rad = 1.0;

Vec3 turned(const Vec3& v, const Vec3& axis, double sine, double cosine) {
  return cosine * v + sine * cross(axis, v) + ((1.0 - cosine) * dot(axis, v)) * axis;
}

}  // namespace

bool orthonormalise(RacketPose& pose) {
  const Vec3 normal = unit(pose.normal);
  const Vec3 along = unit(pose.along);
  const Vec3 right = unit(along - dot(along, normal) * normal);
  if (!(squared(cross(normal, along)) > 1e-12)) return false;
  pose.normal = normal;
  pose.along = right;
  return true;
}

Vec3 Plate::nearest(const RacketPose& pose, const Vec3& p) const {
  const Vec3 across = cross(pose.normal, pose.along), from = p - pose.centre_mm;
  double u = dot(from, pose.along), v = dot(from, across);
  if (shape == RacketShape::rectangle) {
    u = std::clamp(u, -half_width_mm, half_width_mm);
    v = std::clamp(v, -half_height_mm, half_height_mm);
  } else if (const double out = std::sqrt(u * u + v * v); out > half_width_mm) {
    u *= half_width_mm / out;
    v *= half_width_mm / out;
  }
  return pose.centre_mm + u * pose.along + v * across;
}

RacketMotion::RacketMotion(const RacketPose& from, const RacketPose& to, double dt_s, double most_mm_per_s)
    : from_(from) {
  const Vec3 moved = to.centre_mm - from.centre_mm;
  // Σ a × R·a over three orthonormal directions a is 2·sin(angle)·axis.
  const Vec3 sine = 0.5 * (cross(from.normal, to.normal) + cross(from.along, to.along) +
                           cross(cross(from.normal, from.along), cross(to.normal, to.along)));
  const double cosine = 0.5 * (dot(from.normal, to.normal) + dot(from.along, to.along) +
                               dot(cross(from.normal, from.along), cross(to.normal, to.along)) - 1.0);
  const double angle = math::atan2(length(sine), cosine);
  teleported_ = length(moved) > most_mm_per_s * dt_s || angle > kMostTurn_rad;
  if (teleported_) {
    from_ = to;
  } else {
    velocity_ = (1.0 / dt_s) * moved;
    turning_ = (angle / dt_s) * unit(sine);
  }
}

RacketPose RacketMotion::at(double t_s) const {
  RacketPose out = from_;
  out.centre_mm = from_.centre_mm + t_s * velocity_;
  const double rate = length(turning_);
  if (rate == 0.0) return out;
  const Vec3 axis = (1.0 / rate) * turning_;
  const double sine = math::sin(rate * t_s), cosine = math::cos(rate * t_s);
  out.normal = turned(from_.normal, axis, sine, cosine);
  out.along = turned(from_.along, axis, sine, cosine);
  return out;
}

double RacketMotion::mostRelativeAcceleration(double acceleration, double speed, double most_mm) const {
  const double rate = length(turning_);
  return acceleration + 2.0 * rate * (speed + length(velocity_) + rate * most_mm) + rate * rate * most_mm;
}

}  // namespace fyd::scene
