// DeviceTestRunner in virtual time: conditions for starting a test, and everything that ends it.
#include "core/station/device_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/control/motor_mixing.h"

namespace fyd::station {
namespace {

using device::DeviceTest;
using pipeline::Fault;
using pipeline::OperatorAction;
using pipeline::SafetyState;
using testing::HasSubstr;

constexpr Duration kStep = std::chrono::milliseconds(1);

/// The haptic loop around the runner; the encoders follow what is commanded.
struct Loop {
  Loop() {
    outputs.telemetry.state = SafetyState::ready;
    step();
  }
  bool step() {
    inputs.now += kStep;
    if (encoders_answer) inputs.motors.set({.encoder_counts = counts}, inputs.now);
    outputs.faults.set(static_cast<std::size_t>(Fault::motors_stale), !encoders_answer);
    if (held) runner.keep(inputs.now);
    const auto command = runner.step(inputs, outputs, parameters);
    inputs.commands.clear();
    last = command;
    if (command && follows) {
      for (std::size_t i = 0; i < 2; ++i) {
        const double deg = command->reference_ticks[i] / control::kTicksPerDegree;
        const double turned = deg * control::kEncoderCountsPerDegree * (inverted ? -1.0 : 1.0);
        counts[i] = static_cast<std::uint16_t>(std::lround(turned + zero_counts) & 0xFFF);
      }
    }
    return command.has_value();
  }
  int run(int steps) {
    int moved = 0;
    for (int i = 0; i < steps; ++i) moved += step() ? 1 : 0;
    return moved;
  }
  Result<void> press(DeviceTest test = DeviceTest::motor_1, double stretch_deg = 0.0) {
    held = true;
    return runner.start(test, inputs.now, stretch_deg);
  }
  std::string words() const { return runner.status().words.text(); }

