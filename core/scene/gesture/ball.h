// Ballistic object (tele-gesture paper): a ball, a racket in the hand, and the court beneath.
//
// Flight: gravity, and drag by the square of the speed. Without drag the parabola itself; with drag the classic
// Runge-Kutta method in pieces of at most 2 ms. Collision: within a step the racket moves at constant velocity and
// angular rate from pose to pose, and the ball meets it at the first time at which the distance from its centre to the
// plate equals its radius. No collision is missed: from a time t on, with distance f, its rate f' and the largest
// relative acceleration A, a convex plate cannot be met before f + f'·h − A·h²/2 = 0. Face and rim are treated alike; a
// step may hold several impacts.
//
// Impact: along the normal, speed after = restitution · speed before, relative to the racket, which no ball moves;
// across it, friction, which spins the ball. Below `rest_speed_mm_per_s` a ball does not rebound: it rests on the
// racket and moves along with it until the racket falls away faster. An impact is felt over `contact_time_s`: its
// impulse is given out as a force that decays exponentially. A ball at rest is felt with its weight.
//
// After each stroke one message (BallState with its date) is all that another end needs: `flyBall` gives the flight
// since, with the bounces on the court, and `meetPlane` when and where it will arrive.
// Stability: may change
#pragma once

#include <array>
#include <optional>

#include "core/base/api.h"
#include "core/base/state.h"
#include "core/scene/gesture/gesture.h"
#include "core/scene/gesture/racket.h"

namespace fyd::scene {

struct BallParameters {
  double radius_mm = 33.0;
  double mass_kg = 0.058;
  double gravity_m_per_s2 = 9.81;
  double drag_per_m = 0.0;
  double inertia = 2.0 / 3.0;
  double restitution = 0.75;
  double friction = 0.0;
  double rest_speed_mm_per_s = 50.0;
  double contact_time_s = 0.005;
  double most_force_N = 6.4;

  RacketShape racket_shape = RacketShape::disc;
  double racket_width_mm = 250.0;
  double racket_height_mm = 250.0;
  double racket_most_speed_m_per_s = 50.0;

  bool court = true;
  double court_z_mm = 0.0;
  double court_restitution = 0.75;
  double court_friction = 0.0;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("ball.radius_mm", radius_mm, {.unit = "mm", .minimum = 0.01, .maximum = 1e4, .help = "Radius of the ball."});
    v.real("ball.mass_kg", mass_kg, {.unit = "kg", .minimum = 1e-6, .maximum = 100, .help = "Mass of the ball."});
    v.real("ball.gravity_m_per_s2", gravity_m_per_s2,
           {.unit = "m/s²", .minimum = 0, .maximum = 1000, .help = "Acceleration of gravity, downwards (against z)."});
    v.real("ball.drag_per_m", drag_per_m,
           {.unit = "1/m",
            .minimum = 0,
            .maximum = 10,
            .help = "Air drag: the ball's deceleration divided by the square of its speed; 0: none. Of a real ball: "
                    "air density × drag coefficient × cross section / (2 × mass)."});
    v.real("ball.inertia", inertia,
           {.minimum = 0.01,
            .maximum = 1,
            .help = "Moment of inertia divided by mass × radius²: 2/5 for a solid ball, 2/3 for a hollow one. With "
                    "more, friction spins the ball less."});
    v.real("ball.restitution", restitution,
           {.minimum = 0,
            .maximum = 1,
            .help = "Bounce on the racket: speed after an impact divided by the speed before it."});
    v.real("ball.friction", friction,
           {.minimum = 0,
            .maximum = 2,
            .help = "Friction coefficient between ball and racket; with more, a glancing stroke spins the ball more."});
    v.real("ball.rest_speed_mm_per_s", rest_speed_mm_per_s,
           {.unit = "mm/s",
            .minimum = 0.01,
            .maximum = 1e4,
            .help = "Impacts slower than this do not bounce: the ball stays on the racket or the court."});
    v.real("ball.contact_time_s", contact_time_s,
           {.unit = "s",
            .minimum = 1e-4,
            .maximum = 1,
            .help = "Time in which the force felt after an impact falls to about a third; a longer time makes it "
                    "weaker and softer."});
    v.real("ball.most_force_N", most_force_N,
           {.unit = "N",
            .minimum = 0,
            .maximum = 1e4,
            .help = "Largest force that the hand feels; larger ones are reduced to it."});
    v.choice("ball.racket_shape", racket_shape, kRacketShapes,
             {.help = "Shape of the racket, a thin plate that strikes with both faces."});
    v.real("ball.racket_width_mm", racket_width_mm,
           {.unit = "mm",
            .minimum = 1,
            .maximum = 1e5,
            .help = "Width of a rectangular racket, along its own x axis; the diameter of a disc."});
    v.real("ball.racket_height_mm", racket_height_mm,
           {.unit = "mm",
            .minimum = 1,
            .maximum = 1e5,
            .help = "Height of a rectangular racket, at right angles to its width; a disc has none."});
    v.real("ball.racket_most_speed_m_per_s", racket_most_speed_m_per_s,
           {.unit = "m/s",
            .minimum = 0.1,
            .maximum = 1000,
            .help = "A racket that moves faster than this is taken as placed anew: it strikes nothing on its way."});
    v.boolean("ball.court", court, {.help = "Whether there is a court: a level floor from which the ball bounces."});
    v.real("ball.court_z_mm", court_z_mm,
           {.unit = "mm", .minimum = -1e6, .maximum = 1e6, .help = "Height of the court, as a z coordinate."});
    v.real("ball.court_restitution", court_restitution,
           {.minimum = 0,
            .maximum = 1,
            .help = "Bounce on the court: speed after an impact divided by the speed before it."});
    v.real("ball.court_friction", court_friction,
           {.minimum = 0,
            .maximum = 2,
            .help = "Friction coefficient between ball and court; with more, a glancing impact spins the ball more."});
  }
};

