// Two swords: hard cases. Motions and energies against reference solutions: tests/numerics/scene/swords_truth_test.cpp.
#include "core/scene/gesture/swords.h"

#include <cmath>
#include <limits>
#include <type_traits>

#include <gtest/gtest.h>

#include "tests/not_a_number.h"
#include "tests/sweep.h"

namespace fyd::scene {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Along x at this height; the other one along y, in the plane z = 0.
Blade alongX(double z, double y = 0.0) { return {{-450.0, y, z}, {450.0, y, z}}; }
Blade alongY() { return {{0.0, -450.0, 0.0}, {0.0, 450.0, 0.0}}; }

SwordParameters undamped() {
  SwordParameters out;
  out.damping_Ns_per_mm = 0.0;
  return out;
}

static_assert(std::is_trivially_copyable_v<SwordState>);

TEST(Swords, WhoCrossesIsPushedBackByStiffnessTimesDepth) {
  const SwordParameters parameters = undamped();
  for (const double side : {1.0, -1.0}) {
    SwordState state;
    EXPECT_EQ(stepSwords(parameters, state, alongX(side * 20.0), alongY(), 0.001).force_N, Vec3{});
    EXPECT_FALSE(stepSwords(parameters, state, alongX(side * 0.5), alongY(), 0.001).touching);
    const SwordTouch touch = stepSwords(parameters, state, alongX(side * -3.0), alongY(), 0.001);
    EXPECT_TRUE(touch.touching && touch.crossed && touch.began);
    EXPECT_DOUBLE_EQ(touch.force_N.z, side * 1.5);
    EXPECT_DOUBLE_EQ(touch.depth_mm, 3.0);
    EXPECT_NEAR(touch.began_ago_s, 0.001 * 3.0 / 3.5, 1e-12);
    EXPECT_EQ(touch.point_mm, (Vec3{0.0, 0.0, side * -3.0}));
    EXPECT_DOUBLE_EQ(touch.torque_Nmm.y, side * -450.0 * 1.5);  // r = 450 x, F = 1.5 z
    EXPECT_FALSE(stepSwords(parameters, state, alongX(side * 0.1), alongY(), 0.001).touching);
  }
}

TEST(Swords, ARadiusIsFeltBeforeTheLinesMeet) {
  SwordParameters parameters = undamped();
  parameters.radius_mm = 4.0;
  SwordState state;
  static_cast<void>(stepSwords(parameters, state, alongX(9.0), alongY(), 0.001));
  SwordTouch touch = stepSwords(parameters, state, alongX(7.0), alongY(), 0.001);
  EXPECT_TRUE(touch.began);
  EXPECT_NEAR(touch.began_ago_s, 0.0005, 1e-12);
  EXPECT_DOUBLE_EQ(touch.force_N.z, 0.5);
  touch = stepSwords(parameters, state, alongX(-1.0), alongY(), 0.001);  // beyond the lines
  EXPECT_TRUE(touch.crossed);
  EXPECT_FALSE(touch.began);
  EXPECT_DOUBLE_EQ(touch.force_N.z, 4.5);
  touch = stepSwords(parameters, state, alongX(-100.0), alongY(), 0.001);
  EXPECT_DOUBLE_EQ(touch.force_N.z, parameters.most_force_N);
}

TEST(Swords, AtTenMetresPerSecondAndAnyTimeStepNothingPopsThrough) {
  for (const double dt_s : {0.0002, 0.001, 0.005}) {
    for (const double begin : stepsBefore(0.01, 60.0, 3.7)) {
      SwordState state;
      double z = begin;
      SwordTouch touch;
      for (int i = 0; i < 400 && z > -200.0; ++i, z -= 10'000.0 * dt_s) {
        touch = stepSwords(undamped(), state, alongX(z), alongY(), dt_s);
        ASSERT_EQ(touch.touching, z < 0.0) << dt_s << " " << begin << " " << z;
        ASSERT_DOUBLE_EQ(touch.force_N.z, std::clamp(-0.5 * z, 0.0, 6.4));
        ASSERT_NEAR(touch.began_ago_s, touch.began ? -z / 10'000.0 : 0.0, 1e-9);
      }
      ASSERT_TRUE(touch.touching);
    }
  }
}

TEST(Swords, ThroughAndBackWithinAStepIsNoCrossing) {
  SwordState state;
  static_cast<void>(stepSwords(undamped(), state, alongX(5.0), alongY(), 0.001));
  EXPECT_FALSE(stepSwords(undamped(), state, alongX(5.0), alongY(), 0.001).touching);
  // Both ends pass below and come up again in a later step: crossed twice.
  EXPECT_TRUE(stepSwords(undamped(), state, alongX(-5.0), alongY(), 0.001).touching);
  EXPECT_FALSE(stepSwords(undamped(), state, alongX(5.0), alongY(), 0.001).touching);
}

TEST(Swords, BesideAnEndNothingIsTouched) {
  SwordState state;
  const auto beside = [](double z) { return Blade{{0.5, 0.0, z}, {900.0, 0.0, z}}; };
  static_cast<void>(stepSwords(undamped(), state, beside(5.0), alongY(), 0.001));
  const SwordTouch touch = stepSwords(undamped(), state, beside(-5.0), alongY(), 0.001);
  EXPECT_FALSE(touch.touching);
  EXPECT_EQ(touch.force_N, Vec3{});
}

TEST(Swords, SlidingOverTheTipLetsGoContinuouslyAndNeverAgain) {
  const SwordParameters parameters = undamped();
  SwordState state;
  const auto at = [](double tip, double z) { return Blade{{tip - 900.0, 0.0, z}, {tip, 0.0, z}}; };
  static_cast<void>(stepSwords(parameters, state, at(100.0, 1.0), alongY(), 0.001));
  double before = stepSwords(parameters, state, at(100.0, -4.0), alongY(), 0.001).force_N.z;
  EXPECT_DOUBLE_EQ(before, 2.0);
  for (const double tip : stepsBefore(100.0, -5.0, -0.25)) {
    const double force = stepSwords(parameters, state, at(tip, -4.0), alongY(), 0.001).force_N.z;
    ASSERT_LE(force, before + 1e-12);
    ASSERT_LE(before - force, 2.0 * 0.25 / 20.0 + 1e-12) << tip;
    ASSERT_NEAR(force, 2.0 * std::clamp(tip / 20.0, 0.0, 1.0), 1e-9);
    before = force;
  }
  EXPECT_FALSE(state.crossed);
  // On the other side now: it may go back there and presses from there.
  EXPECT_FALSE(stepSwords(parameters, state, at(100.0, -4.0), alongY(), 0.001).touching);
  EXPECT_DOUBLE_EQ(stepSwords(parameters, state, at(100.0, 4.0), alongY(), 0.001).force_N.z, -2.0);
}

TEST(Swords, WhatFadedAtTheTipDoesNotComeBackWithinAContact) {
  const SwordParameters parameters = undamped();
  SwordState state;
  const auto at = [](double tip, double z) { return Blade{{tip - 900.0, 0.0, z}, {tip, 0.0, z}}; };
  static_cast<void>(stepSwords(parameters, state, at(100.0, 1.0), alongY(), 0.001));
  static_cast<void>(stepSwords(parameters, state, at(100.0, -4.0), alongY(), 0.001));
  EXPECT_NEAR(stepSwords(parameters, state, at(10.0, -4.0), alongY(), 0.001).force_N.z, 1.0, 1e-12);
  EXPECT_NEAR(stepSwords(parameters, state, at(100.0, -4.0), alongY(), 0.001).force_N.z, 1.0, 1e-12);
  EXPECT_FALSE(stepSwords(parameters, state, at(100.0, 1.0), alongY(), 0.001).touching);
  EXPECT_DOUBLE_EQ(stepSwords(parameters, state, at(100.0, -4.0), alongY(), 0.001).force_N.z, 2.0);
}

TEST(Swords, ParallelBladesStopEachOther) {
  for (const double radius : {0.0, 3.0}) {
    for (const double shift : {0.0, 300.0, -850.0}) {
      SwordParameters parameters = undamped();
      parameters.radius_mm = radius;
      SwordState state;
      const Blade fixed{{-450.0 + shift, 0.0, 0.0}, {450.0 + shift, 0.0, 0.0}};
      for (const double y : stepsBefore(20.0, -5.0, -0.5)) {  // at 0 they lie on each other
        const SwordTouch touch = stepSwords(parameters, state, alongX(0.0, y), fixed, 0.001);
        ASSERT_NEAR(touch.force_N.y, 0.5 * std::max(0.0, 2.0 * radius - y), 1e-12) << radius << " " << y;
        ASSERT_EQ(touch.force_N.x, 0.0);
        ASSERT_EQ(touch.force_N.z, 0.0);
        ASSERT_NEAR(touch.point_mm.x, 0.5 * shift, 1e-9);  // amid what they have beside each other
      }
      ASSERT_NEAR(stepSwords(parameters, state, alongX(0.0, 0.5), fixed, 0.001).force_N.y,
                  0.5 * std::max(0.0, 2.0 * radius - 0.5), 1e-12);
    }
  }
}

TEST(Swords, AParallelBladeThatPassesBeyondTheEndOfTheOtherIsFree) {
  SwordState state;
  const Blade fixed{{1000.0, 0.0, 0.0}, {1900.0, 0.0, 0.0}};
  for (const double y : stepsBefore(5.0, -5.0, -0.7)) {
    ASSERT_FALSE(stepSwords(undamped(), state, alongX(0.0, y), fixed, 0.001).touching);
  }
}

TEST(Swords, TurningPastParallelIsNoCrossing) {
  for (const double side : {1.0, -1.0}) {
    SwordState state;
    bool crossed = false;
    for (int i = -100; i <= 100; ++i) {  // about the shortest line, 5 mm above the other, through parallel
      const double turned = 0.013 * i;
      const Vec3 by{450.0 * std::cos(turned), 450.0 * std::sin(turned), 0.0};
      const Vec3 middle{0.0, 0.0, side * (i < 50 ? 5.0 : -2.0)};
      const SwordTouch touch = stepSwords(undamped(), state, {middle - by, middle + by}, alongX(0.0), 0.001);
      ASSERT_EQ(touch.touching, i >= 50) << i;
      crossed = touch.crossed;
      ASSERT_NEAR(touch.force_N.z, i >= 50 ? side * 1.0 : 0.0, 1e-12);
    }
    ASSERT_TRUE(crossed);
    for (int i = 100; i >= -100; --i) {  // and back, crossed all the time
      const double turned = 0.013 * i;
      const Vec3 by{450.0 * std::cos(turned), 450.0 * std::sin(turned), 0.0};
      const Vec3 middle{0.0, 0.0, side * -2.0};
      const SwordTouch touch = stepSwords(undamped(), state, {middle - by, middle + by}, alongX(0.0), 0.001);
      ASSERT_NEAR(touch.force_N.z, side * 1.0, 1e-9) << i;
    }
  }
}

TEST(Swords, CoincidentAndOverlappingFromTheBeginningAreWithoutForceUntilPressedDeeper) {
  SwordParameters parameters = undamped();
  for (const double radius : {0.0, 4.0}) {
    parameters.radius_mm = radius;
    SwordState state;
    for (int i = 0; i < 10; ++i) {
      const SwordTouch touch = stepSwords(parameters, state, alongX(0.0), alongX(0.0), 0.001);
      ASSERT_EQ(touch.force_N, Vec3{});
      ASSERT_TRUE(touch.point_mm.finite() && touch.normal.finite());
    }
    // Apart, and back: now they touch as any others.
    static_cast<void>(stepSwords(parameters, state, alongX(30.0), alongX(0.0), 0.001));
    const SwordTouch touch = stepSwords(parameters, state, alongX(2.0 * radius - 1.0), alongX(0.0), 0.001);
    ASSERT_NEAR(touch.force_N.z, 0.5, 1e-12) << radius;
  }
  SwordState state;
  static_cast<void>(stepSwords(parameters, state, alongX(3.0), alongY(), 0.001));  // 5 mm within
  EXPECT_EQ(stepSwords(parameters, state, alongX(3.0), alongY(), 0.001).force_N, Vec3{});
  EXPECT_DOUBLE_EQ(stepSwords(parameters, state, alongX(2.0), alongY(), 0.001).force_N.z, 0.5);
}

TEST(Swords, BladesWithoutLengthAreTouchedByTheirRadiusAlone) {
  SwordParameters parameters = undamped();
  for (const double radius : {0.0, 4.0}) {
    parameters.radius_mm = radius;
    for (const bool both : {false, true}) {
      SwordState state;
      const Blade other = both ? Blade{} : alongY();
      for (const double z : stepsBefore(20.0, 1.0, -0.5)) {
        const Blade point{{0.0, 0.0, z}, {0.0, 0.0, z}};
        const SwordTouch touch = stepSwords(parameters, state, point, other, 0.001);
        ASSERT_NEAR(touch.force_N.z, 0.5 * std::max(0.0, 2.0 * radius - z), 1e-12);
      }
    }
  }
}

TEST(Swords, TheOtherPlayerFeelsTheOpposite) {
  SwordParameters parameters;
  parameters.radius_mm = 2.0;
  parameters.friction = 0.3;
  SwordState here, there;
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.001 * i;
    const Blade a{{-400.0, 30.0 * std::sin(3.0 * t), 5.0 * std::sin(11.0 * t)},
                  {400.0 + 20.0 * std::sin(t), 10.0, 6.0 * std::cos(7.0 * t)}};
    const Blade b{{20.0 * std::sin(5.0 * t), -300.0, 2.0}, {15.0, 500.0, 4.0 * std::sin(2.0 * t)}};
    const SwordTouch one = stepSwords(parameters, here, a, b, 0.001),
                     other = stepSwords(parameters, there, b, a, 0.001);
    ASSERT_NEAR(length(one.force_N + other.force_N), 0.0, 1e-9) << t;
    ASSERT_EQ(one.touching, other.touching);
  }
}

TEST(Swords, WhatIsNoNumberMovesNothing) {
  SwordState state;
  static_cast<void>(stepSwords(undamped(), state, alongX(5.0), alongY(), 0.001));
  Blade bad = alongX(-5.0);
  for (const double x : {kNaN, kInfinity, -kInfinity, 1e300}) {
    bad.tip_mm.y = x;
    const SwordTouch one = stepSwords(undamped(), state, bad, alongY(), 0.001);
    EXPECT_EQ(one.refusal, std::isfinite(x) ? Refusal::too_far : Refusal::not_a_number);
    EXPECT_FALSE(toString(one.refusal).empty());
    EXPECT_EQ(one.force_N, Vec3{});
    EXPECT_NE(stepSwords(undamped(), state, alongX(5.0), bad, 0.001).refusal, Refusal::none);
  }
  for (const double dt_s : {kNaN, 0.0, -0.001, kInfinity, 1.1}) {
    EXPECT_EQ(stepSwords(undamped(), state, alongX(-5.0), alongY(), dt_s).refusal, Refusal::no_time);
  }
  EXPECT_DOUBLE_EQ(stepSwords(undamped(), state, alongX(-5.0), alongY(), 0.001).force_N.z, 2.5);  // it crossed since
}

TEST(Swords, ParametersOutOfRangeAreNamed) {
  EXPECT_TRUE(checkParameters(SwordParameters{}).has_value());
  SwordParameters bad;
  bad.stiffness_N_per_mm = -1.0;
  auto checked = checkParameters(bad);
  ASSERT_FALSE(checked.has_value());
  EXPECT_NE(checked.error().text().find("swords.stiffness_N_per_mm = -1: expected"), std::string::npos)
      << checked.error().text();
  bad = {};
  bad.radius_mm = kNaN;
  EXPECT_FALSE(checkParameters(bad).has_value());
}

}  // namespace
}  // namespace fyd::scene
