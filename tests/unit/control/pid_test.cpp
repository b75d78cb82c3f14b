// The PID controller: terms by hand, anti-windup, limits, rate limit, bumpless change of gains.
#include "core/control/pid.h"

#include <gtest/gtest.h>

namespace fyd::control {
namespace {

constexpr PidLimits kWide{-1e6, 1e6, 1e300};

TEST(Pid, ProportionalAndIntegralByHand) {
  // e = 2: I after n steps of 10 ms = 3·2·0.01·n; u = 5·2 + I
  Pid pid({.kp = 5, .ki = 3}, kWide);
  EXPECT_NEAR(pid.step(2, 0, 0.01), 10.06, 1e-12);
  EXPECT_NEAR(pid.step(2, 0, 0.01), 10.12, 1e-12);
  EXPECT_NEAR(pid.step(1, 0, 0.01), 5.15, 1e-12);
}

TEST(Pid, DerivativeActsOnTheMeasurementOnly) {
  Pid pid({.kd = 2, .derivative_filter_s = 0.09}, kWide);
  EXPECT_EQ(pid.step(0, 0, 0.01), 0.0);
  EXPECT_EQ(pid.step(100, 0, 0.01), 0.0) << "a step of the target gives no kick";
  // ẏ filtered: (0.5 − 0)/(0.09 + 0.01) = 5; u = −2·5
  EXPECT_NEAR(pid.step(100, 0.5, 0.01), -10.0, 1e-12);
  // then ẏ decays by 0.01/0.1 of itself a step
  EXPECT_NEAR(pid.step(100, 0.5, 0.01), -9.0, 1e-12);
}

TEST(Pid, IntegratorStopsAtALimitAndNothingHasToUnwind) {
  Pid pid({.kp = 1, .ki = 10}, {-1, 1, 1e300});
  for (int i = 0; i < 100000; ++i) EXPECT_LE(pid.step(5, 0, 0.01), 1.0);
  EXPECT_TRUE(pid.saturated());
  EXPECT_LT(pid.step(-0.01, 0, 0.01), 1.0) << "leaves the limit with the first step of the other sign";
  EXPECT_LT(pid.step(-0.5, 0, 0.01), 0.6);
}

TEST(Pid, ReturnsToAMovedLimitAtOnceWhenAskedInwardOnly) {
  Pid pid({.ki = 1}, {-1, 1, 1e300});
  for (int i = 0; i < 100; ++i) pid.step(0.5, 0, 0.01);
  EXPECT_NEAR(pid.integral(), 0.5, 1e-9);
  pid.setLimits({-1, 0.2, 1e300});
  EXPECT_EQ(pid.step(0.5, 0, 0.01), 0.2);
  EXPECT_NEAR(pid.integral(), 0.5, 1e-9) << "pushed outward: what was learned is kept";
  EXPECT_NEAR(pid.step(-0.1, 0, 0.01), 0.199, 1e-9) << "asked inward: from the edge";
}

TEST(Pid, NewGainsDoNotMoveTheOutput) {
  Pid pid({.kp = 2, .ki = 1, .kd = 0.3, .derivative_filter_s = 0.1}, kWide);
  double y = 0.0, before = 0.0;
  for (int i = 0; i < 50; ++i) before = pid.step(1, y += 0.002, 0.01);
  pid.setGains({.kp = 7, .ki = 1, .kd = 0.1, .derivative_filter_s = 0.1});
  // One more step moves it by no more than the loop itself does in a step.
  EXPECT_NEAR(pid.step(1, y, 0.01), before, 0.05);
}

TEST(Pid, OutputRateIsLimited) {
  Pid pid({.kp = 100}, {-10, 10, 2.0});
  EXPECT_NEAR(pid.step(1, 0, 0.01), 0.02, 1e-12);
  EXPECT_NEAR(pid.step(1, 0, 0.01), 0.04, 1e-12);
  EXPECT_NEAR(pid.step(-1, 0, 0.01), 0.02, 1e-12);
}

TEST(Pid, IntegratorWaitsWhileTheRateLimitHoldsTheOutputBack) {
  Pid pid({.kp = 10, .ki = 100}, {-100, 100, 1.0});
  for (int i = 0; i < 100; ++i) pid.step(1, 0, 0.01);
  EXPECT_EQ(pid.integral(), 0.0);
}

TEST(Pid, HoldsTheIntegratorOnRequest) {
  Pid pid({.kp = 1, .ki = 100}, kWide);
  EXPECT_EQ(pid.step(1, 0, 0.01, false), 1.0);
  EXPECT_EQ(pid.integral(), 0.0);
}

TEST(Pid, ResetStartsFromTheGivenOutput) {
  Pid pid({.ki = 1}, {-1, 1, 1e300});
  pid.reset(0.4);
  EXPECT_EQ(pid.output(), 0.4);
  EXPECT_NEAR(pid.step(0.1, 0, 0.01), 0.401, 1e-12);
  pid.reset(7);
  EXPECT_EQ(pid.output(), 1.0);
}

}  // namespace
}  // namespace fyd::control
