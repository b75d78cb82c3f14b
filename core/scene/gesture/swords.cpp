#include "core/scene/gesture/swords.h"

#include <array>
#include <cmath>

#include "core/base/batch.h"

namespace fyd::scene {
namespace {

constexpr double kParallel = 1e-12;             // squared sine
constexpr double kMeet = 1e-7;                  // of Motion::size: blades no farther apart meet
constexpr double kSlowSliding_mm_per_s = 10.0;  // from here friction is nearly as large as it gets
constexpr int kHalvings = 60;

Vec3 between(const Vec3& from, const Vec3& to, double share) { return from + share * (to - from); }
Vec3 at(const Blade& blade, double share) { return between(blade.grip_mm, blade.tip_mm, share); }
Blade between(const Blade& from, const Blade& to, double share) {
  return {between(from.grip_mm, to.grip_mm, share), between(from.tip_mm, to.tip_mm, share)};
}
Vec3 along(const Blade& blade) { return blade.tip_mm - blade.grip_mm; }

/// Six times the signed volume that the four ends span: 0 where they lie in a plane.
double volume(const Blade& a, const Blade& b) { return dot(cross(along(a), along(b)), a.grip_mm - b.grip_mm); }
int signOf(double x, int of_zero) { return x > 0.0 ? 1 : x < 0.0 ? -1 : of_zero; }

bool parallel(const Vec3& u, const Vec3& v) { return squared(cross(u, v)) <= kParallel * squared(u) * squared(v); }

/// Of the crossing at these places, to the nearest end of either blade.
double toAnEnd(const Blade& a, const Blade& b, double at_a, double at_b) {
  return std::min(length(along(a)) * std::min(at_a, 1.0 - at_a), length(along(b)) * std::min(at_b, 1.0 - at_b));
}

/// A step's motion, from where both blades were to where they are.
struct Motion {
  const Blade &a_from, &a_to, &b_from, &b_to;

  [[nodiscard]] Blade a(double share) const { return between(a_from, a_to, share); }
  [[nodiscard]] Blade b(double share) const { return between(b_from, b_to, share); }
  [[nodiscard]] double distance(double share) const { return length(nearestOf(a(share), b(share)).apart_mm); }
  /// A length of the motion's order of magnitude, for relative tolerances, mm.
  [[nodiscard]] double size() const {
    return length(along(a_from)) + length(along(b_from)) + length(a_to.grip_mm - a_from.grip_mm) +
           length(a_to.tip_mm - a_from.tip_mm) + length(b_to.grip_mm - b_from.grip_mm) +
           length(b_to.tip_mm - b_from.tip_mm);
  }
};

/// The volume over a step: a cubic of the share, as all four ends move straight.
struct Cubic {
  double c0, c1, c2, c3;

  explicit Cubic(const Motion& m) {
    const Vec3 u = along(m.a_from), du = along(m.a_to) - u;
    const Vec3 v = along(m.b_from), dv = along(m.b_to) - v;
    const Vec3 w = m.a_from.grip_mm - m.b_from.grip_mm, dw = m.a_to.grip_mm - m.b_to.grip_mm - w;
    const Vec3 n0 = cross(u, v), n1 = cross(du, v) + cross(u, dv), n2 = cross(du, dv);
    c0 = dot(n0, w);
    c1 = dot(n1, w) + dot(n0, dw);
    c2 = dot(n2, w) + dot(n1, dw);
    c3 = dot(n2, dw);
  }
  [[nodiscard]] double at(double t) const { return c0 + t * (c1 + t * (c2 + t * c3)); }

