// Whatever comes in, what goes out is a number within its limits.
#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "core/pipeline/pipeline.h"
#include "tests/not_a_number.h"
#include "tests/unit/pipeline/whole_inputs.h"

namespace fyd::pipeline {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Healthy inputs at a time: everything fresh, a finger in the middle, a robot of 0.6 N/mm.
Inputs healthy(double time_s) {
  Inputs inputs;
  makeWhole(inputs, instantAt(time_s));
  inputs.robot.phase = LinkPhase::running;
  (void)inputs.robot.accelerations.push({.taken = inputs.now, .acceleration_g = {0.1, 0.2, 0.3}});
  return inputs;
}

void expectWithinLimits(const Outputs& outputs, const Parameters& parameters) {
  for (const double duty : outputs.motors.vibration_duty_percent) {
    ASSERT_TRUE(std::isfinite(duty));
    ASSERT_LE(std::abs(duty), 100.0);
  }
  const double limit = parameters.control.motor_limit_deg * control::kTicksPerDegree + 1.0;
  for (const std::int16_t ticks : outputs.motors.reference_ticks) ASSERT_LE(std::abs(ticks), limit);
  ASSERT_TRUE(outputs.touch.position_mm.finite());
  ASSERT_LE(std::abs(outputs.touch.position_mm.x), kWorkspaceHalf_mm.x);
  ASSERT_LE(std::abs(outputs.touch.position_mm.y), kWorkspaceHalf_mm.y);
  ASSERT_LE(std::abs(outputs.touch.position_mm.z), kWorkspaceHalf_mm.z);
  ASSERT_TRUE(std::isfinite(outputs.touch.force_N));
  ASSERT_GE(outputs.touch.force_N, 0.0);
  ASSERT_TRUE(std::isfinite(outputs.telemetry.stretch_reference_deg));
  ASSERT_TRUE(std::isfinite(outputs.telemetry.texture_signal_g));
}

/// One value of a kind that breaks arithmetic.
double nasty(std::mt19937& random) {
  static const std::vector<double> kValues = {kNaN,    kInfinity, -kInfinity, 0.0,   -0.0, 1e308, -1e308, 5e-324,
                                              -5e-324, 1e-310,    1e12,       -1e12, 1.0,  -1.0,  0.5};
  return kValues[random() % kValues.size()];
}

TEST(StepNumerics, RandomNastyInputsNeverLeaveTheLimits) {
  std::mt19937 random(7);
  Parameters parameters;
  Pipeline pipeline(parameters);
  double time_s = 10.0;
  Inputs inputs = healthy(time_s);
  int active = 0;
  for (int step = 0; step < 50'000; ++step) {
    time_s += (random() % 100 == 0) ? -0.5 + 0.01 * static_cast<double>(random() % 100) : 0.001;
    const Inputs fresh = healthy(time_s);
    inputs = fresh;
    if (random() % 3 == 0) inputs.bridge.value.value_mV_per_V = nasty(random);
    if (random() % 3 == 0) inputs.finger.value.x_mm = nasty(random);
    if (random() % 3 == 0) inputs.finger.value.y_mm = nasty(random);
    if (random() % 5 == 0) inputs.finger.value.area_px = nasty(random);
    if (random() % 3 == 0) inputs.ir.value[random() % 3] = static_cast<std::uint16_t>(random());
    if (random() % 7 == 0)
      inputs.ir.value.count = static_cast<std::uint32_t>(random() % (sensing::kMaximumIrSensors + 1));
    if (random() % 3 == 0) inputs.robot.state.value.stiffness_N_per_mm = nasty(random);
    if (random() % 3 == 0) inputs.robot.accelerations[0].acceleration_g.y = nasty(random);
    if (random() % 5 == 0) inputs.robot.accelerations[0].taken = instantAt(nasty(random));
    if (random() % 3 == 0) inputs.motors.value.encoder_counts[0] = static_cast<std::uint16_t>(random());
    if (random() % 5 == 0) {
      inputs.motors.value.position_duty_known = true;
      inputs.motors.value.position_duty_percent = {nasty(random), nasty(random)};
    }
    if (random() % 20 == 0) (void)inputs.robot.commands.push(static_cast<RobotCommand>(random() % 12));
    if (random() % 5 == 0) inputs.robot.motor_reference.set({nasty(random), nasty(random)}, inputs.now);
    if (random() % 50 == 0) inputs.robot.phase = static_cast<LinkPhase>(random() % 6);
    if (random() % 20 == 0) {
      (void)inputs.changes.push({.index = static_cast<std::uint16_t>(random() % 150), .value = nasty(random)});
    }
    if (random() % 10 == 0) {
      (void)inputs.commands.push({.action = static_cast<OperatorAction>(random() % 5), .value = nasty(random)});
    }
    if (random() % 1000 == 0) inputs.missed_cycles = random();
    const Outputs& outputs = pipeline.step(inputs);
    active += outputs.telemetry.state == SafetyState::active ? 1 : 0;
    expectWithinLimits(outputs, parameters);
    if (HasFatalFailure()) FAIL() << "at step " << step;
  }
  EXPECT_GT(active, 500);  // of 13,871: the others command nothing
}

TEST(StepNumerics, EmptyInputsForEverAreHarmless) {
  Pipeline pipeline{Parameters{}};
  for (int i = 0; i < 100; ++i) {
    const Outputs& outputs = pipeline.step(Inputs{});
    EXPECT_EQ(outputs.telemetry.state, SafetyState::disconnected);
    EXPECT_FALSE(outputs.motors.active);
    EXPECT_EQ(outputs.motors.vibration_duty_percent[0], 0.0);
  }
}

TEST(StepNumerics, TheSameInputsGiveTheSameOutputsBitForBit) {
  const auto run = [] {
    Pipeline pipeline{Parameters{}};
    std::vector<double> out;
    for (int i = 0; i < 3000; ++i) {
      Inputs inputs = healthy(1.0 + i * 0.001);
      inputs.robot.accelerations[0].acceleration_g.x = std::sin(i * 0.7);
      if (i == 500) (void)inputs.commands.push({.action = OperatorAction::arm});
      const Outputs& outputs = pipeline.step(inputs);
      for (const TelemetryField& field : telemetryFields()) out.push_back(field.read(outputs.telemetry));
    }
    return out;
  };
  const auto first = run();
  const auto second = run();
  ASSERT_EQ(first.size(), second.size());
  EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(double)), 0);
}

}  // namespace
}  // namespace fyd::pipeline
