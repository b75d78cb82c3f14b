// Ball and racket: hard cases. Flights and bounces against closed forms: tests/numerics/scene.
#include "core/scene/gesture/ball.h"

#include <cmath>
#include <limits>
#include <type_traits>

#include <gtest/gtest.h>

#include "tests/not_a_number.h"
#include "tests/sweep.h"

namespace fyd::scene {
namespace {

static_assert(std::is_trivially_copyable_v<BallGameState>);

BallParameters still() {  // nothing pulls
  BallParameters out;
  out.gravity_m_per_s2 = 0.0;
  out.court = false;
  return out;
}

TEST(Ball, AMovingRacketGivesItsSpeedAtTheMomentTheyMeet) {
  BallParameters parameters = still();
  parameters.restitution = 0.8;
  for (const double dt_s : {0.0002, 0.001, 0.005}) {
    for (const double face : {1.0, -1.0}) {
      BallGameState state;
      state.ball = {{0.0, 0.0, face * 100.0}, {0.0, 0.0, face * -2000.0}, {}};
      // The racket comes at 3 m/s: 67 mm at 5 m/s.
      const double meets_s = 67.0 / 5000.0;
      double found_s = 0.0, before_s = 0.0;
      for (int i = 1; i * dt_s < 0.05; ++i) {
        const BallStep step =
            stepBall(parameters, state, RacketPose{.centre_mm = {0.0, 0.0, face * 3000.0 * (i - 1) * dt_s}}, dt_s);
        before_s = (i - 1) * dt_s;  // the racket stood still in the first step
        if (step.impacts > 0) {
          ASSERT_EQ(found_s, 0.0);
          found_s = before_s - step.first_impacts[0].ago_s;
          EXPECT_NEAR(step.first_impacts[0].impulse_Ns.z, face * -0.058 * 1.8 * 5.0, 1e-12);
          EXPECT_TRUE(step.first_impacts[0].racket);
        }
      }
      // In the first step the racket stood still while the ball flew on: 2 m/s for dt_s longer.
      EXPECT_NEAR(found_s, meets_s - 2000.0 * dt_s / 5000.0, 1e-12);
      EXPECT_NEAR(state.ball.velocity_mm_per_s.z, face * (3000.0 + 0.8 * 5000.0), 1e-9);
    }
  }
}

TEST(Ball, ARacketThatTurnsStrikesWithTheSpeedOfThePlaceItHits) {
  const BallParameters parameters = still();
  BallGameState state;
  state.ball = {{100.0, 0.0, 40.0}, {}, {}};  // 100 mm from the axis, y
  const double rate = 10.0;                   // rad/s, upwards there
  int impacts = 0;
  for (int i = 0; i < 40 && impacts == 0; ++i) {
    const double angle = -rate * 0.001 * i;
    const RacketPose pose{.centre_mm = {},
                          .normal = {std::sin(angle), 0.0, std::cos(angle)},
                          .along = {std::cos(angle), 0.0, -std::sin(angle)}};
    impacts = stepBall(parameters, state, pose, 0.001).impacts;
  }
  ASSERT_EQ(impacts, 1);
  // It met where 40·cos − 100·sin = 33; the plate's point under it moves along the normal at rate × its distance.
  const double a = std::atan2(40.0, 100.0) - std::asin(33.0 / std::hypot(100.0, 40.0));
  const double out = 100.0 * std::cos(a) + 40.0 * std::sin(a);
  EXPECT_NEAR(length(state.ball.velocity_mm_per_s), 1.75 * rate * out, 1e-6);
  EXPECT_NEAR(state.ball.velocity_mm_per_s.x / state.ball.velocity_mm_per_s.z, -std::tan(a), 1e-9);
}

TEST(Ball, AtSpeedsFarBeyondTheRacketsThicknessItIsNeverPassedThrough) {
  BallParameters parameters = still();
  parameters.racket_most_speed_m_per_s = 200.0;
  parameters.radius_mm = 0.1;
  for (const double begin : stepsBefore(50.0, 400.0, 7.3)) {
    BallGameState state;
    state.ball = {{10.0, -20.0, begin}, {0.0, 0.0, -60'000.0}, {}};
    int impacts = 0;
    for (int i = 0; i < 20; ++i) {
      impacts += stepBall(parameters, state, RacketPose{.centre_mm = {0.0, 0.0, 100.0 * (i - 10)}}, 0.005).impacts;
    }
    ASSERT_EQ(impacts, 1) << begin;
    ASSERT_NEAR(state.ball.velocity_mm_per_s.z, 20'000.0 + 0.75 * 80'000.0, 1e-6) << begin;
  }
}

TEST(Ball, ABallThatGrazesTheRimIsTouchedOnlyIfItIsReached) {
  const BallParameters parameters = still();
  for (const double dt_s : {0.0002, 0.001, 0.005, 0.05}) {
    for (const double by : {-1e-3, -1e-6, 1e-6, 1e-3, 5.0}) {
      // Straight down past a disc of 125 mm; the ball's edge comes within `by` of its rim.
      BallGameState state;
      const Vec3 velocity{0.0, 0.0, -9000.0};
      state.ball = {{125.0 + 33.0 + by, 0.0, 150.0}, velocity, {}};
      int impacts = 0;
      for (int i = 0; i < static_cast<int>(0.05 / dt_s); ++i) {
        impacts += stepBall(parameters, state, RacketPose{}, dt_s).impacts;
      }
      if (by > 0.0) {
        ASSERT_EQ(impacts, 0) << dt_s << " " << by;
        ASSERT_EQ(state.ball.velocity_mm_per_s, velocity);
      } else {
        ASSERT_EQ(impacts, 1) << dt_s << " " << by;
        ASSERT_GT(state.ball.velocity_mm_per_s.x, 0.0);
        // The normal of the touch: cos = (33 + by)/33 from the side.
        const double along = std::sqrt(1.0 - std::pow((33.0 + by) / 33.0, 2.0));
        const double struck = 9000.0 * along;
        const double e = struck >= parameters.rest_speed_mm_per_s ? parameters.restitution : 0.0;
        ASSERT_NEAR(state.ball.velocity_mm_per_s.z, -9000.0 + (1.0 + e) * struck * along, 1e-3) << dt_s << " " << by;
      }
    }
  }
}

TEST(Ball, ARectangleHasCornersAndADiscHasNone) {
  for (const RacketShape shape : {RacketShape::disc, RacketShape::rectangle}) {
    BallParameters parameters = still();
    parameters.racket_shape = shape;
    parameters.racket_height_mm = 100.0;
    const auto strikes = [&](double x, double y) {
      BallGameState state;
      state.ball = {{x, y, 100.0}, {0.0, 0.0, -5000.0}, {}};
      return stepBall(parameters, state, RacketPose{}, 0.05).impacts > 0;
    };
    EXPECT_EQ(strikes(120.0, 45.0), true);
    EXPECT_EQ(strikes(124.0, 70.0), shape == RacketShape::rectangle || std::hypot(124.0, 70.0) < 158.0);
    EXPECT_EQ(strikes(0.0, 100.0), shape == RacketShape::disc);
    EXPECT_EQ(strikes(124.0 + 33.0 * 0.7, 49.0 + 33.0 * 0.7), shape == RacketShape::rectangle);
    EXPECT_EQ(strikes(126.0 + 33.0 * 0.72, 51.0 + 33.0 * 0.72), false);
  }
}

TEST(Ball, SeveralImpactsInOneStepAreAsManyInManySteps) {
  BallParameters parameters;
  parameters.court_z_mm = 0.0;
  parameters.restitution = parameters.court_restitution = 0.95;
  // Between the court and a racket 120 mm above it.
  const RacketPose above{.centre_mm = {0.0, 0.0, 120.0}};
  const auto play = [&](double dt_s, int& impacts) {
    BallGameState state;
    state.ball = {{0.0, 0.0, 60.0}, {0.0, 0.0, 20'000.0}, {}};
    for (int i = 0; i < static_cast<int>(std::lround(0.05 / dt_s)); ++i) {
      impacts += stepBall(parameters, state, above, dt_s).impacts;
    }
    return state.ball;
  };
  int few = 0, many = 0;
  const BallState one = play(0.05, few), other = play(0.0002, many);
  EXPECT_EQ(few, many);
  EXPECT_GT(few, 12);
  EXPECT_NEAR(one.position_mm.z, other.position_mm.z, 1e-6);
  EXPECT_NEAR(one.velocity_mm_per_s.z, other.velocity_mm_per_s.z, 1e-5);
}

TEST(Ball, AtRestOnTheRacketItLiesStillAndWeighsWhatItWeighs) {
  BallParameters parameters;
  parameters.court = false;
  BallGameState state;
  state.ball = {{5.0, -7.0, 33.0 + 200.0}, {}, {}};
  BallStep step;
  for (int i = 0; i < 6000; ++i) step = stepBall(parameters, state, RacketPose{}, 0.001);
  ASSERT_EQ(step.rest, BallRest::on_racket);
  const BallState first = state.ball;
  for (int i = 0; i < 1'000'000; ++i) {
    step = stepBall(parameters, state, RacketPose{}, i % 2 == 0 ? 0.0002 : 0.005);
    if (i < 2000) continue;
    ASSERT_NEAR(step.force_N.z, -0.058 * 9.81, 1e-12) << i;
    ASSERT_EQ(step.impacts, 0);
  }
  EXPECT_EQ(state.ball.position_mm, first.position_mm);  // a million steps without drift
  EXPECT_NEAR(state.ball.velocity_mm_per_s.norm(), 0.0, 1e-12);
}

TEST(Ball, OnARacketThatIsWavedItStaysWithoutHoppingUntilItFallsAwayFasterThanTheBall) {
  BallParameters parameters;
  parameters.court = false;
  for (const double most_g : {0.6, 1.4}) {  // of the racket's acceleration
    BallGameState state;
    state.ball = {{0.0, 0.0, 33.0}, {}, {}};
    const double w = 2.0 * M_PI * 3.0, amplitude = most_g * 9810.0 / (w * w);
    int impacts = 0;
    double apart = 0.0;
    for (int i = 0; i < 5000; ++i) {
      const double begin = std::min(1.0, i / 1000.0), z = begin * begin * amplitude * std::sin(w * 0.001 * i);
      const BallStep step = stepBall(parameters, state, RacketPose{.centre_mm = {0.0, 0.0, z}}, 0.001);
      impacts += step.impacts;
      apart = std::max(apart, state.ball.position_mm.z - z - 33.0);
    }
    if (most_g < 1.0) {
      EXPECT_LE(apart, 1e-9);
      EXPECT_LE(impacts, 1);
    } else {
      EXPECT_GT(apart, 1.0);
      EXPECT_GT(impacts, 3);
    }
  }
}

TEST(Ball, OnATiltedRacketItSlidesOrRollsAsAPlaneTeaches) {
  for (const double friction : {0.0, 0.1, 2.0}) {
    BallParameters parameters;
    parameters.court = false;
    parameters.friction = friction;
    parameters.racket_shape = RacketShape::rectangle;
    parameters.racket_width_mm = 1e5;
    const double tilt = 0.4;
    const RacketPose pose{.normal = {std::sin(tilt), 0.0, std::cos(tilt)},
                          .along = {std::cos(tilt), 0.0, -std::sin(tilt)}};
    BallGameState state;
    state.ball.position_mm = 33.0 * pose.normal;
    for (int i = 0; i < 500; ++i) static_cast<void>(stepBall(parameters, state, pose, 0.001));
    const double down = dot(state.ball.position_mm, pose.along);
    // sin − μ·cos while it slides; a hollow ball that rolls: sin / (1 + 2/3).
    const double share = std::max(std::sin(tilt) - friction * std::cos(tilt), std::sin(tilt) / (5.0 / 3.0));
    EXPECT_NEAR(down, 0.5 * 9810.0 * share * 0.25, 0.02) << friction;
    EXPECT_NEAR(dot(state.ball.position_mm, pose.normal), 33.0, 1e-9);
  }
}

TEST(Ball, TheWholeImpulseOfABlowIsFeltWhateverTheTimeStep) {
  for (const double dt_s : {0.0002, 0.001, 0.005}) {
    BallParameters parameters = still();
    parameters.most_force_N = 1000.0;
    BallGameState state;
    state.ball = {{0.0, 0.0, 50.0}, {0.0, 0.0, -10'000.0}, {}};
    Vec3 impulse;
    for (int i = 0; i < static_cast<int>(0.2 / dt_s); ++i) {
      impulse = impulse + dt_s * stepBall(parameters, state, RacketPose{}, dt_s).force_N;
    }
    EXPECT_NEAR(impulse.z, -0.058 * 1.75 * 10.0, 1e-9);
    EXPECT_NEAR(impulse.x, 0.0, 1e-15);
  }
}

TEST(Ball, ARacketPutElsewhereStrikesNothingOnItsWayAndPushesOutWhatItCovers) {
  BallParameters parameters = still();
  BallGameState state;
  state.ball = {{0.0, 0.0, 0.0}, {}, {}};
  static_cast<void>(stepBall(parameters, state, RacketPose{.centre_mm = {0.0, 0.0, -500.0}}, 0.001));
  static_cast<void>(stepBall(parameters, state, RacketPose{.centre_mm = {0.0, 0.0, 500.0}}, 0.001));
  EXPECT_EQ(state.ball.velocity_mm_per_s, Vec3{});
  EXPECT_EQ(state.ball.position_mm, Vec3{});
  static_cast<void>(stepBall(parameters, state, RacketPose{.centre_mm = {0.0, 0.0, 10.0}}, 0.001));
  EXPECT_NEAR(state.ball.position_mm.z, -23.0, 1e-6);
  EXPECT_NEAR(length(state.ball.velocity_mm_per_s), 0.0, 1e-6);
  parameters.racket_most_speed_m_per_s = 0.1;
  for (int i = 0; i < 10; ++i) {
    static_cast<void>(stepBall(parameters, state, RacketPose{.centre_mm = state.ball.position_mm}, 0.001));
  }
  EXPECT_TRUE(state.ball.position_mm.finite());
  EXPECT_LT(length(state.ball.velocity_mm_per_s), 1.0);
}

TEST(Ball, PressedOntoTheCourtByTheRacketItStaysFiniteAndSlow) {
  BallParameters parameters;
  BallGameState state;
  state.ball = {{0.0, 0.0, 33.0}, {}, {}};
  double fastest = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const double z = 66.0 + 60.0 - std::min(0.05 * i, 80.0);  // 14 mm too low in the end, at 50 mm/s
    const BallStep step = stepBall(parameters, state, RacketPose{.centre_mm = {0.0, 0.0, z}}, 0.001);
    ASSERT_TRUE(step.force_N.finite() && state.ball.position_mm.finite());
    ASSERT_LE(length(step.force_N), parameters.most_force_N + 1e-12);
    fastest = std::max(fastest, length(state.ball.velocity_mm_per_s));
  }
  EXPECT_LT(fastest, 2000.0);
  EXPECT_LT(length(state.ball.position_mm), 1000.0);
}

TEST(Ball, WhatIsNoNumberMovesNothing) {
  const BallParameters parameters;
  BallGameState state;
  state.ball = {{0.0, 0.0, 500.0}, {100.0, 0.0, 0.0}, {}};
  const BallState before = state.ball;
  for (const double x : {kNaN, std::numeric_limits<double>::infinity(), 1e300}) {
    const BallStep one = stepBall(parameters, state, RacketPose{.centre_mm = {0.0, x, 0.0}}, 0.001);
    EXPECT_NE(one.refusal, Refusal::none);
    EXPECT_EQ(one.force_N, Vec3{});
    EXPECT_NE(stepBall(parameters, state, RacketPose{.normal = {x, 0.0, 0.0}}, 0.001).refusal, Refusal::none);
  }
  EXPECT_NE(stepBall(parameters, state, RacketPose{.normal = {}}, 0.001).refusal, Refusal::none);
  EXPECT_NE(stepBall(parameters, state, RacketPose{.normal = {1.0, 0.0, 0.0}}, 0.001).refusal, Refusal::none);
  EXPECT_EQ(stepBall(parameters, state, RacketPose{}, kNaN).refusal, Refusal::no_time);
  EXPECT_EQ(stepBall(parameters, state, RacketPose{}, 0.0).refusal, Refusal::no_time);
  EXPECT_EQ(state.ball.position_mm, before.position_mm);
  EXPECT_FALSE(state.racket_known);
  state.ball.velocity_mm_per_s.y = kNaN;
  EXPECT_EQ(stepBall(parameters, state, RacketPose{}, 0.001).refusal, Refusal::not_a_number);
  EXPECT_EQ(state.ball.position_mm, before.position_mm);
  EXPECT_EQ(flyBall(parameters, before, kNaN).position_mm, before.position_mm);
  EXPECT_FALSE(meetPlane(parameters, before, {}, {}, 1.0).has_value());
  EXPECT_FALSE(meetPlane(parameters, before, {}, {0.0, kNaN, 0.0}, 1.0).has_value());
}

TEST(Ball, ParametersOutOfRangeAreNamed) {
  EXPECT_TRUE(checkParameters(BallParameters{}).has_value());
  BallParameters bad;
  bad.restitution = 1.2;
  const auto checked = checkParameters(bad);
  ASSERT_FALSE(checked.has_value());
  EXPECT_NE(checked.error().text().find("ball.restitution = 1.2: expected"), std::string::npos);
}

}  // namespace
}  // namespace fyd::scene