  /// Its extrema within 0 … 1, in ascending order.
  [[nodiscard]] Batch<double, 2> turns() const {
    Batch<double, 2> out;
    const auto take = [&](double t) {
      if (t > 0.0 && t < 1.0) static_cast<void>(out.push(t));
    };
    const double a = 3.0 * c3, half_b = c2, c = c1;  // a·t² + 2·half_b·t + c
    const double inside = half_b * half_b - a * c;
    if (inside < 0.0) return out;
    const double q = -(half_b + std::copysign(std::sqrt(inside), half_b));  // without cancellation
    const double first = q / a, second = c / q;                             // not finite where there is none
    take(std::min(first, second));
    if (first != second) take(std::max(first, second));
    if (out.empty()) {  // one of them is no number
      take(first);
      take(second);
    }
    return out;
  }
};

/// Ends a crossing without force: an overlap that remains gives none (free_mm).
void letGo(SwordState& state, double overlap_mm) {
  state.crossed = false;
  state.free_mm = std::max(0.0, overlap_mm);
}

/// The four ends lie in a plane at this share of the step.
/// @return whether the blades have crossed there
bool passPlane(SwordState& state, const Motion& motion, double share, double size_mm, double fade_mm) {
  const Blade a = motion.a(share), b = motion.b(share);
  if (parallel(along(a), along(b))) return false;  // they turned past each other, or crossParallel handles it
  const NearestOfBlades near = nearestOf(a, b);
  if (length(near.apart_mm) > kMeet * size_mm) {  // beyond an end
    if (state.crossed) letGo(state, 0.0);
    return false;
  }
  state.crossed = !state.crossed;
  if (!state.crossed) return false;
  state.reach_mm = std::min(fade_mm, toAnEnd(a, b, near.at_a, near.at_b));
  return true;
}

/// Blades that stay parallel span no volume: they cross where one passes over the other.
/// @return the share of the step at which they have crossed
std::optional<double> crossParallel(SwordState& state, const Motion& motion, double size_mm, double fade_mm) {
  if (!parallel(along(motion.a_from), along(motion.b_from)) || !parallel(along(motion.a_to), along(motion.b_to))) {
    return std::nullopt;
  }
  if (squared(along(motion.a_to)) == 0.0 || squared(along(motion.b_to)) == 0.0) return std::nullopt;
  const Vec3 from = nearestOf(motion.a_from, motion.b_from).apart_mm, to = nearestOf(motion.a_to, motion.b_to).apart_mm;
  const Vec3 right = state.crossed ? -1.0 * state.normal : state.normal;  // where the local blade is
  if (!(dot(right, to) < 0.0)) return std::nullopt;
  const double moved = squared(to - from);
  const double share = moved > 0.0 ? std::clamp(-dot(from, to - from) / moved, 0.0, 1.0) : 0.0;
  const Blade a = motion.a(share), b = motion.b(share);
  const NearestOfBlades near = nearestOf(a, b);
  if (length(near.apart_mm) > kMeet * size_mm) return std::nullopt;
  state.crossed = !state.crossed;
  if (!state.crossed) return std::nullopt;
  state.reach_mm = std::min(fade_mm, toAnEnd(a, b, near.at_a, near.at_b));
  return share;
}

/// Updates side and crossing over the step.
/// @return the share of the step at which they have crossed last
std::optional<double> follow(SwordState& state, const Motion& motion, double fade_mm) {
  const double size_mm = motion.size();
  const Cubic cubic(motion);
  const int now = signOf(volume(motion.a_to, motion.b_to), state.side);
  std::optional<double> crossed_at;
  double from = 0.0;
  int side = state.side;
  const auto upTo = [&](double to, int side_there) {
    if (side != 0 && side_there != side) {
      double low = from, high = to;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (low + high);
        (signOf(cubic.at(middle), side) == side ? low : high) = middle;
      }
      if (passPlane(state, motion, high, size_mm, fade_mm)) crossed_at = high;
    }
    from = to;
    side = side_there;
  };
  for (const double turn : cubic.turns()) upTo(turn, signOf(cubic.at(turn), side));
  upTo(1.0, now);
  state.side = now;
  if (const auto share = crossParallel(state, motion, size_mm, fade_mm)) crossed_at = share;
  return crossed_at;
}

struct BladesMeeting {
  double at_a = 0.0, at_b = 0.0;
  Vec3 normal;
  double depth_mm = 0.0;
};

/// Contact of blades that have crossed, by the lines along them.
/// @return nothing when they have slid over an end
std::optional<BladesMeeting> crossing(const SwordState& state, const Blade& a, const Blade& b, double radii_mm) {
  const Vec3 u = along(a), v = along(b), w = a.grip_mm - b.grip_mm, n = cross(u, v);
  BladesMeeting out;
  if (parallel(u, v)) {
    const NearestOfBlades near = nearestOf(a, b);
    if (near.at_a == 0.0 || near.at_a == 1.0) return std::nullopt;  // they do not overlap
    out.at_a = near.at_a;
    out.at_b = near.at_b;
  } else {
    const double by = 1.0 / squared(n);
    out.at_a = by * dot(cross(v, w), n);
    out.at_b = by * dot(cross(u, w), n);
    if (!(out.at_a >= 0.0 && out.at_a <= 1.0 && out.at_b >= 0.0 && out.at_b <= 1.0)) return std::nullopt;
  }
  const Vec3 apart = at(a, out.at_a) - at(b, out.at_b);
  const double distance = length(apart);
  out.depth_mm = radii_mm + distance;
  out.normal = -1.0 * unit(apart);
  if (distance <= 1e-12 * (length(u) + length(v))) {  // the direction of `apart` is only rounding
    out.normal = parallel(u, v) ? state.normal : (dot(n, state.normal) < 0.0 ? -1.0 : 1.0) * unit(n);
  }
  return out;
}

/// The first share of the step, up to `until`, at which blades that were farther apart are no farther than `reach_mm`.
double firstWithin(const Motion& motion, double reach_mm, double until) {
  double low = 0.0, high = until;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (motion.distance(middle) > reach_mm ? low : high) = middle;
  }
  return high;
}

}  // namespace

