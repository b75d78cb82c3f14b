// Hard cases of the control room: what a bad sensor, clock, gain or operator can send.
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "core/control/auto_tune.h"
#include "core/control/motor_mixing.h"
#include "core/control/pid.h"
#include "core/control/stiffness_controller.h"
#include "tests/not_a_number.h"
#include "tests/sweep.h"
#include "tests/unit/control/bench_plant.h"

namespace fyd::control {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSubnormal = std::numeric_limits<double>::denorm_min();
const std::vector<double> kBad = {kNaN, kInfinity, -kInfinity, kSubnormal, -kSubnormal, 0.0, -0.0,
                                  -1.0, 1e-300,    1e300,      -1e300,     1e12,        0.6};

TEST(PidHardCases, WhateverComesInTheOutputIsFiniteAndWithinLimits) {
  for (const double gain : {0.0, 1e-300, 1.0, 1e12, 1e300, -5.0, kNaN, kInfinity}) {
    Pid pid({.kp = gain, .ki = gain, .kd = gain, .derivative_filter_s = gain}, {-2, 3, 1e300});
    for (const double setpoint : kBad) {
      for (const double measurement : kBad) {
        for (const double dt : {0.001, 0.0, -1.0, kSubnormal, 1e300, kNaN, kInfinity}) {
          const double u = pid.step(setpoint, measurement, dt);
          ASSERT_TRUE(std::isfinite(u)) << gain << ' ' << setpoint << ' ' << measurement << ' ' << dt;
          ASSERT_GE(u, -2);
          ASSERT_LE(u, 3);
          ASSERT_TRUE(std::isfinite(pid.integral()));
        }
      }
    }
    pid.setGains({.kp = 1, .ki = 1});
    for (int i = 0; i < 5000; ++i) pid.step(0.1, 0.1, 0.01);
    EXPECT_TRUE(std::isfinite(pid.step(0.2, 0.1, 0.01)));
  }
}

TEST(PidHardCases, NegativeAndMeaninglessGainsCountAsZero) {
  Pid pid({.kp = -5, .ki = kNaN, .kd = -kInfinity}, {-2, 3, 1e300});
  for (int i = 0; i < 100; ++i) EXPECT_EQ(pid.step(1, 0.01 * i, 0.01), 0.0);
}

TEST(PidHardCases, HugeGainIsBangBangAndForgivenAfterwards) {
  Pid pid({.kp = 1e12, .ki = 1e12}, {-1, 1, 1e300});
  EXPECT_EQ(pid.step(0.1, 0, 0.001), 1.0);
  EXPECT_EQ(pid.step(-0.1, 0, 0.001), -1.0);
  EXPECT_EQ(pid.step(0.1, 0, 0.001), 1.0);
  pid.setGains({.kp = 0.5, .ki = 2});
  double u = 0;
  for (int i = 0; i < 3000; ++i) u = pid.step(0, 0.2, 0.001);  // e = −0.2
  EXPECT_LT(u, 0) << "ordinary gains lead again";
}

TEST(PidHardCases, TimeThatStandsStillOrGoesBackChangesNothing) {
  Pid pid({.kp = 1, .ki = 10, .kd = 1}, {-5, 5, 1e300});
  const double before = pid.step(0.3, 0.1, 0.001);
  const double integral = pid.integral();
  for (const double dt : {0.0, -0.001, -1e9, kNaN}) EXPECT_EQ(pid.step(0.9, -0.7, dt), before);
  EXPECT_EQ(pid.integral(), integral);
}

TEST(PidHardCases, AStepTenTimesTooLongCountsAsTheLongest) {
  Pid pid({.ki = 1}, {-5, 5, 1e300}, 0.02);
  pid.step(1, 0, 0.2);
  EXPECT_NEAR(pid.integral(), 0.02, 1e-15);
}

TEST(PidHardCases, TenHoursOfIntegrationStayExactAndBounded) {
  // 36 million steps of 1 ms. First with an error that cancels over each second: the integral must come back.
  Pid pid({.ki = 1}, {-1, 1, 1e300});
  constexpr long kSteps = 36'000'000;
  for (long i = 0; i < kSteps; ++i) pid.step(i % 1000 < 500 ? 0.1 : -0.1, 0, 0.001);
  EXPECT_NEAR(pid.integral(), 0.0, 1e-7);
  // Then against the limit for the rest of the night.
  for (long i = 0; i < kSteps / 10; ++i) pid.step(0.1, 0, 0.001);
  EXPECT_EQ(pid.output(), 1.0);
  EXPECT_NEAR(pid.integral(), 1.0, 1e-9);
  pid.step(-0.1, 0, 0.001);
  EXPECT_LT(pid.output(), 1.0);
}

TEST(ControllerHardCases, WhateverComesInTheReferenceStaysWithinTravel) {
  for (const ControlMode mode : {ControlMode::normal, ControlMode::thesis}) {
    for (const StaticLawKind law : {StaticLawKind::interpolated, StaticLawKind::thesis, StaticLawKind::thesis_linear}) {
      ControlParameters parameters;
      parameters.mode = mode;
      parameters.law = law;
      StiffnessController controller(parameters);
      long step = 0;
      for (const double target : kBad) {
        for (const double measured : kBad) {
          for (const double sigma : kBad) {
            for (const double angle : {kNaN, kInfinity, -1e300, 0.0, 45.0}) {
              const ControlOutput output = controller.step({.now = instantAt(0.001 * static_cast<double>(++step)),
                                                            .target_N_per_mm = target,
                                                            .measured_N_per_mm = measured,
                                                            .measured_sigma_N_per_mm = sigma,
                                                            .observable = step % 3 != 0,
                                                            .measured_angle_deg = angle,
                                                            .measured_angle_known = step % 5 != 0,
                                                            .enabled = step % 7 != 0});
              ASSERT_GE(output.stretch_angle_deg, 20.0);
              ASSERT_LE(output.stretch_angle_deg, 90.0);
              ASSERT_TRUE(std::isfinite(output.correction));
              ASSERT_TRUE(std::isfinite(output.cloth_scale));
              ASSERT_GT(output.cloth_scale, 0.0);
              ASSERT_FALSE(std::isinf(output.reachable_target_N_per_mm));
            }
          }
        }
      }
      // and works again afterwards
      controller.reset(20);
      BenchPlant plant;
      plant.now_s = 1e4;
      const auto course = plant.run(controller, 0.6, 4);
      if (mode == ControlMode::normal && law == StaticLawKind::interpolated) {
        EXPECT_NEAR(course.back(), 0.6, 0.012);
      }
    }
  }
}

TEST(ControllerHardCases, GainsFromNothingToAbsurdKeepTheLoopBounded) {
  for (const double gain : {0.0, 1e-12, 100.0, 1e12}) {
    ControlParameters parameters;
    parameters.kp = parameters.ki_per_s = gain;
    parameters.kd_s = gain == 1e12 ? 1e12 : 0.0;
    StiffnessController controller(parameters);
    BenchPlant plant;
    for (const double k : plant.run(controller, 0.6, 5)) {
      ASSERT_GE(k, 0.501 - 1e-9);
      ASSERT_LE(k, 0.715 + 1e-9);
    }
    if (gain < 1) {
      EXPECT_NEAR(plant.stiffness(), 0.6, 0.012) << "feed-forward alone";
    }
  }
}

TEST(ControllerHardCases, TimeStandingStillGoingBackAndJumping) {
  StiffnessController controller;
  BenchPlant plant;
  plant.run(controller, 0.6, 2);
  const ControlInput last = plant.read(0.7);
  const double before = controller.step(last).stretch_angle_deg;
  EXPECT_EQ(controller.step(last).stretch_angle_deg, before) << "the same instant again";
  ControlInput back = last;
  back.now -= std::chrono::hours(1);
  EXPECT_EQ(controller.step(back).stretch_angle_deg, before) << "an hour back";
  ControlInput late = back;
  late.now += std::chrono::seconds(30);
  const double after = controller.step(late).stretch_angle_deg;
  EXPECT_LE(std::abs(after - before), 180 * 0.02 + 1e-9) << "a long gap is a short step";
  plant.now_s = toSeconds(late.now.time_since_epoch());
  plant.run(controller, 0.6, 4);
  EXPECT_NEAR(plant.stiffness(), 0.6, 0.012) << "and the loop goes on from the new time";
}

TEST(ControllerHardCases, StepsTenTimesTooLongStillSettle) {
  ControlParameters trusting;
  trusting.measurement_bias = 0.0;
  StiffnessController controller(trusting);
  BenchPlant plant;
  plant.scale = 0.8;
  for (int i = 0; i < 800; ++i) {
    const double reference = controller.step(plant.read(0.5)).stretch_angle_deg;
    for (int j = 0; j < 10; ++j) plant.move(reference);
  }
  EXPECT_NEAR(plant.stiffness(), 0.5, 0.025);
}

TEST(ControllerHardCases, AStuckOrWildSensorIsAtMostAWrongStiffnessNeverAnEscape) {
  for (const double stuck : {0.0011, 0.2, 5.0, 999.0}) {
    StiffnessController controller;
    BenchPlant plant;
    double last = 20, swing = 0;
    for (int i = 0; i < 8000; ++i) {
      ControlInput input = plant.read(0.6);
      input.measured_N_per_mm = stuck;
      input.measured_sigma_N_per_mm = 0.01 * stuck;
      const double reference = controller.step(input).stretch_angle_deg;
      if (i > 6000) swing += std::abs(reference - last);
      last = reference;
      plant.move(reference);
    }
    EXPECT_LT(swing, 1.0) << stuck;
  }
}

TEST(ControllerHardCases, ManySmallPlantsAreAllStable) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int run = 0; run < 200; ++run) {
    StiffnessController controller;
    BenchPlant plant;
    plant.scale = 0.7 + 0.6 * uniform(random);
    plant.delay_s = 0.15 * uniform(random);
    plant.lag_s = 0.3 * uniform(random);
    plant.ripple = 0.15 * uniform(random);
    const double target = 0.4 + 0.4 * uniform(random);
    const auto course = plant.run(controller, target, 10);
    // An oscillation of ±2 % at 1 Hz travels 24 % in 3 s; one late correction travels once.
    double travelled = 0;
    for (std::size_t i = course.size() - 3000; i < course.size(); ++i) {
      travelled += std::abs(course[i] / course[i - 1] - 1);
    }
    EXPECT_LT(travelled, 0.16) << run << " scale " << plant.scale << " target " << target;
  }
}

