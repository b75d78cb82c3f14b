// Flights, bounces and energies against closed forms, and against a reference in the test that moves in steps of a
// microsecond and tries every one of them.
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "core/scene/gesture/ball.h"

namespace fyd::scene {
namespace {

constexpr long double kG = 9810.0L;

/// Height of a ball dropped from `height` above its rest, by hand: bounce after bounce.
long double bounced(long double height, long double e, long double t, std::vector<double>* times = nullptr) {
  long double v = std::sqrt(2.0L * kG * height), at = v / kG;  // first bounce
  if (t < at) return height - 0.5L * kG * t * t;
  for (;;) {
    if (times != nullptr) times->push_back(static_cast<double>(at));
    v *= e;
    const long double next = at + 2.0L * v / kG;
    if (t < next) return v * (t - at) - 0.5L * kG * (t - at) * (t - at);
    at = next;
  }
}

TEST(BallTruth, BouncesComeAtTheTimesOfTheClosedForm) {
  for (const bool on_racket : {true, false}) {
    for (const double dt_s : {0.0002, 0.001, 0.005, 0.25}) {
      BallParameters parameters;
      parameters.court = !on_racket;
      parameters.restitution = parameters.court_restitution = 0.8;
      BallGameState state;
      state.ball.position_mm = {20.0, 10.0, 33.0 + 700.0};
      std::vector<double> found, truth;
      double t = 0.0;
      for (int i = 1; t < 2.4999; ++i) {
        const std::optional<RacketPose> racket = on_racket ? std::optional(RacketPose{}) : std::nullopt;
        const BallStep step = stepBall(parameters, state, racket, dt_s);
        t = i * dt_s;
        for (int k = 0; k < std::min<int>(step.impacts, BallStep::kImpactsKept); ++k) {
          found.push_back(t - step.first_impacts[static_cast<std::size_t>(k)].ago_s);
        }
        ASSERT_NEAR(state.ball.position_mm.z - 33.0, static_cast<double>(bounced(700.0L, 0.8L, t)), 1e-7)
            << dt_s << " " << t;
      }
      static_cast<void>(bounced(700.0L, 0.8L, 2.5L, &truth));
      ASSERT_EQ(found.size(), truth.size());
      ASSERT_GT(truth.size(), 4U);
      for (std::size_t i = 0; i < truth.size(); ++i) ASSERT_NEAR(found[i], truth[i], 1e-10) << dt_s;
    }
  }
}

TEST(BallTruth, WithJitterTheFlightIsTheSame) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> step_s(0.0002, 0.005);
  BallParameters parameters;
  parameters.court_restitution = 0.8;
  BallGameState state;
  state.ball.position_mm.z = 33.0 + 700.0;
  double t = 0.0;
  while (t < 2.4) {
    const double dt_s = step_s(random);
    static_cast<void>(stepBall(parameters, state, std::nullopt, dt_s));
    t += dt_s;
    ASSERT_NEAR(state.ball.position_mm.z - 33.0, static_cast<double>(bounced(700.0L, 0.8L, t)), 1e-7);
  }
}

/// With drag, straight up: tan and tanh, in the field's closed form.
TEST(BallTruth, DragTakesWhatTheClosedFormSays) {
  for (const double drag : {0.001, 0.02, 0.5, 10.0}) {
    for (const double up_m_per_s : {2.0, 30.0, 400.0}) {
      BallParameters parameters;
      parameters.court = false;
      parameters.drag_per_m = drag;
      const double g = 9.81, terminal = std::sqrt(g / drag), rate = std::sqrt(g * drag);
      const double top_s = std::atan(up_m_per_s / terminal) / rate;
      const double top_m = std::log1p(up_m_per_s * up_m_per_s / (terminal * terminal)) / (2.0 * drag);
      BallGameState state;
      state.ball.velocity_mm_per_s.z = 1e3 * up_m_per_s;
      // Up to the top in odd steps, and one second down.
      double t = 0.0;
      for (; t + 0.0037 < top_s; t += 0.0037) static_cast<void>(stepBall(parameters, state, std::nullopt, 0.0037));
      if (top_s > t) static_cast<void>(stepBall(parameters, state, std::nullopt, top_s - t));
      EXPECT_NEAR(state.ball.position_mm.z, 1e3 * top_m, 1e-6 * 1e3 * top_m) << drag << " " << up_m_per_s;
      EXPECT_NEAR(state.ball.velocity_mm_per_s.z, 0.0, 1e-6 * 1e3 * up_m_per_s);
      const double began = state.ball.position_mm.z;
      for (int i = 0; i < 1000; ++i) static_cast<void>(stepBall(parameters, state, std::nullopt, 0.001));
      const double fallen_m = std::log(std::cosh(rate)) / drag;
      EXPECT_NEAR(began - state.ball.position_mm.z, 1e3 * fallen_m, 1e-6 * 1e3 * fallen_m);
    }
  }
}

struct Waved {
  Vec3 centre, reach;
  double turn = 0.0, w = 0.0, phase = 0.0;

