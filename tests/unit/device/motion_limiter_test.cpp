// The limits hold whatever is asked for; expected figures are worked out by hand.
#include "core/device/motion_limiter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <utility>

#include "core/device/following_robot.h"

namespace fyd::device {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

// Calls every millisecond and checks the limits between any two of them.
struct Watch {
  MotionLimits limits;
  MotionLimiter limiter{limits};
  double seconds = 0.0;
  Vec3 velocity;

  explicit Watch(const MotionLimits& wanted = {}) : limits(wanted), limiter(wanted) {
    limiter.apply({}, instantAt(0.0));
  }
  Vec3 apply(const Vec3& target) {
    const Vec3 before = limiter.position_mm();
    seconds += 0.001;
    const Vec3 after = limiter.apply(target, instantAt(seconds));
    const Vec3 v = 1000.0 * (after - before);
    EXPECT_TRUE(after.finite());
    EXPECT_LE(v.norm(), limits.speed_mm_s * (1 + 1e-9));
    EXPECT_LE((1000.0 * (v - velocity)).norm(), limits.acceleration_mm_s2 * (1 + 1e-6));
    EXPECT_LE(std::abs(after.x), limits.workspace_mm.x + 1e-9);
    EXPECT_LE(std::abs(after.y), limits.workspace_mm.y + 1e-9);
    EXPECT_LE(std::abs(after.z), limits.workspace_mm.z + 1e-9);
    velocity = v;
    return after;
  }
};

TEST(MotionLimiter, ArrivesExactlyWithoutOvershoot) {
  for (const double goal : {0.001, 0.5, 3.0, 20.0, -34.9}) {
    Watch watch;
    double furthest = 0.0;
    for (int i = 0; i < 1000; ++i) furthest = std::max(furthest, std::abs(watch.apply({goal, 0, 0}).x));
    EXPECT_NEAR(watch.limiter.position_mm().x, goal, 1e-9);
    EXPECT_NEAR(watch.limiter.velocity_mm_s().x, 0.0, 1e-6);
    EXPECT_LE(furthest, std::abs(goal) + 1e-9);
  }
}

// Share of an axis: v = 173.205/√3 = 100 mm/s, a = 1732.05/√3 = 1000 mm/s². Over 60 mm: 0.1 s up to speed (5 mm),
// 50 mm at speed (0.5 s), 0.1 s down (5 mm): 0.7 s.
TEST(MotionLimiter, TakesTheTimeOfTheTrapezoid) {
  Watch watch({.speed_mm_s = 100.0 * std::sqrt(3.0), .acceleration_mm_s2 = 1000.0 * std::sqrt(3.0)});
  double arrived_s = 0.0;
  for (int i = 0; i < 2000 && arrived_s == 0.0; ++i) {
    if (std::abs(watch.apply({0, 0, -60}).z + 60.0) < 1e-6) arrived_s = watch.seconds;
    if (i == 349) {
      EXPECT_NEAR(watch.limiter.position_mm().z, -30.0, 0.2);  // half-way in half the time
    }
  }
  EXPECT_NEAR(arrived_s, 0.7, 0.004);
}

TEST(MotionLimiter, AHundredThousandWildTargetsNeverBreakALimit) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-200.0, 200.0);
  Watch watch;
  Vec3 target;
  for (int i = 0; i < 100'000; ++i) {
    if (random() % 50 == 0) target = {place(random), place(random), place(random)};
    const Vec3 asked = random() % 97 == 0 ? Vec3{kNaN, kInf, -kInf} : target;
    watch.apply(asked);
  }
  EXPECT_GT(watch.limiter.refused(), 500U);
}

TEST(MotionLimiter, WhatIsNoNumberIsRefusedAndTheLastGoalStands) {
  Watch watch;
  for (int i = 0; i < 500; ++i) watch.apply({5, 0, 0});
  for (const Vec3 bad : {Vec3{kNaN, 0, 0}, Vec3{0, kInf, 0}, Vec3{0, 0, -kInf}}) {
    EXPECT_NEAR(watch.apply(bad).x, 5.0, 1e-9);
  }
  EXPECT_EQ(watch.limiter.refused(), 3U);
  watch.limiter.reset({kNaN, 0, 0});
  EXPECT_NEAR(watch.limiter.position_mm().x, 5.0, 1e-9);
  EXPECT_EQ(watch.apply({1e300, -1e300, 1e300}).finite(), true);
}

