// The filters before sending and after receiving a motion: attenuation, delay, order of messages.
#include "core/teleop/prediction/gesture_filter.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/not_a_number.h"

namespace fyd::teleop {
namespace {

TEST(EmissionFilter, TakesTremorAndStepsOfTheDeviceAwayAndDelaysNoSteadyMotion) {
  std::mt19937 random(2);
  std::normal_distribution<double> tremor(0.0, 0.1);
  EmissionFilter filter(0.05);
  double in = 0.0, out = 0.0, error = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const double true_mm = 20.0 * 0.001 * i;
    const double measured = 0.02 * std::round((true_mm + tremor(random)) / 0.02);
    const double sent = filter.step(0.001 * i, {measured})[0];
    if (i < 100) continue;
    in += std::pow(measured - true_mm, 2);
    out += std::pow(sent - true_mm, 2);
    error += sent - true_mm;
  }
  EXPECT_LT(out, 0.12 * in);  // 4 / n of the power, n = 50
  EXPECT_NEAR(error / 2900.0, 0.0, 0.005);
}

TEST(EmissionFilter, OfAnAccelerationItIsLateByATwelfthOfTheWindowSquared) {
  EmissionFilter filter(0.1);
  double sent = 0.0, t = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    t = 0.001 * i;
    sent = filter.step(t, {0.5 * 600.0 * t * t})[0];
  }
  EXPECT_NEAR(0.5 * 600.0 * t * t - sent, 600.0 * 0.01 / 12.0, 0.03);
}

TEST(EmissionFilter, WhatIsNotFiniteLeavesTheLastPosition) {
  EmissionFilter filter(0.05);
  static_cast<void>(filter.step(0.0, {3.0}));
  EXPECT_EQ(filter.step(0.001, {kNaN})[0], 3.0);
  EXPECT_EQ(filter.step(kNaN, {4.0})[0], 3.0);
  EXPECT_EQ(filter.step(0.002, {3.0})[0], 3.0);
}

TEST(ReceptionFilter, PutsOvertakenMessagesInTheirPlaceAndIsLateByHold) {
  // A ramp whose messages arrive in pairs, swapped, up to 30 ms after their dates.
  ReceptionFilter filter(0.04, 0.0);
  EXPECT_FALSE(filter.step(0.0));
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.001 * i;
    if (i % 20 == 0) {
      filter.message(t - 0.010, {30.0 * (t - 0.010)});
      filter.message(t - 0.020, {30.0 * (t - 0.020)});
    }
    const auto out = filter.step(t);
    if (i > 200) {
      ASSERT_TRUE(out);
      ASSERT_NEAR((*out)[0], 30.0 * (t - 0.04), 1e-9);
    }
  }
}

TEST(ReceptionFilter, TheLowPassOnSpeedSmoothsStepsOfTheMessagesAndKeepsUpWithSteadyMotion) {
  ReceptionFilter plain(0.04, 0.0), smooth(0.04, 0.02);
  double last_plain = 0.0, last_smooth = 0.0, rough = 0.0, smoothed = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const double t = 0.001 * i;
    if (i % 10 == 0) {
      const double tremor = i % 20 == 0 ? 0.2 : -0.2;
      plain.message(t, {30.0 * t + tremor});
      smooth.message(t, {30.0 * t + tremor});
    }
    const double a = (*plain.step(t))[0], b = (*smooth.step(t))[0];
    if (i > 300) {
      rough += std::pow(a - last_plain - 0.03, 2);
      smoothed += std::pow(b - last_smooth - 0.03, 2);
      EXPECT_NEAR(b, 30.0 * (t - 0.04), 0.25);
    }
    last_plain = a;
    last_smooth = b;
  }
  EXPECT_LT(smoothed, 0.3 * rough);
}

}  // namespace
}  // namespace fyd::teleop
