#include "core/device/robot/fri_check.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace fyd::device {
namespace {

using protocol::FriFrame;
using protocol::FriJoints;

constexpr double kJoint_rad = 2.0 * std::numbers::pi;
constexpr double kSkew = 0.01;
constexpr double kReach_m = 3.0;
constexpr double kApart_m = 0.3;
constexpr double kStep_m = 0.3;
constexpr double kForce_N = 1000.0;
constexpr double kTorque_Nm = 500.0;
constexpr double kAcceleration_g = 100.0;

Vec3 row(const FriFrame& frame, std::size_t i) { return {frame[4 * i], frame[4 * i + 1], frame[4 * i + 2]}; }
double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Values are numbered from 1, as KUKA numbers them.
Result<void> within(std::span<const float> values, double bound, const Message& what, const Message& unit) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::abs(static_cast<double>(values[i])) <= bound) continue;
    return fail("KRC: {} {} is {:g} {}; expected within ±{:g} {}", what, i + 1, static_cast<double>(values[i]), unit,
                bound, unit);
  }
  return {};
}

Result<void> checkJoints(const protocol::FriMeasurement& m) {
  if (auto good = within(m.joints, kJoint_rad, say("measured joint"), verbatim("rad")); !good) return good;
  if (auto good = within(m.commanded_joints, kJoint_rad, say("commanded joint"), verbatim("rad")); !good) return good;
  FriJoints mirrored{};
  for (std::size_t i = 0; i < mirrored.size(); ++i) mirrored[i] = m.commanded_joints[i] + m.joint_offsets[i];
  return within(mirrored, kJoint_rad, say("commanded joint plus its offset"), verbatim("rad"));
}

Result<void> checkPlace(const FriFrame& frame, const Message& what) {
  const Vec3 place = placeIn(frame);
  if (place.norm() <= kReach_m) return {};
  return fail("KRC: the {} frame is at ({:g}, {:g}, {:g}) m; expected within {:g} m of the base", what, place.x,
              place.y, place.z, kReach_m);
}

Result<void> checkFrame(const FriFrame& frame, const Message& what) {
  const Vec3 x = row(frame, 0);
  const Vec3 y = row(frame, 1);
  const Vec3 z = row(frame, 2);
  const double skew = std::max({std::abs(dot(x, x) - 1.0), std::abs(dot(y, y) - 1.0), std::abs(dot(z, z) - 1.0),
                                std::abs(dot(x, y)), std::abs(dot(y, z)), std::abs(dot(z, x))});
  if (!(skew <= kSkew)) {
    return fail(
        "KRC: the rotation of the {} frame is off by {:g}; expected rows of length 1 at right angles, within {}", what,
        skew, kSkew);
  }
  if (!(dot(cross(x, y), z) > 0.0)) {
    return fail("KRC: the {} frame is a mirror; expected a rotation (determinant 1)", what);
  }
  return checkPlace(frame, what);
}

}  // namespace

Vec3 placeIn(const FriFrame& frame) { return {frame[3], frame[7], frame[11]}; }

Result<void> checkMeasurement(const protocol::FriMeasurement& m) {
  if (auto good = checkJoints(m); !good) return good;
  if (auto good = checkFrame(m.frame, say("measured")); !good) return good;
  if (auto good = checkFrame(m.commanded_frame, say("commanded")); !good) return good;
  if (auto good = checkPlace(m.frame_offset, say("offset of the commanded")); !good) return good;
  const double apart_m = (placeIn(m.commanded_frame) - placeIn(m.frame)).norm();
  if (!(apart_m <= kApart_m)) {
    return fail("KRC: commanded and measured frame are {:g} m apart; expected at most {:g} m", apart_m, kApart_m);
  }
  const std::span<const float> tool(m.force_torque);
  if (auto good = within(tool.first(3), kForce_N, say("tool force"), verbatim("N")); !good) return good;
  if (auto good = within(tool.last(3), kTorque_Nm, say("tool torque"), verbatim("Nm")); !good) return good;
  return within(std::span(m.krl.reals).first(3), kAcceleration_g, say("KRL real"),
                explained(verbatim("g"), say("acceleration")));
}

Result<void> checkStep(const protocol::FriMeasurement& before, const protocol::FriMeasurement& now, int ahead) {
  const double step_m = (placeIn(now.frame) - placeIn(before.frame)).norm();
  const double most_m = kStep_m * ahead;
  if (step_m <= most_m) return {};
  return fail("KRC: the measured frame moved {:g} m in {} cycles; expected at most {:g} m", step_m, ahead, most_m);
}

}  // namespace fyd::device
