// The stiffness controller on a small plant (bench_plant.h): settling, limits, biased readings, live changes.
#include "core/control/stiffness_controller.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/not_a_number.h"
#include "tests/unit/control/bench_plant.h"

namespace fyd::control {
namespace {

double settling_s(const std::vector<double>& course, double target) {
  std::size_t last_outside = 0;
  for (std::size_t i = 0; i < course.size(); ++i) {
    if (std::abs(course[i] / target - 1) > 0.05) last_outside = i + 1;
  }
  return 0.001 * static_cast<double>(last_outside);
}

/// A measurement that is right on average: everything it says of the cloth may be used.
ControlParameters trusting() {
  ControlParameters parameters;
  parameters.measurement_bias = 0.0;
  return parameters;
}

TEST(StiffnessController, FeedForwardReachesNominalTargetsWithoutAMeasurement) {
  for (const double target : {0.51, 0.55, 0.6, 0.65, 0.7}) {
    StiffnessController controller;
    BenchPlant plant;
    for (int i = 0; i < 1500; ++i) {
      ControlInput input = plant.read(target);
      input.observable = false;
      plant.move(controller.step(input).stretch_angle_deg);
    }
    EXPECT_NEAR(plant.stiffness(), target, 0.01 * target) << target;
  }
}

TEST(StiffnessController, NominalFabricFastWithoutOvershoot) {
  for (const double target : {0.51, 0.55, 0.6, 0.65, 0.7}) {
    StiffnessController controller;
    BenchPlant plant;
    plant.ripple = 0.06;
    const auto course = plant.run(controller, target, 6);
    EXPECT_LE(settling_s(course, target), 0.6) << target;
    EXPECT_LE(*std::max_element(course.begin(), course.end()), 1.1 * target) << target;
    EXPECT_NEAR(course.back(), target, 0.02 * target) << target;
  }
}

TEST(StiffnessController, LearnsAFabricOffItsCalibration) {
  for (const auto& [scale, target] :
       {std::pair{1.3, 0.75}, {1.3, 0.9}, {0.7, 0.4}, {0.7, 0.48}, {1.15, 0.65}, {0.85, 0.55}}) {
    StiffnessController controller(trusting());
    BenchPlant plant;
    plant.scale = scale;
    plant.ripple = 0.06;
    ControlOutput last;
    const auto course = plant.run(controller, target, 6, &last);
    EXPECT_LE(settling_s(course, target), 3.0) << scale << ' ' << target;
    EXPECT_NEAR(last.cloth_scale, scale, 0.03 * scale);
    EXPECT_FALSE(last.target_clamped) << scale << ' ' << target;
  }
}

TEST(StiffnessController, ATargetOutOfReachEndsAtTheLimitStillAndReported) {
  struct Case {
    double scale, target, angle_deg, reachable;
  };
  for (const Case& c :
       {Case{1.0, 0.9, 90, 0.715}, {1.0, 0.3, 20, 0.501}, {0.7, 0.65, 90, 0.5005}, {1.3, 0.55, 20, 0.6513}}) {
    StiffnessController controller(trusting());
    BenchPlant plant;
    plant.scale = c.scale;
    ControlOutput last;
    plant.run(controller, c.target, 5, &last);
    const double before = last.stretch_angle_deg;
    plant.run(controller, c.target, 1, &last);
    EXPECT_EQ(last.stretch_angle_deg, before);
    EXPECT_NEAR(last.stretch_angle_deg, c.angle_deg, 0.2) << c.target;
    EXPECT_TRUE(last.target_clamped) << c.target;
    EXPECT_TRUE(last.at_limit) << c.target;
    EXPECT_NEAR(last.reachable_target_N_per_mm, c.reachable, 0.02) << c.target;
  }
}

TEST(StiffnessController, ComesBackFromAnUnreachableTargetWithoutUnwinding) {
  StiffnessController controller(trusting());
  BenchPlant plant;
  plant.run(controller, 0.95, 60);
  const auto course = plant.run(controller, 0.6, 3);
  EXPECT_LE(settling_s(course, 0.6), 0.6);
}

TEST(StiffnessController, ReferenceKeepsRateAndTravel) {
  struct Travel {
    double from_deg, to_deg;
  };
  for (const Travel travel : {Travel{30, 80}, {0, 15}, {100, 120}}) {  // the law's angles are 20 to 90°
    ControlParameters parameters;
    parameters.rate_limit_deg_per_s = 50;
    parameters.travel_minimum_deg = travel.from_deg;
    parameters.travel_maximum_deg = travel.to_deg;
    StiffnessController controller(parameters);
    BenchPlant plant;
    plant.angle_deg = std::clamp(40.0, travel.from_deg, travel.to_deg);
    double last = plant.angle_deg;
    for (int i = 0; i < 4000; ++i) {
      const double target = i % 1000 < 500 ? 5.0 : 0.01;
      const ControlOutput output = controller.step(plant.read(target));
      EXPECT_LE(std::abs(output.stretch_angle_deg - last), 0.05 + 1e-9);
      ASSERT_GE(output.stretch_angle_deg, travel.from_deg);
      ASSERT_LE(output.stretch_angle_deg, travel.to_deg);
      EXPECT_TRUE(output.target_clamped);
      EXPECT_TRUE(std::isfinite(output.reachable_target_N_per_mm) && std::isfinite(output.correction));
      last = output.stretch_angle_deg;
      plant.move(last);
    }
  }
}

TEST(StiffnessController, ABiasedMeasurementIsNeverWorseThanTheLawAlone) {
  for (const double scale : {0.75, 0.9, 1.0, 1.1, 1.25}) {
    for (const double bias : {0.87, 0.95, 1.0, 1.05, 1.15}) {
      StiffnessController controller;
      BenchPlant plant;
      plant.scale = scale;
      plant.bias = bias;
      plant.ripple = 0.03;
      const double target = 0.6 * scale;  // reachable; the law alone ends at scale times as much
      const auto course = plant.run(controller, target, 8);
      const double off = std::abs(std::log(course.back() / target));
      const double law_alone = std::abs(
          std::log(StaticLaw().stiffness_N_per_mm(StaticLaw().angle_deg(target).value).value * scale / target));
      EXPECT_LE(off, law_alone + 0.01) << scale << ' ' << bias;
    }
  }
}

TEST(StiffnessController, AMeasurementThatContradictsTheLawDrivesNothing) {
  for (const double bias : {0.45, 1.9}) {
    StiffnessController controller;
    BenchPlant plant;
    plant.bias = bias;
    plant.ripple = 0.03;
    ControlOutput last;
    auto course = plant.run(controller, 0.62, 8, &last);
    EXPECT_NEAR(course.back(), 0.62, 0.01) << bias;
    EXPECT_TRUE(last.law_contradicted);
    EXPECT_FALSE(last.at_limit);
    EXPECT_FALSE(last.target_clamped);
    plant.bias = 1.0;  // the camera is cleaned
    course = plant.run(controller, 0.62, 20, &last);
    EXPECT_FALSE(last.law_contradicted);
    EXPECT_NEAR(course.back(), 0.62, 0.01);
  }
}

TEST(StiffnessController, MeetsTheTargetWhereTheFingerIs) {
  for (const double place : {0.8, 1.25, 1.6}) {
    StiffnessController controller;
    BenchPlant plant;
    plant.place = place;
    ControlOutput last;
    auto course = plant.run(controller, 0.6 * place, 2, &last);
    EXPECT_NEAR(course.back(), 0.6 * place, 0.01) << place;
    EXPECT_LE(settling_s(course, 0.6 * place), 0.6) << place;
    EXPECT_FALSE(last.target_clamped);
    plant.run(controller, 0.55, 2, &last);  // within the law's reach, not at this place
    EXPECT_EQ(last.target_clamped, place > 1.0) << place;
    EXPECT_NEAR(last.reachable_target_N_per_mm, plant.stiffness(), 0.01) << place;
  }
}

TEST(StiffnessController, APlaceThatIsNoNumberLeavesTheLastOne) {
  StiffnessController controller;
  BenchPlant plant;
  plant.place = 1.3;
  plant.run(controller, 0.8, 2);
  const double before = plant.angle_deg;
  for (const double none : {kNaN, 0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    ControlInput input = plant.read(0.8);
    input.place_factor = none;
    const ControlOutput output = controller.step(input);
    EXPECT_NEAR(output.stretch_angle_deg, before, 0.2);
    plant.move(output.stretch_angle_deg);
  }
}

TEST(StiffnessController, ANewTouchElsewhereTakesItsPlaceAtOnce) {
  StiffnessController controller;
  BenchPlant plant;
  plant.place = 1.3;
  plant.run(controller, 0.8, 2);
  ControlInput lifted = plant.read(0.8);
  lifted.observable = false;
  lifted.place_factor = kNaN;
  plant.now_s += 0.001;
  (void)controller.step(lifted);
  plant.place = 0.8;
  plant.now_s += 0.001;
  // 0.8 N/mm is more than this place can give: 0.715 N/mm in the middle.
  EXPECT_NEAR(controller.step(plant.read(0.8)).reachable_target_N_per_mm, 0.8 * 0.715, 0.01);
}

TEST(StiffnessController, NoTargetAndNotEnabledHoldTheReference) {
  StiffnessController controller;
  BenchPlant plant;
  plant.run(controller, 0.65, 2);
  const double held = controller.step(plant.read(0.65)).stretch_angle_deg;
  for (const double none : {kNaN, 0.0, -1.0}) {
    plant.now_s += 0.001;
    const ControlOutput output = controller.step(plant.read(none));
    EXPECT_EQ(output.stretch_angle_deg, held);
    EXPECT_TRUE(output.holding);
    EXPECT_FALSE(output.target_clamped);
    EXPECT_TRUE(std::isnan(output.reachable_target_N_per_mm));
  }
  for (int i = 0; i < 100; ++i) {
    ControlInput input = plant.read(0.51);
    input.enabled = false;
    plant.now_s += 0.001;
    EXPECT_EQ(controller.step(input).stretch_angle_deg, held);
  }
}

TEST(StiffnessController, EnablingStartsWhereTheRollersStand) {
  StiffnessController controller;
  BenchPlant plant;
  plant.angle_deg = 70;
  ControlInput input = plant.read(0.52);
  input.enabled = false;
  (void)controller.step(input);
  plant.now_s += 0.001;
  EXPECT_NEAR(controller.step(plant.read(0.52)).stretch_angle_deg, 70, 0.2);
}

TEST(StiffnessController, LiveGainChangesDoNotJumpTheReference) {
  ControlParameters parameters;
  StiffnessController controller(parameters);
  BenchPlant plant;
  plant.scale = 0.8;
  ControlOutput last;
  plant.run(controller, 0.5, 0.9, &last);
  for (const double kp : {0.5, 0.0, 2.0, 0.05}) {
    parameters.kp = kp;
    parameters.ki_per_s *= 1.5;
    controller.configure(parameters);
    const double before = last.stretch_angle_deg;
    last = controller.step(plant.read(0.5));
    EXPECT_NEAR(last.stretch_angle_deg, before, 0.2) << kp;
    plant.move(last.stretch_angle_deg);
  }
}

TEST(StiffnessController, KeepsWhatItLearnedThroughALiftedFinger) {
  StiffnessController controller;
  BenchPlant plant;
  plant.scale = 0.8;
  plant.run(controller, 0.5, 4);
  const double learned_deg = plant.angle_deg;
  for (int i = 0; i < 2000; ++i) {
    ControlInput input = plant.read(0.5);
    input.observable = false;
    input.measured_N_per_mm = 0.0;
    plant.move(controller.step(input).stretch_angle_deg);
  }
  EXPECT_NEAR(plant.angle_deg, learned_deg, 1.0);
}

TEST(StiffnessController, ThesisModeByHand) {
  ControlParameters parameters;
  parameters.mode = ControlMode::thesis;
  parameters.law = StaticLawKind::thesis;
  parameters.thesis_kp = 50;
  parameters.thesis_ki = 20;
  StiffnessController controller(parameters);
  ControlInput input{.target_N_per_mm = 0.6, .measured_N_per_mm = 0.55, .observable = true, .enabled = true};
  const auto at = [&](double time_s) {
    input.now = instantAt(time_s);
    return controller.step(input).stretch_angle_deg;
  };
  at(10.000);
  // rest = 314.5·0.36 − 107·0.6 − 0.3552 = 48.6648
  EXPECT_NEAR(at(10.001), 48.6648, 1e-9);
  // e = 0.05: 50·0.05 + 20·0.05·0.1 = 2.6, then the next after 100 ms: 2.7
  EXPECT_NEAR(at(10.002), 51.2648, 1e-9);
  EXPECT_NEAR(at(10.100), 51.2648, 1e-9) << "every 100 ms only";
  EXPECT_NEAR(at(10.103), 51.3648, 1e-9);
  input.measured_N_per_mm = 0.595;
  EXPECT_NEAR(at(10.210), 51.3648, 1e-9) << "error of at most 0.01 is left alone";
  input.measured_N_per_mm = 0.09;
  EXPECT_NEAR(at(10.320), 51.3648, 1e-9) << "no stiffness below 0.1 is believed";
}

}  // namespace
}  // namespace fyd::control
