#include "core/scene/gesture/ball.h"

#include "core/base/portable_math.h"
#include "core/scene/gesture/flight.h"

namespace fyd::scene {
namespace {

constexpr double kTouch = 1e-9;           // of the ball's radius: a gap up to this counts as contact
constexpr double kTouchRounding = 1e-14;  // of the distance from the origin
constexpr double kLeaves = 1e-9;          // of the rest speed: separation speed after an impact without rebound
constexpr double kCounted = 1e-6;         // of the rest speed: a slower approach is not counted as an impact
constexpr double kLostTouch = 1e-6;       // of the radius: a ball at rest with a larger gap has been put elsewhere
constexpr int kMostParts = 2000;          // of a step: flights, impacts and rests; only a ball that is crushed has more
constexpr int kMostImpacts = 100;         // in a step; then the ball moves along with what it struck last
constexpr double kInstant_s = 1e-12, kLongest_s = 60.0;
constexpr double kNewton = 1e-3;  // kg·mm/s² in N

Vec3 tangential(const Vec3& v, const Vec3& normal) { return v - dot(v, normal) * normal; }

/// The racket or the court at the point nearest to the ball.
struct Surface {
  bool racket = false;
  Vec3 point_mm, normal, velocity_mm_per_s;  ///< of contact; towards the ball; at that point
  double restitution = 0.0, friction = 0.0;
};

class Step {
 public:
  Step(const BallParameters& parameters, BallGameState& state, const RacketMotion* racket, double dt_s, BallStep& out)
      : p_(parameters),
        plate_{p_.racket_shape, 0.5 * p_.racket_width_mm, 0.5 * p_.racket_height_mm},
        state_(state),
        ball_(state.ball),
        racket_(racket),
        dt_s_(dt_s),
        near_mm_(kTouch * p_.radius_mm + kTouchRounding * length(ball_.position_mm)),
        out_(out) {}

  /// @return the impulse on the racket of a ball that rests on it, N·s
  Vec3 run() {
    begin();
    double left_s = dt_s_;
    for (int i = 0; left_s > 0.0 && i < kMostParts; ++i) {
      left_s -= state_.rest == BallRest::flies ? fly(left_s) : lie(left_s);
    }
    return pressed_Ns_;
  }

 private:
  [[nodiscard]] Surface court() const {
    const Vec3& x = ball_.position_mm;
    return {.point_mm = {x.x, x.y, p_.court_z_mm},
            .normal = {0.0, 0.0, 1.0},
            .velocity_mm_per_s = {},
            .restitution = p_.court_restitution,
            .friction = p_.court_friction};
  }
  [[nodiscard]] Surface racketAt(const RacketPose& pose, const Vec3& x) const {
    const Vec3 point = plate_.nearest(pose, x), apart = x - point;
    const Vec3 normal = squared(apart) > 0.0 ? unit(apart) : pose.normal;
    return {.racket = true,
            .point_mm = point,
            .normal = normal,
            .velocity_mm_per_s = racket_->velocity(pose, point),
            .restitution = p_.restitution,
            .friction = p_.friction};
  }
  [[nodiscard]] Gap gapTo(const Surface& surface, const Vec3& x, const Vec3& v) const {
    return {dot(x - surface.point_mm, surface.normal) - p_.radius_mm,
            dot(v - surface.velocity_mm_per_s, surface.normal)};
  }
  /// The first meeting with the racket on this piece, which begins at `from_s` of the step.
  [[nodiscard]] std::optional<double> meetRacket(const FlightPiece& piece, double from_s) const {
    if (racket_ == nullptr) return std::nullopt;
    const double most = piece.mostAcceleration(), h = piece.length_s;
    const double speed = length(piece.c1) + h * most;
    const double far_mm = length(piece.c0 - racket_->at(from_s).centre_mm) + h * (speed + racket_->speed());
    const auto gap = [&](double t) {
      const Vec3 x = piece.position(t);
      return gapTo(racketAt(racket_->at(from_s + t), x), x, piece.velocity(t));
    };
    return firstMeeting(gap, h, racket_->mostRelativeAcceleration(most, speed, far_mm), near_mm_);
  }

