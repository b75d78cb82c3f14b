// The limits hold whatever is asked for; expected figures are worked out by hand.
#include "core/device/robot/motion_limiter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <utility>

#include "core/device/robot/following_robot.h"
#include "tests/not_a_number.h"

namespace fyd::device {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

// Takes a position every tick and checks the limits between any two, three and four of them: differences of what was
// commanded, which know nothing of how it was made.
struct Watch {
  MotionLimits limits;
  double tick_s;
  MotionLimiter limiter{limits};
  Vec3 velocity;
  Vec3 acceleration;

  explicit Watch(const MotionLimits& wanted = {}, double tick = 0.001)
      : limits(wanted), tick_s(tick), limiter(wanted) {}
  Vec3 apply(const Vec3& target, const Vec3& moving = {}) {
    const Vec3 before = limiter.position_mm();
    return judge(before, Vec3(limiter.advance(target, tick_s, moving)));
  }
  Vec3 brake() {
    const Vec3 before = limiter.position_mm();
    return judge(before, Vec3(limiter.brake(tick_s)));
  }
  Vec3 judge(const Vec3& before, const Vec3& after) {
    const Vec3 v = (1.0 / tick_s) * (after - before);
    const Vec3 a = (1.0 / tick_s) * (v - velocity);
    const Vec3 j = (1.0 / tick_s) * (a - acceleration);
    // Rounding of a position of some ten mm: 1e-14 mm, four of them in the third difference.
    const double rounding = 1e-13 / (tick_s * tick_s * tick_s);
    EXPECT_TRUE(after.finite());
    EXPECT_LE(v.norm(), limits.speed_mm_s * (1 + 1e-9));
    EXPECT_LE(a.norm(), limits.acceleration_mm_s2 * (1 + 1e-9) + rounding * tick_s);
    EXPECT_LE(j.norm(), limits.jerk_mm_s3 * (1 + 1e-9) + rounding);
    EXPECT_LE(std::abs(after.x), limits.workspace_mm.x + 1e-9);
    EXPECT_LE(std::abs(after.y), limits.workspace_mm.y + 1e-9);
    EXPECT_LE(std::abs(after.z), limits.workspace_mm.z + 1e-9);
    velocity = v;
    acceleration = a;
    return after;
  }
};

TEST(MotionLimiter, ArrivesExactlyWithoutOvershootAtAnyTick) {
  for (const double tick_s : {0.0001, 0.001, 0.002, 0.0037, 0.005, 0.01, 0.1, 1.0}) {
    for (const double goal : {0.001, 0.5, 3.0, 20.0, -34.9}) {
      Watch watch({}, tick_s);
      double furthest = 0.0;
      const auto ticks = std::lround(std::ceil(1.5 / tick_s));
      for (long i = 0; i < ticks; ++i) furthest = std::max(furthest, std::abs(watch.apply({goal, 0, 0}).x));
      EXPECT_NEAR(watch.limiter.position_mm().x, goal, 1e-9) << tick_s;
      EXPECT_TRUE(watch.limiter.atRest()) << tick_s;
      EXPECT_LE(furthest, std::abs(goal) + 1e-9);
      const Vec3 there = watch.limiter.position_mm();
      for (int i = 0; i < 10; ++i) EXPECT_NEAR((watch.apply({goal, 0, 0}) - there).norm(), 0.0, 1e-12);
    }
  }
}

// Share of an axis: v = 173.205/√3 = 100 mm/s, a = 1732.05/√3 = 1000 mm/s², j = 17320.5/√3 = 10 000 mm/s³. A change of
// speed by 100 mm/s takes 100/1000 + 1000/10 000 = 0.2 s and 10 mm; over 60 mm: 0.2 s up, 40 mm at speed (0.4 s), 0.2 s
// down: 0.8 s. Half-way after 0.4 s.
TEST(MotionLimiter, TakesTheTimeOfTheSevenPhasesAtAnyTick) {
  const double root = std::sqrt(3.0);
  for (const double tick_s : {0.001, 0.002, 0.005, 0.01, 0.1}) {
    Watch watch({.speed_mm_s = 100.0 * root, .acceleration_mm_s2 = 1000.0 * root, .jerk_mm_s3 = 10'000.0 * root},
                tick_s);
    const auto ticks = static_cast<int>(std::lround(0.8 / tick_s));
    for (int i = 1; i <= ticks; ++i) {
      const double z = watch.apply({0, 0, -60}).z;
      if (2 * i == ticks) {
        EXPECT_NEAR(z, -30.0, 1e-6) << tick_s;
      }
      if (i == ticks - 1) {
        EXPECT_GT(z, -60.0) << tick_s;
      }
    }
    EXPECT_NEAR(watch.limiter.position_mm().z, -60.0, 1e-6) << tick_s;
  }
}

TEST(MotionLimiter, AHundredThousandWildTargetsNeverBreakALimitAtAnyTick) {
  for (const double tick_s : {0.0001, 0.001, 0.002, 0.005, 0.01, 0.1}) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-200.0, 200.0);
    Watch watch({}, tick_s);
    Vec3 target;
    for (int i = 0; i < 20'000; ++i) {
      if (random() % 50 == 0) target = {place(random), place(random), place(random)};
      if (random() % 200 < 10) {
        watch.brake();
      } else {
        watch.apply(random() % 97 == 0 ? Vec3{kNaN, kInf, -kInf} : target);
      }
    }
  }
}

