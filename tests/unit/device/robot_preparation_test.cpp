// What happens before the touchpad is called, step by step.
#include "core/device/robot/robot_preparation.h"

#include <gtest/gtest.h>

#include <limits>

namespace fyd::device {
namespace {

// Stands where it is told, above a material of 0.5 N/mm whose surface lies at −2.6 mm.
struct PreparationBench {
  RobotPreparation preparation;
  RobotReadings readings{.acceleration_g = {0.1, -0.2, 1.0}};
  double seconds = 0.0;
  double lowest_mm = 0.0;
  int exchanges_a_measurement = 1;
  int asked = 0;

  explicit PreparationBench(bool probe = true, double known = 0.0) : preparation({}, probe, known) {}
  void succeed(int cycles) {
    for (int i = 0; i < cycles && !preparation.finished(); ++i) {
      readings.position_mm = preparation.target();
      lowest_mm = std::min(lowest_mm, readings.position_mm.z);
      readings.force_N = std::max(0.5 * (-2.6 - readings.position_mm.z), 0.0);
      seconds += 0.001;
      if (++asked % exchanges_a_measurement == 0) readings.taken = instantAt(seconds);
      preparation.succeeded(readings, instantAt(seconds));
    }
  }
  void fail(int cycles) {
    for (int i = 0; i < cycles && !preparation.finished(); ++i) preparation.failed(instantAt(seconds += 0.001));
  }
};

TEST(RobotPreparation, ProbesAndTakesTheRestAcceleration) {
  PreparationBench bench;
  bench.succeed(20'000);
  ASSERT_TRUE(bench.preparation.finished());
  EXPECT_EQ(bench.preparation.outcome(), ProbeOutcome::measured);
  EXPECT_NEAR(bench.preparation.stiffness_N_per_mm(), 0.5, 1e-9);
  EXPECT_NEAR(bench.preparation.restAcceleration_g().y, -0.2, 1e-12);
  EXPECT_NEAR(bench.seconds, 15 * 0.5 + 0.2, 0.05);
}

TEST(RobotPreparation, WaitsForAnArmThatDoesNotFollowYet) {
  PreparationBench bench;
  bench.fail(100'000);
  EXPECT_FALSE(bench.preparation.finished());
  EXPECT_EQ(bench.preparation.target(), Vec3{});
  bench.succeed(20'000);
  EXPECT_EQ(bench.preparation.outcome(), ProbeOutcome::measured);
}

TEST(RobotPreparation, StartsWhereAYieldingArmIsToldToBe) {
  PreparationBench bench(false);
  bench.preparation.succeeded({.position_mm = {1, 2, -3}, .commanded_mm = Vec3{1, 2, -5}}, instantAt(0.0));
  EXPECT_EQ(bench.preparation.target(), (Vec3{1, 2, -5}));
}

TEST(RobotPreparation, AnArmThatStopsFollowingAbortsTheProbe) {
  PreparationBench bench;
  bench.succeed(3'200);
  EXPECT_LT(bench.preparation.target().z, -3.0);
  bench.fail(1);
  EXPECT_EQ(bench.preparation.target(), Vec3{});  // the retreat's, for when it follows again
  bench.fail(10'000);                             // the retreat is given up after 5 s
  EXPECT_TRUE(bench.preparation.finished());
  EXPECT_EQ(bench.preparation.outcome(), ProbeOutcome::aborted);
  EXPECT_EQ(bench.preparation.stiffness_N_per_mm(), 0.0);
}

TEST(RobotPreparation, TheOperatorsStopBringsAProbeBackToItsStart) {
  PreparationBench bench;
  bench.succeed(3'200);
  bench.preparation.abort();
  EXPECT_FALSE(bench.preparation.finished());
  bench.succeed(100);
  EXPECT_TRUE(bench.preparation.finished());
  EXPECT_EQ(bench.preparation.outcome(), ProbeOutcome::aborted);
  EXPECT_EQ(bench.readings.position_mm, Vec3{});
}

TEST(RobotPreparation, TheOperatorsStopBeforeAProbeEndsAtOnce) {
  PreparationBench bench;
  bench.fail(10);
  bench.preparation.abort();
  EXPECT_TRUE(bench.preparation.finished());
}

TEST(RobotPreparation, WithoutAProbeTheKnownStiffnessStands) {
  PreparationBench bench(false, 0.7);
  bench.succeed(1'000);
  EXPECT_TRUE(bench.preparation.finished());
  EXPECT_EQ(bench.preparation.outcome(), ProbeOutcome::skipped);
  EXPECT_EQ(bench.preparation.stiffness_N_per_mm(), 0.7);
  EXPECT_EQ(bench.lowest_mm, 0.0);
  EXPECT_EQ(PreparationBench(false, std::numeric_limits<double>::quiet_NaN()).preparation.stiffness_N_per_mm(), 0.0);
}

// An arm that measures every 5 ms and is asked every millisecond.
TEST(RobotPreparation, TheRestIsTheMeanOfMeasurementsNotOfExchanges) {
  PreparationBench bench(false);
  bench.exchanges_a_measurement = 5;
  bench.readings.acceleration_g = {0.1, 0.0, 1.0};
  bench.succeed(500);
  EXPECT_FALSE(bench.preparation.finished()) << "a hundred measurements";
  bench.readings.acceleration_g = {0.3, 0.0, 1.0};
  bench.succeed(1'000);
  EXPECT_TRUE(bench.preparation.finished());
  EXPECT_NEAR(bench.preparation.restAcceleration_g().x, 0.2, 0.002);
}

TEST(RobotPreparation, AnArmThatMeasuresSlowlyRestsForASecond) {
  for (const int slow : {100, 1'000'000}) {
    PreparationBench bench(false);
    bench.exchanges_a_measurement = slow;
    bench.succeed(10'000);
    EXPECT_TRUE(bench.preparation.finished()) << slow;
    EXPECT_NEAR(bench.seconds, 1.0, 0.01) << slow;
    EXPECT_NEAR(bench.preparation.restAcceleration_g().y, -0.2, 1e-12) << slow;
  }
}

TEST(RobotPreparation, AccelerationsThatAreNoNumbersDoNotCount) {
  PreparationBench bench(false);
  bench.succeed(101);
  bench.readings.acceleration_g = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
  bench.succeed(1'000);
  EXPECT_TRUE(bench.preparation.finished());
  EXPECT_NEAR(bench.preparation.restAcceleration_g().x, 0.1, 1e-12);
}

}  // namespace
}  // namespace fyd::device