  [[nodiscard]] RacketPose at(double t) const {
    const double a = turn * std::sin(1.3 * w * t + phase), b = 0.5 * turn * std::cos(0.7 * w * t);
    RacketPose out{.centre_mm = centre + std::sin(w * t + phase) * reach,
                   .normal = {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)},
                   .along = {std::cos(a), 0.0, -std::sin(a)}};
    return out;
  }
};

/// Tries every microsecond: where the ball is nearer to the disc than its radius and comes nearer, it is struck.
/// The racket moves evenly within each step of dt_s, as the code says of itself.
struct Reference {
  const BallParameters& p;
  BallState ball;
  int impacts = 0;

  [[nodiscard]] Vec3 nearest(const RacketPose& pose, Vec3 x) const {
    const Vec3 n = unit(pose.normal);
    const Vec3 flat = (x - pose.centre_mm) - dot(x - pose.centre_mm, n) * n;
    const double out = length(flat), radius = 0.5 * p.racket_width_mm;
    return pose.centre_mm + std::min(1.0, radius / std::max(out, 1e-300)) * flat;
  }
  void step(const RacketPose& from, const RacketPose& to, double dt_s) {
    constexpr int kParts = 1000;
    const double h = dt_s / kParts;
    const auto frame = [](const RacketPose& pose) {
      const Vec3 n = unit(pose.normal), u = unit(pose.along - dot(pose.along, n) * n), w = cross(n, u);
      Eigen::Matrix3d out;
      out << u.x, w.x, n.x, u.y, w.y, n.y, u.z, w.z, n.z;
      return Eigen::Quaterniond(out);
    };
    const Eigen::Quaterniond first = frame(from), last = frame(to);
    const auto mixed = [&](const RacketPose& one, const RacketPose& other, double share) {
      const Eigen::Matrix3d turned = first.slerp(share, last).toRotationMatrix();
      return RacketPose{one.centre_mm + share * (other.centre_mm - one.centre_mm),
                        {turned(0, 2), turned(1, 2), turned(2, 2)},
                        {turned(0, 0), turned(1, 0), turned(2, 0)}};
    };
    for (int i = 0; i < kParts; ++i) {
      const RacketPose now = mixed(from, to, double(i + 1) / kParts), before = mixed(from, to, double(i) / kParts);
      const Vec3 a{0.0, 0.0, -1e3 * p.gravity_m_per_s2};
      const Vec3 was = ball.position_mm;
      ball.position_mm = was + h * ball.velocity_mm_per_s + (0.5 * h * h) * a;
      ball.velocity_mm_per_s = ball.velocity_mm_per_s + h * a;
      const Vec3 point = nearest(now, ball.position_mm), n = unit(ball.position_mm - point);
      const double gap = length(ball.position_mm - point) - p.radius_mm;
      const double gap_before = length(was - nearest(before, was)) - p.radius_mm;
      if (gap >= 0.0 || gap > gap_before) continue;
      // The place of the plate's own point, a part before.
      const Vec3 arm = point - now.centre_mm;
      const auto across = [](const RacketPose& pose) { return cross(pose.normal, pose.along); };
      const Vec3 earlier = before.centre_mm + dot(arm, now.along) * before.along +
                           dot(arm, across(now)) * across(before) + dot(arm, now.normal) * before.normal;
      const double speed = dot(ball.velocity_mm_per_s - (1.0 / h) * (point - earlier), n);
      ball.velocity_mm_per_s = ball.velocity_mm_per_s - ((1.0 + p.restitution) * speed) * n;
      ++impacts;
    }
  }
};