  /// Moves the ball out of a racket or court that it overlaps. A ball that was put elsewhere no longer rests.
  void begin() {
    Vec3& x = ball_.position_mm;
    if (state_.rest == BallRest::on_racket && (racket_ == nullptr || racket_->teleported()))
      state_.rest = BallRest::flies;
    if (racket_ != nullptr) {
      const Surface surface = racketAt(racket_->at(0.0), x);
      const double gap = gapTo(surface, x, {}).mm;
      if (gap < -near_mm_) x = surface.point_mm + p_.radius_mm * surface.normal;
      if (state_.rest == BallRest::on_racket && gap > kLostTouch * p_.radius_mm) state_.rest = BallRest::flies;
    }
    if (p_.court) {
      const double gap = gapTo(court(), x, {}).mm;
      if (gap < -near_mm_) x.z = p_.court_z_mm + p_.radius_mm;
      if (state_.rest == BallRest::on_court && gap > kLostTouch * p_.radius_mm) state_.rest = BallRest::flies;
    } else if (state_.rest == BallRest::on_court) {
      state_.rest = BallRest::flies;
    }
  }

  /// @return how long, up to the next impact
  double fly(double left_s) {
    const FlightPiece piece = flightPiece(ball_.position_mm, ball_.velocity_mm_per_s, 1e3 * p_.gravity_m_per_s2,
                                          1e-3 * p_.drag_per_m, left_s);
    const double from_s = dt_s_ - left_s;
    std::optional<double> racket = meetRacket(piece, from_s), ground;
    if (p_.court) {
      const auto gap = [&](double t) {
        return Gap{piece.position(t).z - p_.radius_mm - p_.court_z_mm, piece.velocity(t).z};
      };
      ground = firstMeeting(gap, piece.length_s, piece.mostAcceleration(), near_mm_);
    }
    if (racket && ground) (*racket <= *ground ? ground : racket).reset();
    const double t = racket ? *racket : ground.value_or(piece.length_s);
    ball_.position_mm = piece.position(t);
    ball_.velocity_mm_per_s = piece.velocity(t);
    if (racket) strike(racketAt(racket_->at(from_s + t), ball_.position_mm), from_s + t);
    if (ground) strike(court(), from_s + t);
    return t;
  }

  void strike(const Surface& surface, double at_s) {
    const double speed = -dot(ball_.velocity_mm_per_s - surface.velocity_mm_per_s, surface.normal);
    const bool rests = speed < p_.rest_speed_mm_per_s || out_.impacts >= kMostImpacts;
    const double after = std::max(rests ? 0.0 : surface.restitution * speed, kLeaves * p_.rest_speed_mm_per_s);
    const Vec3 impulse_Ns = push(surface, p_.mass_kg * (speed + after));
    if (surface.racket) state_.pending_impulse_Ns = state_.pending_impulse_Ns + impulse_Ns;
    if (rests) state_.rest = surface.racket ? BallRest::on_racket : BallRest::on_court;
    if (!(speed > kCounted * p_.rest_speed_mm_per_s)) return;
    if (out_.impacts < static_cast<int>(BallStep::kImpactsKept)) {
      out_.first_impacts[static_cast<std::size_t>(out_.impacts)] = {
          .ago_s = dt_s_ - at_s, .racket = surface.racket, .point_mm = surface.point_mm, .impulse_Ns = impulse_Ns};
    }
    ++out_.impacts;
  }

  /// A surface's impulse on the ball, of this size along the normal in kg·mm/s, with the friction that goes with it.
  /// @return what acts on the surface, N·s
  Vec3 push(const Surface& surface, double along) {
    const Vec3 arm = -p_.radius_mm * surface.normal;
    const Vec3 slip = tangential(ball_.velocity_mm_per_s - surface.velocity_mm_per_s + cross(ball_.spin_rad_per_s, arm),
                                 surface.normal);
    const double sliding = length(slip);
    const double to_roll = p_.mass_kg * sliding / (1.0 + 1.0 / p_.inertia);
    const double across = sliding > 0.0 ? -std::min(surface.friction * along, to_roll) / sliding : 0.0;
    const Vec3 impulse = along * surface.normal + across * slip;
    ball_.velocity_mm_per_s = ball_.velocity_mm_per_s + (1.0 / p_.mass_kg) * impulse;
    ball_.spin_rad_per_s =
        ball_.spin_rad_per_s + (1.0 / (p_.inertia * p_.mass_kg * p_.radius_mm * p_.radius_mm)) * cross(arm, impulse);
    if (surface.racket) out_.point_mm = surface.point_mm;
    return -kNewton * impulse;
  }