NearestOfBlades nearestOf(const Blade& a, const Blade& b) {
  const Vec3 u = along(a), v = along(b), w = a.grip_mm - b.grip_mm;
  const double uu = squared(u), vv = squared(v), uv = dot(u, v), uw = dot(u, w), vw = dot(v, w);
  const auto held = [](double x) { return std::clamp(x, 0.0, 1.0); };
  NearestOfBlades out;
  double &s = out.at_a, &t = out.at_b;
  if (uu == 0.0) {
    t = vv > 0.0 ? held(vw / vv) : 0.0;
  } else if (vv == 0.0) {
    s = held(-uw / uu);
  } else if (parallel(u, v)) {
    const double grip = -uw / uu, tip = (uv - uw) / uu;  // of b, along a
    s = 0.5 * (held(std::min(grip, tip)) + held(std::max(grip, tip)));
    t = held((vw + s * uv) / vv);
  } else {
    s = held((uv * vw - vv * uw) / squared(cross(u, v)));
    t = (vw + s * uv) / vv;
    if (t < 0.0) {
      t = 0.0;
      s = held(-uw / uu);
    } else if (t > 1.0) {
      t = 1.0;
      s = held((uv - uw) / uu);
    }
  }
  out.apart_mm = at(a, s) - at(b, t);
  return out;
}

SwordTouch stepSwords(const SwordParameters& parameters, SwordState& state, const Blade& local, const Blade& distant,
                      double dt_s) {
  SwordTouch out;
  out.refusal = firstRefusal(dt_s, local.grip_mm, local.tip_mm, distant.grip_mm, distant.tip_mm);
  if (out.refusal != Refusal::none) return out;
  const double radii = 2.0 * parameters.radius_mm;
  const NearestOfBlades near = nearestOf(local, distant);
  if (!state.known) {
    state = {.known = true, .local = local, .distant = distant, .side = signOf(volume(local, distant), 0)};
    state.normal = unit(near.apart_mm);
    letGo(state, radii - length(near.apart_mm));
  }
  const Motion motion{state.local, local, state.distant, distant};
  const std::optional<double> crossed_at = follow(state, motion, parameters.fade_mm);

  std::optional<BladesMeeting> meeting;
  if (state.crossed) {
    meeting = crossing(state, local, distant, radii);
    if (!meeting) letGo(state, radii - length(near.apart_mm));
  }
  if (meeting) {
    const double reach = state.reach_mm, end = toAnEnd(local, distant, meeting->at_a, meeting->at_b);
    if (parameters.fade_mm > 0.0) state.hold = std::min(state.hold, reach > 0.0 ? end / reach : 0.0);
  } else {
    const Vec3 normal = squared(near.apart_mm) > 0.0 ? unit(near.apart_mm) : state.normal;
    meeting = BladesMeeting{near.at_a, near.at_b, normal, radii - length(near.apart_mm)};
    state.free_mm = std::min(state.free_mm, std::max(0.0, meeting->depth_mm));
  }
  const double depth = std::max(0.0, meeting->depth_mm - state.free_mm);
  out.depth_mm = depth;
  out.crossed = state.crossed;
  out.touching = depth > 0.0 || state.crossed;
  out.point_mm = at(local, meeting->at_a);
  out.other_point_mm = at(distant, meeting->at_b);
  if (out.touching) {
    const Vec3& n = meeting->normal;
    out.normal = n;
    const double pressed =
        state.hold * normalForce(depth, (depth - state.depth_mm) / dt_s, parameters.stiffness_N_per_mm,
                                 parameters.damping_Ns_per_mm, parameters.most_force_N);
    const Vec3 speed = (1.0 / dt_s) * ((out.point_mm - at(state.local, meeting->at_a)) -
                                       (out.other_point_mm - at(state.distant, meeting->at_b)));
    const Vec3 sliding = speed - dot(speed, n) * n;
    const double slow = kSlowSliding_mm_per_s;
    out.force_N = pressed * n - (parameters.friction * pressed / std::sqrt(squared(sliding) + slow * slow)) * sliding;
    out.torque_Nmm = cross(out.point_mm - local.grip_mm, out.force_N);
    out.began = !state.touching;
    if (out.began) {
      const double reach = radii - state.free_mm, until = crossed_at.value_or(1.0);
      const double share = reach > 0.0 ? firstWithin(motion, reach, until) : until;
      out.began_ago_s = (1.0 - share) * dt_s;
    }
  } else {
    state.hold = 1.0;
  }
  state.local = local;
  state.distant = distant;
  state.normal = meeting->normal;
  state.depth_mm = depth;
  state.touching = out.touching;
  return out;
}

}  // namespace fyd::scene
