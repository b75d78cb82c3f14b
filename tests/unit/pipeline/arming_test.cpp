// Where the motors' references begin and how fast they go on: at arming, after a pause, and when the robot's operator
// begins or ends to set them. The rollers stand where the test puts them: they follow nothing.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/pipeline/pipeline.h"
#include "tests/unit/pipeline/whole_inputs.h"

namespace fyd::pipeline {
namespace {

using enum SafetyState;
using std::chrono::milliseconds;

constexpr double kFastest_deg_per_ms = 0.18;  // control.rate_limit_deg_per_s is 180 by default
constexpr double kEncoder_deg = 360.0 / 4096.0;
constexpr double kTicks_deg = 4200.0 / 90.0;  // of the boards' references [thesis §3]

struct Rollers {
  double stretch_deg = 20.0;
  double translation_deg = 0.0;
};

class Rig {
 public:
  const Outputs& step() {
    now += milliseconds(1);
    const auto counts = [](double angle_deg) {
      return static_cast<std::uint16_t>((4096 + std::lround(angle_deg / kEncoder_deg)) % 4096);
    };
    makeWhole(
        inputs, now,
        {counts(rollers.stretch_deg + rollers.translation_deg), counts(rollers.translation_deg - rollers.stretch_deg)});
    const Outputs& out = pipeline.step(inputs);
    inputs.commands.clear();
    inputs.robot.commands.clear();
    // Motors that are off stand where they stand: the first reference is judged by its distance from there.
    const Rollers asked = out.motors.active ? told(out) : rollers;
    if (out.motors.active) {
      fastest_deg = std::max(fastest_deg, std::abs(asked.stretch_deg - before.stretch_deg));
      fastest_deg = std::max(fastest_deg, std::abs(asked.translation_deg - before.translation_deg));
    }
    before = asked;
    return out;
  }
  const Outputs& run(int steps) {
    const Outputs* out = nullptr;
    for (int i = 0; i < steps; ++i) out = &step();
    return *out;
  }
  const Outputs& give(OperatorAction action) {
    (void)inputs.commands.push({.action = action});
    return step();
  }
  void robotSets(double first_ticks, double second_ticks) {
    (void)inputs.robot.commands.push(RobotCommand::motor_reference_on);
    inputs.robot.motor_reference.set({.first_ticks = first_ticks, .second_ticks = second_ticks}, now);
  }
  [[nodiscard]] static Rollers told(const Outputs& out) {
    const double first = out.motors.reference_ticks[0] / kTicks_deg;
    const double second = out.motors.reference_ticks[1] / kTicks_deg;
    return {0.5 * (first - second), 0.5 * (first + second)};
  }
  void expectNoJump() const { EXPECT_LE(fastest_deg, kFastest_deg_per_ms + kEncoder_deg + 1.0 / kTicks_deg); }