// A sine of 12 mm at 1 Hz: at most 75 mm/s and 474 mm/s². A target that stands at each tick is reached at rest, and so
// followed late; one whose speed is known is not.
TEST(MotionLimiter, ATargetThatMovesIsFollowedWithoutLag) {
  const auto worst = [](bool told) {
    Watch watch;
    double apart = 0.0;
    for (int i = 0; i < 3000; ++i) {
      const double w = 2.0 * std::numbers::pi;
      const double angle = w * i * 1e-3;
      const Vec3 target{12.0 * std::sin(angle), 0.0, -12.0 * std::cos(angle)};
      const Vec3 speed{12.0 * w * std::cos(angle), 0.0, 12.0 * w * std::sin(angle)};
      const Vec3 there = watch.apply(target, told ? speed : Vec3{});
      if (i > 1000) apart = std::max(apart, (there - target).norm());
    }
    return apart;
  };
  EXPECT_GT(worst(false), 1.0);
  EXPECT_LT(worst(true), 0.02);
}

TEST(MotionLimiter, WildTargetsThatMoveWildlyNeverBreakALimit) {
  for (const double tick_s : {0.0001, 0.001, 0.005, 0.1}) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-80.0, 80.0);
    std::uniform_real_distribution<double> speed(-600.0, 600.0);
    Watch watch({}, tick_s);
    Vec3 target;
    Vec3 moving;
    for (int i = 0; i < 20'000; ++i) {
      if (random() % 50 == 0) target = {place(random), place(random), place(random)};
      if (random() % 30 == 0) moving = {speed(random), speed(random), speed(random)};
      if (random() % 200 < 10) {
        watch.brake();
      } else {
        watch.apply(target, random() % 97 == 0 ? Vec3{kNaN, kInf, 0.0} : moving);
        target = target + tick_s * moving;
        if (target.norm() > 150.0) target = {};
      }
    }
  }
}

TEST(MotionLimiter, LimitsOfAnyRatioAreKept) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const auto between = [&](double low, double high) { return low * std::pow(high / low, share(random)); };
  for (int trial = 0; trial < 300; ++trial) {
    const MotionLimits limits{
        .speed_mm_s = between(1, 1000), .acceleration_mm_s2 = between(10, 1e5), .jerk_mm_s3 = between(1e3, 1e7)};
    ASSERT_TRUE(checkLimits(limits));
    Watch watch(limits, between(0.001, 0.1));
    Vec3 target;
    for (int i = 0; i < 300; ++i) {
      if (random() % 20 == 0) target = {70 * share(random) - 35, 50 * share(random) - 25, 140 * share(random) - 70};
      watch.apply(target);
    }
  }
}

TEST(MotionLimiter, ChangingTicksKeepTheSpeedAndArrive) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> tick(0.0005, 0.02);
  MotionLimiter limiter;
  for (int i = 0; i < 2000; ++i) {
    const double tick_s = tick(random);
    const Vec3 before = limiter.position_mm();
    const Vec3 after = limiter.advance({i % 500 < 250 ? 30.0 : -30.0, 20, -60}, tick_s);
    EXPECT_LE((after - before).norm(), 250.0 * tick_s * (1 + 1e-9));
  }
  for (int i = 0; i < 500; ++i) limiter.advance({5, 5, -5}, tick(random));
  EXPECT_NEAR((limiter.position_mm() - Vec3{5, 5, -5}).norm(), 0.0, 1e-9);
}