TEST(BallTruth, StrokesOfAWavedRacketAreThoseOfAReferenceAThousandTimesFiner) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int strokes = 0, none = 0, multiple = 0;
  std::vector<double> differences_mm;
  for (int i = 0; i < 90; ++i) {
    BallParameters parameters;
    parameters.court = false;
    const double dt_s = i % 3 == 0 ? 0.001 : i % 3 == 1 ? 0.005 : 0.0005;
    const Waved racket{{60.0 * any(random), 60.0 * any(random), 0.0},
                       {40.0 * any(random), 40.0 * any(random), 120.0 * any(random)},
                       0.4 * any(random),
                       20.0 + 15.0 * any(random),
                       3.0 * any(random)};
    BallGameState state;
    state.ball = {{160.0 * any(random), 160.0 * any(random), 400.0 + 100.0 * any(random)},
                  {500.0 * any(random), 500.0 * any(random), -3000.0 + 2500.0 * any(random)},
                  {}};
    static_cast<void>(stepBall(parameters, state, racket.at(0.0), 1e-6));
    Reference reference{parameters, state.ball};
    int impacts = 0;
    bool gentle = false;
    for (int k = 0; k * dt_s < 0.4; ++k) {
      const BallStep step = stepBall(parameters, state, racket.at((k + 1) * dt_s), dt_s);
      impacts += step.impacts;
      for (int m = 0; m < std::min<int>(step.impacts, BallStep::kImpactsKept); ++m) {
        const double impulse = length(step.first_impacts[static_cast<std::size_t>(m)].impulse_Ns);
        gentle = gentle || impulse < 0.058 * 0.15 * 1.75;  // near the speed at which it rests
      }
      RacketPose from = racket.at(k * dt_s), to = racket.at((k + 1) * dt_s);
      static_cast<void>(orthonormalise(from));
      static_cast<void>(orthonormalise(to));
      reference.step(from, to, dt_s);
    }
    if (gentle) continue;
    if (impacts != reference.impacts) {
      // Only where the reference itself was about to miss, or to hit, by a micrometre: not in these.
      ADD_FAILURE() << i << ": " << impacts << " and " << reference.impacts;
      continue;
    }
    none += impacts == 0;
    strokes += impacts > 0;
    multiple += impacts > 1;
    const double apart = length(state.ball.position_mm - reference.ball.position_mm);
    differences_mm.push_back(apart);
    EXPECT_LT(apart, 10.0) << i << " after " << impacts;  // the reference's own: 5 µs late at a rim turn the ball
  }
  std::ranges::sort(differences_mm);
  const double middle_mm = differences_mm[differences_mm.size() / 2];
  EXPECT_LT(middle_mm, 0.1);
  EXPECT_GT(strokes, 30);
  EXPECT_GT(none, 10);
  EXPECT_GT(multiple, 2);
  std::printf("%d with strokes (%d with several), %d without: after 0.4 s %.3f mm apart at most, %.4f in the middle\n",
              strokes, multiple, none, differences_mm.back(), middle_mm);
}

/// Kinetic, of the spin and potential above z = 0, J; written out in SI units, whatever the code says of it.
double joules(const BallParameters& p, const BallState& ball) {
  const auto squared_SI = [](const Vec3& v, double unit) { return unit * unit * (v.x * v.x + v.y * v.y + v.z * v.z); };
  const double radius_m = 1e-3 * p.radius_mm;
  const double moment_kg_m2 = p.inertia * p.mass_kg * radius_m * radius_m;
  return 0.5 * p.mass_kg * squared_SI(ball.velocity_mm_per_s, 1e-3) +
         0.5 * moment_kg_m2 * squared_SI(ball.spin_rad_per_s, 1.0) +
         p.mass_kg * p.gravity_m_per_s2 * 1e-3 * ball.position_mm.z;
}

TEST(BallTruth, EnergyIsNeverMoreThanRestitutionAllows) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> any(-1.0, 1.0), step_s(0.0002, 0.005);
  int conserved = 0;
  for (int i = 0; i < 200; ++i) {
    BallParameters parameters;
    parameters.restitution = parameters.court_restitution = i % 4 == 0 ? 1.0 : 0.5 + 0.5 * std::abs(any(random));
    parameters.friction = parameters.court_friction = i % 2 == 0 ? 0.0 : std::abs(any(random));
    parameters.drag_per_m = i % 3 == 0 ? 0.0 : 0.02;
    parameters.rest_speed_mm_per_s = i % 5 == 0 ? 200.0 : 5.0;
    const double tilt = 0.7 * any(random);  // a racket that is held still
    const RacketPose racket{.centre_mm = {0.0, 0.0, 300.0}, .normal = {std::sin(tilt), 0.0, std::cos(tilt)}};
    BallGameState state;
    state.ball = {{80.0 * any(random), 80.0 * any(random), 700.0},
                  {1000.0 * any(random), 1000.0 * any(random), 2000.0 * any(random)},
                  {100.0 * any(random), 100.0 * any(random), 100.0 * any(random)}};
    double energy = joules(parameters, state.ball);
    const double first = energy;
    int impacts = 0;
    double kept = energy;
    for (int k = 0; k < 1000; ++k) {
      const BallStep step = stepBall(parameters, state, racket, step_s(random));
      impacts += step.impacts;
      const double now = joules(parameters, state.ball);
      ASSERT_NEAR(energyOf(parameters, state.ball), now, 1e-12 * first) << i << " " << k;
      ASSERT_LE(now, energy + 1e-9 * first) << i << " " << k;
      energy = now;
      if (step.rest != BallRest::flies) kept = -1.0;
    }
    if (i % 4 == 0 && i % 2 == 0 && i % 3 == 0 && kept >= 0.0) {
      ASSERT_NEAR(energy, first, 1e-9 * first) << i;  // nothing takes any
      ++conserved;
    }
    ASSERT_GT(impacts, 0);
  }
  EXPECT_GT(conserved, 12);
}

