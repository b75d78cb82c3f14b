// The probe on arms made for the test, in virtual time; expected stiffness is worked out by hand in each.
#include "core/device/robot/material_probe.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/not_a_number.h"

namespace fyd::device {
namespace {

// An arm that stands where it is told at once, above a surface with a force law.
struct Bench {
  double surface_mm = -2.6;
  std::function<double(double)> force_at = [](double depth_mm) { return 0.5 * depth_mm; };
  bool frozen = false;

  RobotReadings readings;
  double lowest_mm = 0.0;
  double largest_N = 0.0;
  double seconds = 0.0;

  void run(MaterialProbe& probe) {
    while (!probe.finished() && seconds < 200.0) {
      seconds += 0.001;
      const Vec3 target = probe.step(readings, instantAt(seconds));
      EXPECT_TRUE(target.finite());
      lowest_mm = std::min(lowest_mm, target.z);
      if (!frozen) readings.position_mm = target;
      const double depth_mm = surface_mm - readings.position_mm.z;
      readings.force_N = depth_mm > 0.0 ? force_at(depth_mm) : 0.0;
      largest_N = std::max(largest_N, readings.force_N);
    }
    EXPECT_TRUE(probe.finished());
  }
};

// With the surface at −2.6 mm and 0.5 N/mm, steps of 1 mm give forces 0.2 (−3), 0.7 (−4), 1.2 (−5): first contact at
// −5 mm, d₀ = 0, F₀ = 1.2; then Fᵢ = 1.2 + 0.5 i at dᵢ = i, for i = 1 … 9.
TEST(MaterialProbe, SlopeFindsTheStiffnessOfALinearMaterialExactly) {
  Bench bench;
  MaterialProbe probe({}, {});
  bench.run(probe);
  EXPECT_EQ(probe.outcome(), ProbeOutcome::measured);
  EXPECT_EQ(probe.sampleCount(), 10U);
  EXPECT_NEAR(probe.stiffness_N_per_mm(), 0.5, 1e-12);
  EXPECT_EQ(bench.lowest_mm, -14.0);
  EXPECT_EQ(bench.readings.position_mm, Vec3{});  // back at the start
}

TEST(MaterialProbe, MeanAndThesisDivideByNineAndByTen) {
  double sum = 0.0;
  for (int i = 1; i <= 9; ++i) sum += (1.2 + 0.5 * i) / i;
  for (const auto& [estimate, divisor] : {std::pair{ProbeEstimate::mean, 9.0}, {ProbeEstimate::thesis, 10.0}}) {
    Bench bench;
    MaterialProbe probe({.estimate = estimate}, {});
    bench.run(probe);
    EXPECT_NEAR(probe.stiffness_N_per_mm(), sum / divisor, 1e-12);
  }
  EXPECT_NEAR(sum / 9.0, 0.8772, 1e-4);  // why the mean is not the default: 75 % above the true 0.5
}

TEST(MaterialProbe, DwellsHalfASecondAtEachStep) {
  Bench bench;
  MaterialProbe probe({}, {});
  bench.run(probe);
  EXPECT_NEAR(bench.seconds, 15 * 0.5, 0.05);  // the start and 14 steps
}

TEST(MaterialProbe, StopsAtTheTravelLimitWhenThereIsNothing) {
  Bench bench;
  bench.surface_mm = -1e9;
  MaterialProbe probe({}, {1.0, 2.0, 10.0});
  bench.run(probe);
  EXPECT_EQ(probe.outcome(), ProbeOutcome::no_contact);
  EXPECT_EQ(probe.stiffness_N_per_mm(), 0.0);
  EXPECT_EQ(bench.lowest_mm, 10.0 - 25.0);
  EXPECT_EQ(bench.readings.position_mm, (Vec3{1.0, 2.0, 10.0}));
}

TEST(MaterialProbe, MaterialTooSoftToBeSampledTwiceIsNotGuessed) {
  Bench bench;
  bench.force_at = [](double depth_mm) { return 0.036 * depth_mm; };  // 0.806 N only at the last step, −25 mm
  MaterialProbe probe({}, {});
  bench.run(probe);
  EXPECT_EQ(probe.outcome(), ProbeOutcome::too_few);
  EXPECT_EQ(probe.stiffness_N_per_mm(), 0.0);
}

TEST(MaterialProbe, GoesBackAtOnceAboveTheForceLimit) {
  Bench bench;
  bench.surface_mm = -0.5;
  bench.force_at = [](double depth_mm) { return 4.0 * depth_mm; };  // 2, 6, 10 N
  MaterialProbe probe({.force_limit_N = 9.0}, {});
  bench.run(probe);
  EXPECT_EQ(probe.outcome(), ProbeOutcome::measured);
  EXPECT_EQ(probe.sampleCount(), 2U);
  EXPECT_NEAR(probe.stiffness_N_per_mm(), 4.0, 1e-12);
  EXPECT_NEAR(bench.largest_N, 10.0, 1e-12);
  EXPECT_LT(bench.seconds, 3 * 0.5 + 0.1);  // did not dwell there
}

TEST(MaterialProbe, RigidMaterialIsBoundedNotInfinite) {
  Bench bench;
  bench.surface_mm = -0.5;
  MaterialProbe probe({.force_limit_N = 100.0}, {});
  bench.frozen = true;  // stands on the surface, whatever it is told
  bench.readings.position_mm.z = -0.5 - 1e-9;
  bench.force_at = [](double) { return 5.0; };
  while (probe.phase() == ProbePhase::descending) {
    bench.seconds += 0.01;
    probe.step({.position_mm = {0, 0, -0.5}, .force_N = 5.0 + bench.seconds}, instantAt(bench.seconds));
  }
  EXPECT_EQ(probe.outcome(), ProbeOutcome::measured);
  EXPECT_EQ(probe.stiffness_N_per_mm(), 1000.0);
}

TEST(MaterialProbe, ForceThatFallsWithDepthIsNoNegativeStiffness) {
  for (const ProbeEstimate estimate : {ProbeEstimate::slope, ProbeEstimate::mean, ProbeEstimate::thesis}) {
    Bench bench;
    bench.force_at = [](double depth_mm) { return 5.0 - 0.2 * depth_mm; };
    MaterialProbe probe({.estimate = estimate}, {});
    bench.run(probe);
    EXPECT_GE(probe.stiffness_N_per_mm(), 0.0);
  }
}

TEST(MaterialProbe, ReadingThatIsNoNumberSendsItBack) {
  for (const RobotReadings& bad : {RobotReadings{.position_mm = {0, 0, kNaN}}, RobotReadings{.force_N = kNaN},
                                   RobotReadings{.force_N = std::numeric_limits<double>::infinity()}}) {
    MaterialProbe probe({}, {0, 0, 5.0});
    for (int i = 0; i < 700; ++i) probe.step({.position_mm = {0, 0, 4.0}}, instantAt(0.001 * i));
    EXPECT_EQ(probe.target().z, 4.0);
    EXPECT_EQ(probe.step(bad, instantAt(0.7)), (Vec3{0, 0, 5.0}));
    EXPECT_EQ(probe.outcome(), ProbeOutcome::bad_reading);
    probe.step(bad, instantAt(5.8));  // never back, as far as anyone can tell: not waited for longer than 5 s
    EXPECT_TRUE(probe.finished());
    EXPECT_EQ(probe.stiffness_N_per_mm(), 0.0);
  }
}

TEST(MaterialProbe, AbortGoesBackWithoutAResult) {
  Bench bench;
  MaterialProbe probe({}, {});
  for (int i = 0; i < 3'200; ++i) probe.step(bench.readings, instantAt(0.001 * i));
  probe.abort();
  bench.run(probe);
  EXPECT_EQ(probe.outcome(), ProbeOutcome::aborted);
  EXPECT_EQ(probe.stiffness_N_per_mm(), 0.0);
  EXPECT_EQ(bench.readings.position_mm, Vec3{});
}

TEST(MaterialProbe, TimeLimitEndsAProbeThatIsTooSlow) {
  Bench bench;
  MaterialProbe probe({.dwell_s = 20.0, .time_limit_s = 60.0}, {});
  bench.run(probe);
  EXPECT_EQ(probe.outcome(), ProbeOutcome::timed_out);
  EXPECT_LT(bench.seconds, 60.1);
}

TEST(MaterialProbe, TimeThatStandsStillOrGoesBackNeverMovesIt) {
  MaterialProbe probe({}, {});
  for (int i = 0; i < 10'000; ++i) probe.step({}, instantAt(5.0 - 0.001 * i));
  EXPECT_EQ(probe.target(), Vec3{});
}

}  // namespace
TEST(MaterialProbe, ALimitThatIsNoNumberIsRefused) {
  EXPECT_TRUE(checkProbe({}));
  for (const double wrong : {kNaN, 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_FALSE(checkProbe({.force_limit_N = wrong}));
    EXPECT_FALSE(checkProbe({.travel_limit_mm = wrong}));
    EXPECT_FALSE(checkProbe({.dwell_s = wrong}));
    EXPECT_FALSE(checkProbe({.time_limit_s = wrong}));
  }
}

}  // namespace fyd::device