TEST(MotionLimiter, AfterAPauseAtMostTwentyMillisecondsAreCaughtUp) {
  MotionLimiter limiter({.speed_mm_s = 100.0 * std::sqrt(3.0), .acceleration_mm_s2 = 1e5});
  limiter.apply({}, instantAt(0.0));
  for (int i = 1; i <= 10; ++i) limiter.apply({30, 0, 0}, instantAt(0.001 * i));  // at full speed
  const double before = limiter.position_mm().x;
  limiter.apply({30, 0, 0}, instantAt(10.0));
  EXPECT_NEAR(limiter.position_mm().x - before, 2.0, 1e-9);  // 100 mm/s · 20 ms
}

TEST(MotionLimiter, TimeThatStandsStillOrGoesBackMovesNothing) {
  MotionLimiter limiter;
  for (int i = 0; i < 1000; ++i) limiter.apply({30, 10, -50}, instantAt(5.0 - 0.001 * i));
  EXPECT_EQ(limiter.position_mm(), Vec3{});
}

TEST(MotionLimiter, StartsFromWhereTheArmStandsEvenOutsideTheWorkspace) {
  MotionLimiter limiter;
  limiter.reset({100, 0, 0});
  limiter.apply({0, 0, 0}, instantAt(0.0));
  EXPECT_EQ(limiter.position_mm().x, 100.0);
  for (int i = 1; i < 3000; ++i) limiter.apply({0, 0, 0}, instantAt(0.001 * i));
  EXPECT_NEAR(limiter.position_mm().x, 0.0, 1e-9);
}

TEST(MotionLimiter, WrongLimitsAreRefusedWithTheirValue) {
  const auto message = [](const MotionLimits& limits) {
    const auto good = checkLimits(limits);
    return good ? std::string("fine") : good.error().message;
  };
  EXPECT_EQ(message({}), "fine");
  EXPECT_THAT(message({.workspace_mm = {35, 0, 70}}), ::testing::HasSubstr("workspace ±(35, 0, 70) mm"));
  EXPECT_THAT(message({.speed_mm_s = kNaN}), ::testing::HasSubstr("speed limit nan"));
  EXPECT_THAT(message({.acceleration_mm_s2 = 1e9}), ::testing::HasSubstr("expected 10 to 100000"));
}

// An arm that stands where it is told, unless told not to follow; the first exchange that succeeds again holds it.
class Obedient final : public Robot {
 public:
  [[nodiscard]] std::string description() const override { return "obedient"; }
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

TEST(FollowingRobot, TargetsThatPiledUpWhileItDidNotFollowMakeNoLeap) {
  auto owned = std::make_unique<Obedient>();
  Obedient& arm = *owned;
  FollowingRobot robot(std::move(owned), {});
  double t_s = 0.0;
  const auto run = [&](int cycles, const Vec3& target) {
    for (int i = 0; i < cycles; ++i) static_cast<void>(robot.exchange(target, instantAt(t_s += 0.001)));
  };
  run(500, {10, 0, 0});
  EXPECT_NEAR(arm.place_mm.x, 10.0, 1e-6);
  arm.follows = false;
  run(500, {-30, 20, -50});
  EXPECT_FALSE(robot.following());
  arm.follows = true;
  arm.largest_step_mm = 0.0;
  run(1, {-30, 20, -50});
  EXPECT_TRUE(robot.resumed());
  run(1000, {-30, 20, -50});
  EXPECT_NEAR(arm.place_mm.y, 20.0, 1e-6);
  EXPECT_LE(arm.largest_step_mm, 0.25 + 1e-6);  // 250 mm/s · 1 ms
}

}  // namespace
}  // namespace fyd::device