/// One message after a stroke is all that the other end needs.
TEST(BallTruth, TwoEndsAgreeFromOneMessage) {
  for (const double drag : {0.0, 0.02}) {
    BallParameters parameters;
    parameters.drag_per_m = drag;
    parameters.court_friction = 0.3;
    const BallState stroke{{-5000.0, 300.0, 900.0}, {18'000.0, -700.0, 4000.0}, {0.0, 150.0, 0.0}};
    BallGameState here;
    here.ball = stroke;
    for (int i = 1; i <= 2000; ++i) {
      static_cast<void>(stepBall(parameters, here, std::nullopt, 0.001));
      if (i % 97 != 0) continue;
      const BallState there = flyBall(parameters, stroke, 0.001 * i), again = flyBall(parameters, stroke, 0.001 * i);
      EXPECT_LT(length(there.position_mm - here.ball.position_mm), 1e-5) << drag << " " << i;
      EXPECT_LT(length(there.velocity_mm_per_s - here.ball.velocity_mm_per_s), 1e-4);
      // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked for; there is no padding
      EXPECT_EQ(std::memcmp(&there, &again, sizeof(there)), 0);
    }
  }
}

TEST(BallTruth, WhereItWillMeetAPlaneIsWhereItDoes) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  BallParameters parameters;
  parameters.court = false;
  int met_some = 0, missed = 0;
  for (int i = 0; i < 2000; ++i) {
    const BallState ball{
        {0.0, 0.0, 1000.0}, {10'000.0 * any(random), 10'000.0 * any(random), 8000.0 * any(random)}, {}};
    const Vec3 n = unit(Vec3{any(random), any(random), 0.3 * any(random)});
    const Vec3 point{3000.0 * any(random), 3000.0 * any(random), 1000.0 * any(random)};
    // Roots of the parabola's distance, in long double; the first of the side it is on.
    const long double side = dot(ball.position_mm - point, n) < 0.0 ? -1.0L : 1.0L;
    const long double c = side * dot(ball.position_mm - point, n) - 33.0L, b = side * dot(ball.velocity_mm_per_s, n),
                      a = -0.5L * kG * side * n.z;
    if (c <= 0.0L) continue;
    std::vector<long double> roots;
    const long double inside = b * b - 4.0L * a * c;
    if (inside >= 0.0L) {
      for (const long double sign : {-1.0L, 1.0L}) {
        const long double t = (-b + sign * std::sqrt(inside)) / (2.0L * a);
        if (t > 0.0L && t <= 2.0L && b + 2.0L * a * t < 0.0L) roots.push_back(t);
      }
    }
    const auto met = meetPlane(parameters, ball, point, 3.0 * n, 2.0);
    ASSERT_EQ(met.has_value(), !roots.empty()) << i;
    if (!met) {
      ++missed;
      continue;
    }
    ++met_some;
    const double truth = static_cast<double>(*std::min_element(roots.begin(), roots.end()));
    ASSERT_NEAR(met->after_s, truth, 1e-9 + 1e-9 / std::abs(double(b + 2.0L * a * truth))) << i;
    const BallState there = flyBall(parameters, ball, met->after_s);
    ASSERT_LT(length(there.position_mm - met->ball.position_mm), 1e-6);
  }
  EXPECT_GT(met_some, 300);
  EXPECT_GT(missed, 300);
  parameters.drag_per_m = 0.02;
  const BallState stroke{{-5000.0, 0.0, 900.0}, {18'000.0, 0.0, 4000.0}, {}};
  const auto met = meetPlane(parameters, stroke, {2000.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 2.0);
  ASSERT_TRUE(met.has_value());
  BallGameState state;
  state.ball = stroke;
  double t = 0.0;
  for (; state.ball.position_mm.x < 2000.0 - 33.0; t += 1e-5) {
    static_cast<void>(stepBall(parameters, state, std::nullopt, 1e-5));
  }
  EXPECT_NEAR(met->after_s, t, 2e-5);
}

}  // namespace
}  // namespace fyd::scene