/// Where the game begins, and begins again when the ball no longer bounces on the court.
struct ServeParameters {
  double x_mm = 0.0, y_mm = 0.0, z_mm = 500.0;
  double x_mm_per_s = 0.0, y_mm_per_s = 0.0, z_mm_per_s = 0.0;

  template <class Visitor>
  void describe(Visitor& v) {
    const ParameterInfo place{
        .unit = "mm", .minimum = -1e6, .maximum = 1e6, .help = "Position of the ball's centre when it is served."};
    const ParameterInfo speed{
        .unit = "mm/s", .minimum = -1e6, .maximum = 1e6, .help = "Velocity of the ball when it is served."};
    v.real("serve.x_mm", x_mm, place);
    v.real("serve.y_mm", y_mm, place);
    v.real("serve.z_mm", z_mm, place);
    v.real("serve.x_mm_per_s", x_mm_per_s, speed);
    v.real("serve.y_mm_per_s", y_mm_per_s, speed);
    v.real("serve.z_mm_per_s", z_mm_per_s, speed);
  }
};

/// A ball at one moment: the content of the message after a stroke.
struct BallState {
  Vec3 position_mm;  ///< of its centre
  Vec3 velocity_mm_per_s;
  Vec3 spin_rad_per_s;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(position_mm, velocity_mm_per_s, spin_rad_per_s);
  }
};

enum class BallRest : std::uint8_t { flies, on_racket, on_court };

/// State carried from one step to the next.
struct BallGameState {
  BallState ball;
  bool racket_known = false;
  RacketPose racket;
  BallRest rest = BallRest::flies;
  Vec3 pending_impulse_Ns;  ///< impulse on the racket not felt yet

  template <class Archive>
  void serialize(Archive& archive) {
    archive(ball, racket_known, racket, within(rest, BallRest::on_court), pending_impulse_Ns);
  }
};

struct BallImpact {
  double ago_s = 0.0;  ///< before the end of the step
  bool racket = true;  ///< otherwise the court
  Vec3 point_mm;
  Vec3 impulse_Ns;  ///< on the racket or the court
};

struct BallStep {
  static constexpr std::size_t kImpactsKept = 8;
  Vec3 force_N;     ///< in the hand that holds the racket
  Vec3 point_mm;    ///< where it was touched last; the racket's centre before
  int impacts = 0;  ///< on racket and court; a ball at rest makes none
  std::array<BallImpact, kImpactsKept> first_impacts;
  BallRest rest = BallRest::flies;
  Refusal refusal = Refusal::none;
};

/// @param racket where it is at the end of the step; none: it strikes nothing
[[nodiscard]] FYD_API BallStep stepBall(const BallParameters& parameters, BallGameState& state,
                                        const std::optional<RacketPose>& racket, double dt_s);

/// The ball `seconds` later, 0 … 60 s, without rackets: extrapolates the message of a stroke to the present.
/// @return the ball as it was when an input is no number or no such time
[[nodiscard]] FYD_API BallState flyBall(const BallParameters& parameters, const BallState& ball, double seconds);

/// Where the surface of a ball will meet a plane first, court and rackets left out.
struct Meeting {
  double after_s = 0.0;
  BallState ball;
};
/// @param normal of any length but 0; the plane is met from either side
/// @param within_s at most 60 s
[[nodiscard]] FYD_API std::optional<Meeting> meetPlane(const BallParameters& parameters, const BallState& ball,
                                                       const Vec3& point_mm, const Vec3& normal, double within_s);

/// Kinetic energy (with spin) and potential energy above z = 0, J.
[[nodiscard]] FYD_API double energyOf(const BallParameters& parameters, const BallState& ball);

}  // namespace fyd::scene