  /// On racket or court, to the end of the step.
  /// @return how long; 0 when it leaves, or is struck
  double lie(double left_s) { return state_.rest == BallRest::on_racket ? lieOnRacket(left_s) : lieOnCourt(left_s); }

  double lieOnRacket(double left_s) {
    const RacketPose from = racket_->at(dt_s_ - left_s), to = racket_->at(dt_s_);
    const Vec3 x = ball_.position_mm, v = ball_.velocity_mm_per_s;
    if (-gapTo(racketAt(from, x), x, v).rate_mm_per_s >= p_.rest_speed_mm_per_s) return leave();  // it is struck
    // Carried along with the plate.
    const Vec3 apart = x - from.centre_mm;
    const auto carried = [&](const Vec3& a) {
      return dot(a, from.along) * to.along + dot(a, cross(from.normal, from.along)) * cross(to.normal, to.along) +
             dot(a, from.normal) * to.normal;
    };
    const Vec3 with = to.centre_mm + carried(apart);
    const Vec3 falling = v + Vec3{0.0, 0.0, -1e3 * p_.gravity_m_per_s2 * left_s};
    const Surface surface = racketAt(to, with);
    const double apart_speed = gapTo(surface, with, falling).rate_mm_per_s;
    if (apart_speed >= 0.0) return leave();
    ball_.velocity_mm_per_s = falling;
    pressed_Ns_ = pressed_Ns_ + push(surface, -p_.mass_kg * apart_speed);
    const Vec3 before = carried(v - racket_->velocity(from, x));
    const Vec3 after = ball_.velocity_mm_per_s - racket_->velocity(to, with);
    const Vec3 moved = with + left_s * tangential(0.5 * (before + after), surface.normal);
    const Surface there = racketAt(to, moved);
    if (gapTo(there, moved, {}).mm > kLostTouch * p_.radius_mm) {  // past the rim
      ball_.position_mm = moved;
      state_.rest = BallRest::flies;
      return left_s;
    }
    ball_.position_mm = there.point_mm + p_.radius_mm * there.normal;
    if (p_.court && ball_.position_mm.z < p_.court_z_mm + p_.radius_mm) {  // pressed against the court
      ball_.position_mm.z = p_.court_z_mm + p_.radius_mm;
      ball_.velocity_mm_per_s.z = std::max(0.0, ball_.velocity_mm_per_s.z);
      state_.rest = BallRest::on_court;
    }
    return left_s;
  }

  double lieOnCourt(double left_s) {
    const Vec3 v = ball_.velocity_mm_per_s;
    if (v.z > 2.0 * kLeaves * p_.rest_speed_mm_per_s || !(p_.gravity_m_per_s2 > 0.0)) return leave();
    ball_.velocity_mm_per_s = {v.x, v.y, 0.0};
    static_cast<void>(push(court(), p_.mass_kg * 1e3 * p_.gravity_m_per_s2 * left_s));
    ball_.velocity_mm_per_s.z = 0.0;
    const Vec3 from{v.x, v.y, 0.0};
    const FlightPiece piece{ball_.position_mm, from, (0.5 / left_s) * (ball_.velocity_mm_per_s - from), {}, left_s};
    const double from_s = dt_s_ - left_s;
    const auto racket = meetRacket(piece, from_s);
    const double t = racket.value_or(left_s);
    ball_.position_mm = piece.position(t);
    ball_.velocity_mm_per_s = piece.velocity(t);
    if (!racket) return left_s;
    state_.rest = BallRest::flies;
    strike(racketAt(racket_->at(from_s + t), ball_.position_mm), from_s + t);
    return t;
  }

  double leave() {
    state_.rest = BallRest::flies;
    return 0.0;
  }