  Rig() { inputs.robot.phase = LinkPhase::running; }
  Instant now = instantAt(100.0);
  Rollers rollers;
  Inputs inputs;
  Rollers before;
  double fastest_deg = 0.0;  // a reference's change in a step, the first one's distance from the rollers with it
  Pipeline pipeline{Parameters{}};
};

TEST(Arming, BeginsWhereTheRollersStandAlsoOnALooseCloth) {
  for (const double stands_deg : {0.0, 12.0, 55.0, 90.0}) {
    Rig rig;
    rig.rollers.stretch_deg = stands_deg;
    rig.run(300);
    ASSERT_EQ(rig.give(OperatorAction::arm).telemetry.state, active);
    EXPECT_NEAR(rig.before.stretch_deg, stands_deg, 0.3);
    const Outputs& out = rig.run(2000);
    EXPECT_GE(out.telemetry.stretch_reference_deg, 20.0);
    EXPECT_LE(out.telemetry.stretch_reference_deg, 90.0);
    rig.expectNoJump();
  }
}

// As of an encoder whose zero is wrong: what is commanded keeps to the travel, or comes from a loose cloth into it.
TEST(Arming, BeyondTheTravelNothingIsCommanded) {
  for (const double stands_deg : {-120.0, 130.0}) {
    Rig rig;
    rig.rollers.stretch_deg = stands_deg;
    rig.run(300);
    ASSERT_EQ(rig.give(OperatorAction::arm).telemetry.state, active);
    for (int i = 0; i < 1000; ++i) {
      EXPECT_GE(rig.before.stretch_deg, -0.1);
      EXPECT_LE(rig.before.stretch_deg, 90.1);
      rig.step();
    }
  }
}

TEST(Arming, WhileTheRobotPausesBeginsWhereTheRollersStandNow) {
  Rig rig;
  rig.run(300);
  rig.give(OperatorAction::arm);
  rig.robotSets(85.0 * kTicks_deg, -85.0 * kTicks_deg);
  rig.run(2000);
  ASSERT_GT(rig.before.stretch_deg, 84.0);
  rig.give(OperatorAction::stop);
  (void)rig.inputs.robot.commands.push(RobotCommand::motor_reference_off);
  rig.rollers.stretch_deg = 30.0;  // a test of the motors left them there
  rig.inputs.robot.phase = LinkPhase::paused;
  rig.run(100);
  ASSERT_EQ(rig.give(OperatorAction::arm).telemetry.state, active);
  rig.run(100);
  EXPECT_NEAR(rig.before.stretch_deg, 30.0, 0.3);
  rig.inputs.robot.phase = LinkPhase::running;
  rig.run(1000);
  rig.expectNoJump();
}

TEST(Arming, WithAReferenceOfTheRobotsBeginsWhereTheRollersStand) {
  Rig rig;
  rig.rollers = {50.0, 8.0};
  rig.run(300);
  rig.robotSets(70.0 * kTicks_deg, -70.0 * kTicks_deg);
  rig.run(10);
  ASSERT_EQ(rig.give(OperatorAction::arm).telemetry.state, active);
  rig.run(1000);
  EXPECT_NEAR(rig.before.stretch_deg, 70.0, 0.1);
  EXPECT_NEAR(rig.before.translation_deg, 0.0, 0.1);
  rig.expectNoJump();
}

TEST(Arming, ATranslationOfTheRobotsEndsWithItsReferences) {
  Rig rig;
  rig.run(300);
  rig.give(OperatorAction::arm);
  rig.robotSets(1000.0, 1000.0);
  rig.run(1000);
  ASSERT_NEAR(rig.before.translation_deg, 1000.0 / kTicks_deg, 0.1);
  (void)rig.inputs.robot.commands.push(RobotCommand::motor_reference_off);
  rig.run(1000);
  EXPECT_NEAR(rig.before.translation_deg, 0.0, 0.05);
  rig.expectNoJump();
  // One that was left by a stop is not commanded again by the next arm.
  rig.robotSets(1000.0, 1000.0);
  rig.run(1000);
  ASSERT_GT(rig.before.translation_deg, 20.0);
  rig.give(OperatorAction::stop);
  (void)rig.inputs.robot.commands.push(RobotCommand::motor_reference_off);
  rig.run(10);
  rig.give(OperatorAction::arm);
  rig.run(10);
  EXPECT_NEAR(rig.before.translation_deg, 0.0, 0.05);
  rig.expectNoJump();
}

TEST(Arming, ARobotThatSaysGoodbyeSetsNoReferenceAnyMore) {
  Rig rig;
  (void)rig.inputs.commands.push({.action = OperatorAction::target_by_hand, .value = 0.6});
  rig.run(300);
  rig.give(OperatorAction::arm);
  rig.run(1500);
  const double by_hand_deg = rig.before.stretch_deg;
  rig.robotSets(88.0 * kTicks_deg, -88.0 * kTicks_deg);
  rig.run(1500);
  ASSERT_NEAR(rig.before.stretch_deg, 88.0, 0.1);
  rig.inputs.robot.phase = LinkPhase::closed;
  const Outputs& out = rig.run(1500);
  ASSERT_EQ(out.telemetry.state, active);
  EXPECT_NEAR(rig.before.stretch_deg, by_hand_deg, 3.0);
  rig.expectNoJump();
}

}  // namespace
}  // namespace fyd::pipeline
