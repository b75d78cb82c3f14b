// The motion limits, judged at the robot controller: in its own ticks, with jitter, loss and late messages.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/device/played_krc.h"

namespace fyd::device {
namespace {

using protocol::FriQuality;
using ::testing::HasSubstr;

constexpr std::array<double, 4> kTicks_s = {0.001, 0.002, 0.005, 0.01};
// The figures of which 1 ms ticks made 400 mm/s and 400 000 mm/s².
const MotionLimits kSlow{.speed_mm_s = 200.0, .acceleration_mm_s2 = 1000.0, .jerk_mm_s3 = 20'000.0};

Vec3 strokes(double time_s) { return {30.0 * std::sin(9.0 * time_s), 20.0 * std::cos(4.0 * time_s), -30.0}; }

TEST(FriLimits, AreKeptInTheControllersTicks) {
  for (const MotionLimits& limits : {kSlow, MotionLimits{}}) {
    for (const double tick_s : kTicks_s) {
      SCOPED_TRACE(fmt::format("tick {} s, speed {} mm/s", tick_s, limits.speed_mm_s));
      FakeKrc krc({.tick_s = tick_s, .limits = limits});
      krc.run(8.0, WildTargets(5));
      EXPECT_EQ(krc.violation(), "");
      EXPECT_EQ(krc.judgement.held, 0U);
      EXPECT_EQ(krc.fri->counters().not_taken, 0U);
      EXPECT_GT(krc.judgement.travelled_mm, 300.0);
      EXPECT_GT(krc.judgement.speed_mm_s, 0.8 * limits.speed_mm_s) << "they are used, too";
    }
  }
}

TEST(FriLimits, AreKeptThroughJitterLossLateMessagesAndPauses) {
  for (const double tick_s : kTicks_s) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      SCOPED_TRACE(fmt::format("tick {} s, seed {}", tick_s, seed));
      FakeKrc krc({.tick_s = tick_s,
                   .delay_s = 0.1 * tick_s,
                   .jitter_s = 0.3 * tick_s,
                   .loss = 0.01,
                   .late = 0.01,
                   .pause = 0.001,
                   .seed = seed});
      krc.run(1500 * tick_s + 4.0, WildTargets(seed));
      EXPECT_EQ(krc.violation(), "");
      EXPECT_GT(krc.judgement.held, 5U);
      EXPECT_GT(krc.judgement.travelled_mm, 50.0);
    }
  }
}

TEST(FriLimits, AreKeptThroughNonsenseWhichIsNeverAnswered) {
  for (const double tick_s : kTicks_s) {
    SCOPED_TRACE(tick_s);
    FakeKrc krc({.tick_s = tick_s, .nonsense = 0.02, .seed = 9});
    krc.run(2000 * tick_s + 2.0, WildTargets(9));
    EXPECT_EQ(krc.violation(), "");
    EXPECT_GT(krc.fri->counters().impossible, 20U);
    EXPECT_GT(krc.judgement.travelled_mm, 50.0);
  }
}

TEST(FriLimits, AnArmThatIsNotObeyedForAWhileStartsAnewFromRest) {
  FakeKrc krc({.tick_s = 0.001});
  krc.run(1.0, strokes);
  krc.answers_obeyed = false;
  krc.run(0.05, strokes);
  krc.answers_obeyed = true;
  krc.run(1.0, strokes);
  EXPECT_EQ(krc.violation(), "");
  EXPECT_GE(krc.judgement.held, 1U);
  EXPECT_NEAR(static_cast<double>(krc.fri->counters().not_taken), 50.0, 3.0);
}

TEST(FriLimits, AControllerThatNeverTakesAnAnswerIsNamed) {
  FakeKrc krc({.tick_s = 0.001});
  krc.answers_obeyed = false;
  krc.run(0.5, [](double) { return Vec3{10, 10, -10}; });
  EXPECT_THAT(krc.judgement.last_problem, HasSubstr("none of the last 100 answers shows in its commanded frame"));
  EXPECT_EQ(krc.judgement.travelled_mm, 0.0);
}

TEST(FriLimits, TheCommandedPlaceMayStandInTheFramesOffset) {
  FakeKrc krc({.tick_s = 0.005, .in_offset = true});
  krc.run(3.0, [](double) { return Vec3{20, 0, 0}; });
  EXPECT_EQ(krc.violation(), "");
  EXPECT_NEAR(krc.commanded_mm().y, -20.0, 1e-3);
}

// Half the tick it states would be twice the speed.
TEST(FriLimits, ATickThatIsStatedTooLongIsCorrectedByTheTimeStamps) {
  FakeKrc krc({.tick_s = 0.002, .stated_s = 0.01});
  krc.monitor_s = 0.5;
  krc.run(4.0, WildTargets(7));
  EXPECT_EQ(krc.violation(), "");
  EXPECT_GT(krc.judgement.speed_mm_s, 200.0);
}

TEST(FriLimits, WithoutATickTheShortestIsTaken) {
  FakeKrc krc({.tick_s = 0.005, .stamps = false});
  krc.measurement.measurement_period_s = krc.measurement.command_period_s = 0.0F;
  krc.run(4.0, WildTargets(7));
  EXPECT_EQ(krc.violation(), "");
  EXPECT_LE(krc.judgement.speed_mm_s, 50.0 + 0.01);  // 250 mm/s in 1 ms, every 5 ms
}

TEST(FriLimits, ALostQualityBrakesWithinTheLimitsAndItsReturnStartsFromRest) {
  for (const double tick_s : kTicks_s) {
    SCOPED_TRACE(tick_s);
    FakeKrc krc({.tick_s = tick_s});
    krc.run(1.0, strokes);
    krc.measurement.quality = FriQuality::bad;
    const double before = krc.judgement.travelled_mm;
    krc.run(0.3, strokes);
    EXPECT_GT(krc.judgement.travelled_mm, before + 0.1) << "no dead stop";
    EXPECT_THAT(krc.judgement.last_problem, HasSubstr("link quality bad"));
    const Vec3 rest = krc.commanded_mm();
    krc.run(0.2, strokes);
    EXPECT_EQ(krc.commanded_mm(), rest);
    krc.measurement.quality = FriQuality::good;
    krc.run(1.0, strokes);
    EXPECT_NE(krc.commanded_mm(), rest);
    EXPECT_EQ(krc.judgement.held, 0U);
    EXPECT_EQ(krc.violation(), "");
  }
}

TEST(FriLimits, AStopBrakesWithinTheLimits) {
  for (const double tick_s : kTicks_s) {
    SCOPED_TRACE(tick_s);
    FakeKrc krc({.tick_s = tick_s});
    krc.run(1.0, strokes);
    EXPECT_FALSE(krc.followed->atRest());
    krc.followed->comeToRest();
    krc.run(0.3, strokes);
    EXPECT_TRUE(krc.followed->atRest());
    const Vec3 rest = krc.commanded_mm();
    krc.run(0.2, strokes);
    EXPECT_EQ(krc.commanded_mm(), rest);
    EXPECT_EQ(krc.judgement.held, 0U);
    EXPECT_EQ(krc.violation(), "");
  }
}

}  // namespace
}  // namespace fyd::device