  const BallParameters& p_;
  Plate plate_;
  BallGameState& state_;
  BallState& ball_;
  const RacketMotion* racket_;
  double dt_s_;
  double near_mm_;
  Vec3 pressed_Ns_;
  BallStep& out_;
};

/// Impulses of impacts and of a ball at rest both decay with contact_time_s.
/// @return the mean force of the step
Vec3 felt(const BallParameters& parameters, Vec3& pending_impulse_Ns, const Vec3& pressed_Ns, double dt_s) {
  const double stays = math::exp(-dt_s / parameters.contact_time_s);
  const Vec3 press_N = (1.0 / dt_s) * pressed_Ns;
  const Vec3 owed_now = stays * pending_impulse_Ns + ((1.0 - stays) * parameters.contact_time_s) * press_N;
  const Vec3 force = (1.0 / dt_s) * (pending_impulse_Ns - owed_now) + press_N;
  pending_impulse_Ns = owed_now;
  const double size = length(force);
  return size > parameters.most_force_N ? (parameters.most_force_N / size) * force : force;
}

bool refused(const BallState& ball) {
  return firstRefusal(ball.position_mm, ball.velocity_mm_per_s, ball.spin_rad_per_s) != Refusal::none;
}

}  // namespace

BallStep stepBall(const BallParameters& parameters, BallGameState& state, const std::optional<RacketPose>& racket,
                  double dt_s) {
  BallStep out;
  std::optional<RacketPose> to = racket;
  const BallState& ball = state.ball;
  out.refusal = firstRefusal(dt_s, ball.position_mm, ball.velocity_mm_per_s, ball.spin_rad_per_s);
  if (to && out.refusal == Refusal::none) out.refusal = firstRefusal(to->centre_mm, to->normal, to->along);
  if (to && out.refusal == Refusal::none && !orthonormalise(*to)) out.refusal = Refusal::not_a_number;
  if (out.refusal != Refusal::none) return out;
  if (to) out.point_mm = to->centre_mm;
  std::optional<RacketMotion> motion;
  if (to) {
    motion.emplace(state.racket_known ? state.racket : *to, *to, dt_s, 1e3 * parameters.racket_most_speed_m_per_s);
  }
  const Vec3 pressed_Ns = Step(parameters, state, motion ? &*motion : nullptr, dt_s, out).run();
  out.rest = state.rest;
  out.force_N = felt(parameters, state.pending_impulse_Ns, pressed_Ns, dt_s);
  state.racket_known = to.has_value();
  if (to) state.racket = *to;
  return out;
}

BallState flyBall(const BallParameters& parameters, const BallState& ball, double seconds) {
  if (refused(ball) || !(seconds > 0.0 && seconds <= kLongest_s)) return ball;
  BallGameState state{.ball = ball, .racket = {}, .pending_impulse_Ns = {}};
  double left_s = seconds;
  while (left_s > kInstant_s) {
    BallStep step;
    static_cast<void>(Step(parameters, state, nullptr, std::min(left_s, kLongestStep_s), step).run());
    left_s -= kLongestStep_s;
  }
  return state.ball;
}

std::optional<Meeting> meetPlane(const BallParameters& parameters, const BallState& ball, const Vec3& point_mm,
                                 const Vec3& normal, double within_s) {
  const Vec3 n = unit(normal);
  if (refused(ball) || firstRefusal(point_mm, normal) != Refusal::none || squared(n) == 0.0 ||
      !(within_s > 0.0 && within_s <= kLongest_s)) {
    return std::nullopt;
  }
  const double near_mm = kTouch * parameters.radius_mm + kTouchRounding * length(ball.position_mm);
  const double side = dot(ball.position_mm - point_mm, n) < 0.0 ? -1.0 : 1.0;
  BallState now = ball;
  for (double left_s = within_s; left_s > 0.0;) {
    const FlightPiece piece = flightPiece(now.position_mm, now.velocity_mm_per_s, 1e3 * parameters.gravity_m_per_s2,
                                          1e-3 * parameters.drag_per_m, left_s);
    const auto gap = [&](double t) {
      return Gap{side * dot(piece.position(t) - point_mm, n) - parameters.radius_mm, side * dot(piece.velocity(t), n)};
    };
    const auto met = firstMeeting(gap, piece.length_s, piece.mostAcceleration(), near_mm);
    const double t = met.value_or(piece.length_s);
    now.position_mm = piece.position(t);
    now.velocity_mm_per_s = piece.velocity(t);
    left_s -= t;
    if (met) return Meeting{within_s - left_s, now};
  }
  return std::nullopt;
}

double energyOf(const BallParameters& parameters, const BallState& ball) {
  const double r = parameters.radius_mm;
  const double mJ = 0.5 * parameters.mass_kg *
                        (squared(ball.velocity_mm_per_s) + parameters.inertia * r * r * squared(ball.spin_rad_per_s)) +
                    parameters.mass_kg * 1e3 * parameters.gravity_m_per_s2 * ball.position_mm.z;
  return 1e-6 * mJ;
}

}  // namespace fyd::scene