TEST(ObserverHardCases, StaysFiniteAndForgets) {
  ScaleObserver observer;
  for (const double z : kBad) {
    for (const double sigma : kBad) {
      for (const double dt : {0.001, 0.0, -1.0, 1e300, kNaN, kInfinity}) {
        observer.step(z, sigma, 0.1, dt);
        ASSERT_TRUE(std::isfinite(observer.significantLogScale()));
        ASSERT_TRUE(std::isfinite(observer.sigma()));
        ASSERT_GT(observer.sigma(), 0.0);
      }
    }
  }
  observer.reset();
  EXPECT_EQ(observer.significantLogScale(), 0.0);
}

TEST(LawHardCases, InverseAtTheEndsAndARoundTripOnDenseTargets) {
  const StaticLaw law;
  EXPECT_EQ(law.angle_deg(0.501).value, 20.0);
  EXPECT_EQ(law.angle_deg(0.715).value, 90.0);
  EXPECT_FALSE(law.angle_deg(0.501).clamped);
  EXPECT_FALSE(law.angle_deg(0.715).clamped);
  double last = 0;
  for (int i = 0; i <= 21400; ++i) {
    const double k = 0.501 + 1e-5 * i;
    const double angle = law.angle_deg(k).value;
    EXPECT_GE(angle, last);
    EXPECT_NEAR(law.stiffness_N_per_mm(angle).value, std::min(k, 0.715), 1e-9);
    last = angle;
  }
}

TEST(LawHardCases, PointsThatNearlyCoincideStayMonotone) {
  StaticLaw law;
  ASSERT_TRUE(
      law.configure(StaticLawKind::interpolated, {{20, 20 + 1e-9, 50, 90}, 4}, {{0.5, 0.6, 0.6 + 1e-12, 0.7}, 4}));
  double last = 0;
  for (const double angle : stepsTo(20, 90, 0.01)) {
    const double k = law.stiffness_N_per_mm(angle).value;
    EXPECT_TRUE(std::isfinite(k));
    EXPECT_GE(k, last - 1e-12);
    EXPECT_TRUE(std::isfinite(law.angle_deg(k).value));
    last = k;
  }
}

}  // namespace
}  // namespace fyd::control