// From 100 mm/s with 1000 mm/s² and 10 000 mm/s³: 0.2 s and 10 mm, by hand as above.
TEST(MotionLimiter, BrakesAsFastAsTheLimitsAllowAndStays) {
  const double root = std::sqrt(3.0);
  Watch watch({.speed_mm_s = 100.0 * root, .acceleration_mm_s2 = 1000.0 * root, .jerk_mm_s3 = 10'000.0 * root}, 0.01);
  for (int i = 0; i < 40; ++i) watch.apply({0, 0, -70});
  const double begun = watch.limiter.position_mm().z;
  for (int i = 0; i < 19; ++i) watch.brake();
  EXPECT_FALSE(watch.limiter.atRest());
  for (int i = 0; i < 2; ++i) watch.brake();
  EXPECT_TRUE(watch.limiter.atRest());
  EXPECT_NEAR(watch.limiter.position_mm().z, begun - 10.0, 1e-9);
  const Vec3 rest = watch.limiter.position_mm();
  for (int i = 0; i < 100; ++i) EXPECT_EQ(watch.brake(), rest);
  // A target that is no number leaves the goal where it braked to.
  for (int i = 0; i < 100; ++i) EXPECT_NEAR((watch.apply({kNaN, 0, 0}) - rest).norm(), 0.0, 1e-9);
}

TEST(MotionLimiter, WhatIsNoNumberIsRefusedAndTheLastGoalStands) {
  Watch watch;
  for (int i = 0; i < 1000; ++i) watch.apply({5, 0, 0});
  for (const Vec3 bad : {Vec3{kNaN, 0, 0}, Vec3{0, kInf, 0}, Vec3{0, 0, -kInf}}) {
    EXPECT_NEAR(watch.apply(bad).x, 5.0, 1e-9);
  }
  EXPECT_EQ(watch.limiter.refused(), 3U);
  watch.limiter.reset({kNaN, 0, 0});
  EXPECT_NEAR(watch.limiter.position_mm().x, 5.0, 1e-9);
  EXPECT_EQ(watch.apply({1e300, -1e300, 1e300}).finite(), true);
}

TEST(MotionLimiter, ATickThatIsNoneMovesNothingAndALongOneCountsAsASecond) {
  MotionLimiter limiter;
  for (const double tick_s : {0.0, -1.0, kNaN, -kInf}) EXPECT_EQ(limiter.advance({30, 10, -50}, tick_s), Vec3{});
  MotionLimiter second;
  const Vec3 after_one = second.advance({0, 0, -60}, 1.0);
  EXPECT_EQ(limiter.advance({0, 0, -60}, kInf), after_one);
}

TEST(MotionLimiter, StartsFromWhereTheArmStandsEvenOutsideTheWorkspace) {
  MotionLimiter limiter;
  limiter.reset({100, 0, 0});
  EXPECT_EQ(limiter.position_mm().x, 100.0);
  for (int i = 1; i < 3000; ++i) limiter.advance({0, 0, 0}, 0.001);
  EXPECT_NEAR(limiter.position_mm().x, 0.0, 1e-9);
}

// A tool that was moved by hand: 175 mm to one side, 100 mm deeper than the start.
TEST(MotionLimiter, AnArmThatStandsOutsideTheWorkspaceStaysUntilItsTargetLeadsItAndGoesNoFurtherOut) {
  const Vec3 found{175, 0, -100};
  MotionLimiter limiter;
  limiter.reset(found);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(limiter.advance(found, 0.001), found);
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(limiter.advance({400, 0, -300}, 0.001, {100, 0, -100}), found);
  for (int i = 0; i < 2000; ++i) limiter.advance({100, 0, -90}, 0.001);
  EXPECT_NEAR((limiter.position_mm() - Vec3{100, 0, -90}).norm(), 0.0, 1e-9);
  for (int i = 0; i < 2000; ++i) limiter.advance({400, 0, -300}, 0.001);
  EXPECT_NEAR((limiter.position_mm() - found).norm(), 0.0, 1e-9) << "as far as where it stood";
}

TEST(MotionLimiter, AnArmThatCameIntoTheWorkspaceStaysInIt) {
  MotionLimiter limiter;
  limiter.reset({-80, 0, 0});
  double fastest_mm_s = 0.0;
  const auto go = [&](double x, int ticks) {
    for (int i = 0; i < ticks; ++i) {
      const double before = limiter.position_mm().x;
      fastest_mm_s = std::max(fastest_mm_s, std::abs(limiter.advance({x, 0, 0}, 0.001).x - before) / 0.001);
    }
  };
  go(0, 2000);
  EXPECT_NEAR(limiter.position_mm().x, 0.0, 1e-9);
  go(-80, 2000);
  EXPECT_NEAR(limiter.position_mm().x, -35.0, 1e-9);
  EXPECT_LE(fastest_mm_s, 250.0 / std::sqrt(3.0) * (1 + 1e-9));
  // Turned outwards while its braking brings it inside: the goal beyond the edge goes with the room there.
  limiter.reset({-40, 0, 0});
  go(30, 60);
  go(-40, 1);
  EXPECT_LT(limiter.position_mm().x, -35.0);
  go(kNaN, 1000);
  EXPECT_NEAR(limiter.position_mm().x, -35.0, 1e-9);
}

TEST(MotionLimiter, WrongLimitsAreRefusedWithTheirValue) {
  const auto message = [](const MotionLimits& limits) {
    const auto good = checkLimits(limits);
    return good ? std::string("fine") : good.error().text();
  };
  EXPECT_EQ(message({}), "fine");
  EXPECT_THAT(message({.workspace_mm = {35, 0, 70}}), ::testing::HasSubstr("workspace ±(35, 0, 70) mm"));
  EXPECT_THAT(message({.speed_mm_s = kNaN}), ::testing::HasSubstr("speed limit nan"));
  EXPECT_THAT(message({.acceleration_mm_s2 = 1e9}), ::testing::HasSubstr("expected 10 to 100000"));
  EXPECT_THAT(message({.jerk_mm_s3 = 10.0}), ::testing::HasSubstr("jerk limit 10 mm/s³: expected 1000 to 10000000"));
}

// An arm that stands where it is told, unless told not to follow; the first exchange that succeeds again holds it.
class Obedient final : public Robot {
 public:
  [[nodiscard]] Message description() const override { return verbatim("obedient"); }
  [[nodiscard]] Result<RobotReadings> exchange(const Vec3& target_mm, Instant now) override {
    const bool followed = std::exchange(followed_, follows);
    if (!follows) return fail("in another mode");
    if (!followed) return RobotReadings{.position_mm = place_mm, .taken = now};
    largest_step_mm = std::max(largest_step_mm, (target_mm - place_mm).norm());
    place_mm = target_mm;
    return RobotReadings{.position_mm = place_mm, .taken = now};
  }
  bool follows = true;
  Vec3 place_mm;
  double largest_step_mm = 0.0;

 private:
  bool followed_ = false;
};

struct Followed {
  Obedient* arm = nullptr;
  std::optional<FollowingRobot> robot;
  double t_s = 0.0;

  Followed() {
    auto owned = std::make_unique<Obedient>();
    arm = owned.get();
    robot.emplace(std::move(owned), MotionLimits{});
  }
  // `late_s`: how much longer than the tick the machine took.
  void run(int cycles, const Vec3& target, double late_s = 0.0) {
    for (int i = 0; i < cycles; ++i) {
      static_cast<void>(robot->exchange(target, 0.001, instantAt(t_s += 0.001 + late_s)));
    }
  }
};

TEST(FollowingRobot, TargetsThatPiledUpWhileItDidNotFollowMakeNoLeap) {
  Followed to;
  to.run(500, {10, 0, 0});
  EXPECT_NEAR(to.arm->place_mm.x, 10.0, 1e-6);
  to.arm->follows = false;
  to.run(500, {-30, 20, -50});
  EXPECT_FALSE(to.robot->following());
  to.arm->follows = true;
  to.arm->largest_step_mm = 0.0;
  to.run(1, {-30, 20, -50});
  EXPECT_TRUE(to.robot->resumed());
  to.run(1000, {-30, 20, -50});
  EXPECT_NEAR(to.arm->place_mm.y, 20.0, 1e-6);
  EXPECT_LE(to.arm->largest_step_mm, 0.25 + 1e-6);  // 250 mm/s · 1 ms
}

TEST(FollowingRobot, AMachineThatStoodStillCatchesUpNothing) {
  Followed to;
  to.run(100, {30, 0, 0});
  to.arm->largest_step_mm = 0.0;
  to.run(1, {30, 0, 0}, 0.5);
  to.run(100, {30, 0, 0}, 0.0005);
  EXPECT_LE(to.arm->largest_step_mm, 0.25 / std::sqrt(3.0) + 1e-9);  // an axis' share of 250 mm/s, in 1 ms
}

TEST(FollowingRobot, ComesToRestAndCountsTargetsThatAreNoNumbers) {
  Followed to;
  to.run(100, {30, 0, 0});
  EXPECT_FALSE(to.robot->atRest());
  to.run(3, {kNaN, 0, 0});
  EXPECT_EQ(to.robot->refused(), 3U);
  to.robot->comeToRest();
  to.run(100, {30, 0, 0});
  EXPECT_TRUE(to.robot->atRest());
  EXPECT_LT(to.arm->place_mm.x, 25.0);
  EXPECT_EQ(to.robot->commanded_mm(), to.arm->place_mm);
}

}  // namespace
}  // namespace fyd::device