  DeviceTestRunner runner;
  pipeline::Inputs inputs{.now = instantAt(10)};
  pipeline::Outputs outputs;
  control::ControlParameters parameters;
  std::array<std::uint16_t, 2> counts = {300, 3800};
  std::optional<control::MotorCommand> last;
  bool held = false;
  bool encoders_answer = true;
  bool follows = true;
  bool inverted = false;
  double zero_counts = 0.0;
};

TEST(DeviceTestRunner, RunsOnceFromWhereTheMotorsStandAndEndsByItself) {
  Loop loop;
  ASSERT_TRUE(loop.press());
  ASSERT_TRUE(loop.step());
  EXPECT_NEAR(loop.last->reference_ticks[0] / control::kTicksPerDegree, 300 / control::kEncoderCountsPerDegree, 0.05);
  EXPECT_TRUE(loop.last->active);
  EXPECT_TRUE(loop.runner.status().running);
  EXPECT_NEAR(loop.run(10'000), 4500, 3) << "then nothing more, although the button is still held";
  EXPECT_EQ(loop.words(), "finished");
  EXPECT_FALSE(loop.runner.status().running);
  EXPECT_FALSE(loop.step());
}

TEST(DeviceTestRunner, EverySignOfTroubleEndsItAtOnceAndForGood) {
  struct Trouble {
    const char* words;
    std::function<void(Loop&)> make;
  };
  const std::vector<Trouble> kTroubles = {
      {"released", [](Loop& l) { l.runner.stop(); }},
      {"stopped or armed", [](Loop& l) { (void)l.inputs.commands.push({.action = OperatorAction::stop}); }},
      {"stopped or armed", [](Loop& l) { (void)l.inputs.commands.push({.action = OperatorAction::arm}); }},
      {"state changed", [](Loop& l) { l.outputs.telemetry.state = SafetyState::connected; }},
      {"state changed", [](Loop& l) { l.outputs.telemetry.state = SafetyState::stopped; }},
      {"do not answer", [](Loop& l) { l.encoders_answer = false; }},
      {"stood still", [](Loop& l) { l.inputs.now += std::chrono::milliseconds(25); }},
      {"stood still", [](Loop& l) { l.inputs.now -= std::chrono::milliseconds(25); }},
      {"did not follow",
       [](Loop& l) {
         l.follows = false;
         l.counts[0] += 512;
       }},
      {"did not follow", [](Loop& l) { l.counts[1] = 5000; }},
  };
  for (const Trouble& trouble : kTroubles) {
    Loop loop;
    ASSERT_TRUE(loop.press());
    ASSERT_EQ(loop.run(1000), 1000);
    trouble.make(loop);
    EXPECT_FALSE(loop.step()) << trouble.words;
    EXPECT_THAT(loop.words(), HasSubstr(trouble.words));
    loop.encoders_answer = true;
    EXPECT_EQ(loop.run(1000), 0) << trouble.words << ": never again by itself";
  }
}

TEST(DeviceTestRunner, AButtonThatIsNoLongerHeardOfEndsItWithinHalfASecond) {
  Loop loop;
  ASSERT_TRUE(loop.press());
  ASSERT_EQ(loop.run(1000), 1000);
  loop.held = false;
  EXPECT_EQ(loop.run(2000), 500);
  EXPECT_THAT(loop.words(), HasSubstr("released"));
}

TEST(DeviceTestRunner, IsRefusedWhileTheSessionHoldsTheMotors) {
  for (const SafetyState state : {SafetyState::active, SafetyState::held, SafetyState::disconnected}) {
    Loop loop;
    loop.outputs.telemetry.state = state;
    loop.step();
    const auto refused = loop.press();
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("stop the session first"));
    EXPECT_EQ(loop.run(100), 0);
  }
  Loop loop;
  loop.encoders_answer = false;
  loop.step();
  EXPECT_THAT(loop.press().error().text(), HasSubstr("do not answer"));
}

TEST(DeviceTestRunner, APressThatComesTooLateMovesNothing) {
  Loop loop;
  ASSERT_TRUE(loop.press());
  loop.outputs.telemetry.state = SafetyState::active;  // armed between the press and the next step
  loop.outputs.motors.active = true;
  EXPECT_EQ(loop.run(10), 0);
  EXPECT_THAT(loop.words(), HasSubstr("in use"));
}

TEST(DeviceTestRunner, BeforeTheFirstStepNothingMayMove) {
  DeviceTestRunner runner;
  EXPECT_FALSE(runner.start(DeviceTest::motor_1, instantAt(1)));
  EXPECT_EQ(runner.status().words.text(), "");
}

TEST(DeviceTestRunner, AMotorBeyondItsLimitIsNotMoved) {
  Loop loop;
  loop.parameters.motor_limit_deg = 20.0;
  ASSERT_TRUE(loop.press());
  EXPECT_EQ(loop.run(10), 0);
  EXPECT_THAT(loop.words(), HasSubstr("motor_limit_deg"));
}

TEST(DeviceTestRunner, AStretchIsHeldAsLongAsTheButtonAndNoLonger) {
  Loop loop;
  ASSERT_TRUE(loop.press(DeviceTest::stretch, 45.0));
  EXPECT_EQ(loop.run(8000), 8000);
  EXPECT_TRUE(loop.runner.status().resting);
  EXPECT_NEAR(loop.runner.status().commanded_deg[0], 45.0, 1e-9);
  EXPECT_NEAR(loop.runner.status().commanded_deg[1], -45.0, 1e-9);
  loop.runner.stop();
  EXPECT_FALSE(loop.step());
  EXPECT_FALSE(loop.runner.status().resting);
  for (const double beyond : {19.0, 91.0}) {
    ASSERT_TRUE(loop.press(DeviceTest::stretch, beyond));
    EXPECT_EQ(loop.run(10), 0) << beyond;
    EXPECT_THAT(loop.words(), HasSubstr("travel_maximum_deg"));
  }
  EXPECT_FALSE(loop.press(DeviceTest::stretch, std::nan("")));
}

TEST(DeviceTestRunner, ASweepBelievesNeitherZeroNorSignButNeedsAMotorThatTurns) {
  for (const bool inverted : {false, true}) {
    for (const double zero : {0.0, 1500.0, 2048.0, 4090.0}) {
      Loop loop;
      loop.inverted = inverted;
      loop.zero_counts = zero;
      loop.counts.fill(static_cast<std::uint16_t>(zero));
      ASSERT_TRUE(loop.press(DeviceTest::sweep));
      EXPECT_GT(loop.run(20'000), 15'000) << zero << loop.words();
      EXPECT_EQ(loop.words(), "finished");
    }
  }
  Loop stuck;
  stuck.follows = false;
  ASSERT_TRUE(stuck.press(DeviceTest::sweep));
  EXPECT_LT(stuck.run(20'000), 6000) << "within the third step of 5°";
  EXPECT_THAT(stuck.words(), HasSubstr("did not follow"));
  Loop silent;
  ASSERT_TRUE(silent.press(DeviceTest::sweep));
  silent.run(500);
  silent.counts[1] = 5000;
  EXPECT_FALSE(silent.step());
}

TEST(DeviceTestRunner, WhatWouldPassTheMotorsLimitDoesNotBegin) {
  Loop loop;
  loop.counts.fill(0);
  loop.parameters.motor_limit_deg = 25.0;
  for (const DeviceTest test : {DeviceTest::sweep, DeviceTest::stretch}) {
    ASSERT_TRUE(loop.press(test, 30.0));
    EXPECT_EQ(loop.run(10), 0);
    EXPECT_EQ(loop.words(), "the motion goes beyond control.motor_limit_deg");
  }
}

TEST(DeviceTestRunner, ASecondPressEndsTheFirstTest) {
  Loop loop;
  ASSERT_TRUE(loop.press(DeviceTest::motor_1));
  loop.run(1500);
  ASSERT_TRUE(loop.press(DeviceTest::motor_2));
  EXPECT_FALSE(loop.step()) << "the motors are off in between";
  EXPECT_TRUE(loop.step());
  EXPECT_EQ(loop.runner.status().test, DeviceTest::motor_2);
}

/// What an accelerometer on the cloth would read along y.
double swing_g(Instant when) { return 0.2 * std::sin(2.0 * M_PI * 40.0 * toSeconds(when.time_since_epoch())); }

TEST(DeviceTestRunner, AChirpIsSeenAtOneKilohertzThoughAccelerationsComeLateAndStepsAreMissed) {
  Loop loop;
  loop.parameters.travel_minimum_deg = 0.0;
  ASSERT_TRUE(loop.press(DeviceTest::chirp, 30.0));
  std::vector<texture::AccelerationSample> waiting;
  std::vector<texture::SweepRow> rows;
  for (int n = 0; n < 20'000; ++n) {
    const Instant now = loop.inputs.now + kStep;
    waiting.push_back({.taken = now, .acceleration_g = {0.01, 1.0 + swing_g(now), 0.0}});
    loop.inputs.robot.accelerations.clear();
    if (n % 10 == 7) {  // ten at once, the newest 7 ms old
      while (!waiting.empty() && waiting.front().taken + 7 * kStep <= now) {
        (void)loop.inputs.robot.accelerations.push(waiting.front());
        waiting.erase(waiting.begin());
      }
    }
    if (n % 97 == 50) {  // the loop was late
      loop.inputs.now += 2 * kStep;
      waiting.push_back({.taken = now + kStep, .acceleration_g = {0.01, 1.0 + swing_g(now + kStep), 0.0}});
      waiting.push_back({.taken = now + 2 * kStep, .acceleration_g = {0.01, 1.0 + swing_g(now + 2 * kStep), 0.0}});
    }
    (void)loop.step();
    if (n % 1000 == 0) rows = loop.runner.sweep();
  }
  EXPECT_EQ(loop.words(), "finished");
  rows = loop.runner.sweep();
  ASSERT_NEAR(static_cast<double>(rows.size()), 8000.0, 5.0);
  const Instant first = instantAt(10);
  double turns = 0.0;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    ASSERT_EQ(rows[n].part, 1);
    ASSERT_NEAR(rows[n].stretch_deg, 30.0, 0.1);
    ASSERT_NEAR(rows[n].t_s - rows[0].t_s, 1e-3 * static_cast<double>(n), 1e-9);
    ASSERT_LE(std::abs(rows[n].duty_percent[0]), 90.0);
    ASSERT_EQ(rows[n].duty_percent[0], rows[n].duty_percent[1]);
    // The test began at the step after the press, 1 ms after the first.
    const Instant when = first + 2 * kStep + fromSeconds(rows[n].t_s);
    ASSERT_NEAR(rows[n].acceleration_g - 1.0, swing_g(when), 2e-3) << n;
    turns += n > 0 && rows[n].duty_percent[0] * rows[n - 1].duty_percent[0] < 0.0 ? 0.5 : 0.0;
  }
  EXPECT_NEAR(turns, 8.0 * (8.0 + 350.0) / 2.0, 40.0) << "8 to 350 Hz in 8 s, less what the missed steps held";
}

TEST(DeviceTestRunner, BreakawayRampsEachMotorBothWaysAndMovesNoReference) {
  Loop loop;
  ASSERT_TRUE(loop.press(DeviceTest::breakaway));
  ASSERT_TRUE(loop.step());
  const auto rest = loop.last->reference_ticks;
  std::array<double, 2> most{}, least{};
  while (loop.last) {
    ASSERT_EQ(loop.last->reference_ticks, rest);
    const auto& duty = loop.last->vibration_duty_percent;
    ASSERT_EQ(duty[0] * duty[1], 0.0) << "one motor at a time";
    for (std::size_t i = 0; i < 2; ++i) {
      most[i] = std::max(most[i], duty[i]);
      least[i] = std::min(least[i], duty[i]);
    }
    (void)loop.step();
  }
  EXPECT_EQ(loop.words(), "finished");
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(most[i], device::kRampTop_percent, 0.01);
    EXPECT_NEAR(least[i], -device::kRampTop_percent, 0.01);
  }
  // Seen rarely: what is left is still whole rows of one experiment each.
  for (const texture::SweepRow& row : loop.runner.sweep()) ASSERT_TRUE(row.part >= 1 && row.part <= 4);
}

TEST(DeviceTestRunner, AChirpBeyondTheTravelIsRefused) {
  Loop loop;
  ASSERT_TRUE(loop.press(DeviceTest::chirp, loop.parameters.travel_maximum_deg + 1.0));
  EXPECT_FALSE(loop.step());
  EXPECT_THAT(loop.words(), HasSubstr("travel"));
}

}  // namespace
}  // namespace fyd::station
