// What the step makes of the safety table: each cause of Held through the inputs that are that cause, what latches, in
// which order events of one step count, and what the motors and the robot are told meanwhile.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "core/pipeline/pipeline.h"
#include "tests/unit/pipeline/whole_inputs.h"

namespace fyd::pipeline {
namespace {

using enum SafetyState;
using std::chrono::milliseconds;

/// A session whose inputs are whole unless `change` takes something away; a step is 1 ms.
class Session {
 public:
  const Outputs& step(Duration elapsed = milliseconds(1)) {
    now += elapsed;
    makeWhole(inputs, now);
    inputs.robot.phase = LinkPhase::running;
    const double phase = 0.7 * static_cast<double>(++steps);
    (void)inputs.robot.accelerations.push({.taken = now, .acceleration_g = {std::sin(phase), std::cos(phase), 0.2}});
    if (change) change(inputs);
    const Outputs& out = pipeline.step(inputs);
    inputs.commands.clear();
    inputs.robot.accelerations.clear();
    inputs.robot.commands.clear();
    return out;
  }
  const Outputs& run(int steps) {
    const Outputs* out = nullptr;
    for (int i = 0; i < steps; ++i) out = &step();
    return *out;
  }
  const Outputs& give(OperatorAction action, double value = 0.0) {
    (void)inputs.commands.push({.action = action, .value = value});
    return step();
  }
  void arm() {
    change = nullptr;
    run(300);
    give(OperatorAction::arm);
  }
  [[nodiscard]] bool reported(const Outputs& out, EventKind kind, SafetyState state, Fault fault) const {
    return std::ranges::any_of(out.events.view(), [&](const Event& event) {
      return event.kind == kind && event.state == state && event.fault == fault;
    });
  }

  Instant now = instantAt(100.0);
  std::uint64_t steps = 0;
  Inputs inputs;
  std::function<void(Inputs&)> change;
  Pipeline pipeline{Parameters{}};
};

template <class T>
void silence(Timed<T>& input) {
  input.taken = instantAt(100.0);
}

struct Cause {
  Fault fault;
  std::function<void(Inputs&)> change;
  int after_ms = 0;  ///< it may last so long without being one
};

// Ages and grace times are those of StepParameters' defaults, written out a second time.
std::vector<Cause> causes() {
  std::vector<Cause> out;
  const auto old = [](auto member) {  // nothing new since a millisecond before it began
    return [member, last = std::optional<Instant>()](Inputs& in) mutable {
      if (!last) last = in.now - milliseconds(1);
      (in.*member).taken = *last;
    };
  };
  out.push_back({Fault::motors_stale, old(&Inputs::motors), 50});
  out.push_back({Fault::ir_stale, old(&Inputs::ir), 100});
  out.push_back({Fault::bridge_stale, old(&Inputs::bridge), 100});
  out.push_back({Fault::camera_stale, old(&Inputs::finger), 250});
  out.push_back({Fault::bridge_invalid, [](Inputs& in) { in.bridge.value.value_mV_per_V = 1e6; }, 101});
  out.push_back({Fault::ir_invalid, [](Inputs& in) { in.ir.value = {}; }, 101});
  out.push_back({Fault::camera_blind,
                 [](Inputs& in) {
                   in.finger.value.contact = false;
                   in.finger.value.reason = sensing::FingerReason::black_picture;
                 },
                 251});
  out.push_back({Fault::robot_waiting, [](Inputs& in) { in.robot.phase = LinkPhase::waiting; }, 0});
  out.push_back({Fault::robot_lost, [](Inputs& in) { in.robot.phase = LinkPhase::lost; }, 0});
  out.push_back({Fault::robot_closed, [](Inputs& in) { in.robot.phase = LinkPhase::closed; }, 0});
  out.push_back({Fault::robot_frozen,
                 [](Inputs& in) { in.robot.state.value.stiffness_N_per_mm = std::numeric_limits<double>::infinity(); },
                 0});
  return out;
}

TEST(SafetyStep, EachCauseHoldsAtItsTimeFreezesAndLatches) {
  for (Cause& cause : causes()) {
    SCOPED_TRACE(std::string(toString(cause.fault)));
    Session session;
    session.arm();
    ASSERT_EQ(session.step().telemetry.state, active);
    session.run(200);
    bool vibrates = false;
    for (int i = 0; i < 20; ++i) vibrates = vibrates || session.step().motors.vibration_duty_percent[0] != 0.0;
    EXPECT_TRUE(vibrates) << "or that it ends proves nothing";
    session.change = cause.change;
    int lasted_ms = -1;
    control::MotorCommand before;
    const Outputs* out = nullptr;
    do {
      if (out != nullptr) before = out->motors;
      out = &session.step();
      ++lasted_ms;
    } while (out->telemetry.state == active && lasted_ms < 1000);
    EXPECT_EQ(lasted_ms, cause.after_ms);
    EXPECT_EQ(out->telemetry.state, held);
    EXPECT_EQ(out->telemetry.fault, cause.fault);
    EXPECT_TRUE(session.reported(*out, EventKind::state_changed, held, cause.fault));
    if (lasted_ms > 0) {
      EXPECT_EQ(out->motors.reference_ticks, before.reference_ticks) << "at once";
    }
    const control::MotorCommand at_hold = out->motors;
    EXPECT_TRUE(at_hold.active);
    EXPECT_EQ(at_hold.vibration_duty_percent, (std::array<double, 2>{0.0, 0.0}));

    // Refused while it lasts, and what it was is said.
    const Outputs& refused = session.give(OperatorAction::arm);
    EXPECT_EQ(refused.telemetry.state, held);
    EXPECT_TRUE(session.reported(refused, EventKind::arm_refused, held, cause.fault));
    session.run(50);

    // Its end arms nothing and moves nothing.
    session.change = nullptr;
    for (int i = 0; i < 1000; ++i) {
      const Outputs& after = session.step();
      ASSERT_EQ(after.telemetry.state, held);
      ASSERT_EQ(after.telemetry.fault, cause.fault) << "the first cause is kept";
      ASSERT_EQ(after.motors, at_hold);
    }
    EXPECT_EQ(session.give(OperatorAction::arm).telemetry.state, active);
  }
}

TEST(SafetyStep, WithoutAPartItIsNotReadyAndDoesNotArm) {
  for (Cause& cause : causes()) {
    SCOPED_TRACE(std::string(toString(cause.fault)));
    Session session;
    session.change = cause.change;
    session.run(400);
    const Outputs& out = session.give(OperatorAction::arm);
    EXPECT_EQ(out.telemetry.state, connected);
    EXPECT_EQ(out.telemetry.fault, cause.fault);
    EXPECT_TRUE(session.reported(out, EventKind::arm_refused, connected, cause.fault));
    EXPECT_FALSE(out.motors.active);
    session.change = nullptr;
    EXPECT_EQ(session.run(300).telemetry.state, ready) << "by itself";
    session.run(300);
    EXPECT_EQ(session.step().telemetry.state, ready) << "and no further";
  }
}

TEST(SafetyStep, ABadValueThatNeverWasGoodHasNoGrace) {
  Session session;
  session.change = [](Inputs& in) { in.bridge.value.value_mV_per_V = 1e6; };
  const Outputs& out = session.step();
  EXPECT_EQ(out.telemetry.state, connected);
  EXPECT_EQ(out.telemetry.fault, Fault::bridge_invalid);
}

TEST(SafetyStep, TheGraceBeginsAnewWithEachGoodValue) {
  Session session;
  session.arm();
  for (int round = 0; round < 5; ++round) {
    session.change = [](Inputs& in) { in.bridge.value.value_mV_per_V = 1e6; };
    ASSERT_EQ(session.run(80).telemetry.state, active);
    session.change = nullptr;
    ASSERT_EQ(session.run(5).telemetry.state, active);
  }
}

TEST(SafetyStep, AStepThatComesMoreThan20MillisecondsLateHolds) {
  Session session;
  session.arm();
  EXPECT_EQ(session.step(milliseconds(20)).telemetry.state, active);
  const Outputs& out = session.step(milliseconds(20) + std::chrono::nanoseconds(1));
  EXPECT_EQ(out.telemetry.state, held);
  EXPECT_EQ(out.telemetry.fault, Fault::step_gap);
  EXPECT_EQ(session.run(2000).telemetry.state, held);
}

TEST(SafetyStep, MoreThanFiftyMissedCyclesOfOneSecondHold) {
  for (const std::uint64_t missed : {50U, 51U}) {
    Session session;
    session.arm();
    session.run(1000);
    session.inputs.missed_cycles = missed;
    EXPECT_EQ(session.step().telemetry.state, missed > 50 ? held : active);
    EXPECT_EQ(session.step().telemetry.fault, missed > 50 ? Fault::steps_missed : Fault::none);
  }
  // Those of the seconds before do not count.
  Session session;
  session.arm();
  for (int second = 1; second < 5; ++second) {
    session.inputs.missed_cycles += 40;
    EXPECT_EQ(session.run(1100).telemetry.state, active);
  }
}

TEST(SafetyStep, CyclesMissedWhileASecondEndsCountInIt) {
  Session session;
  session.arm();
  ASSERT_EQ(session.steps, 301U);
  session.run(690);
  session.inputs.missed_cycles = 30;
  ASSERT_EQ(session.run(9).telemetry.state, active);
  ASSERT_EQ(session.steps, 1000U);  // the next one ends the second that began with the first
  session.inputs.missed_cycles = 60;
  EXPECT_EQ(session.step().telemetry.fault, Fault::steps_missed);
}

TEST(SafetyStep, CyclesMissedBeforeTheFirstStepDoNotCount) {
  Session session;
  session.inputs.missed_cycles = 1000;
  session.arm();
  EXPECT_EQ(session.run(10).telemetry.state, active);
}

TEST(SafetyStep, ATimeThatRunsBackwardsIsReportedIsNoGapAndBeginsItsSecondAnew) {
  const auto reversed_s = [](const Outputs& out) -> std::optional<double> {
    for (const Event& event : out.events.view())
      if (event.kind == EventKind::time_reversed) return event.value;
    return std::nullopt;
  };
  Session session;
  session.arm();
  EXPECT_FALSE(reversed_s(session.step()));
  EXPECT_FALSE(reversed_s(session.step(milliseconds(0)))) << "twice the same time is none that runs backwards";
  session.inputs.missed_cycles += 40;
  session.step();
  const Outputs& back = session.step(milliseconds(-10'000));
  EXPECT_EQ(reversed_s(back), 10.0);
  EXPECT_EQ(back.telemetry.state, active);
  session.inputs.missed_cycles += 40;
  const Outputs& after = session.step();
  EXPECT_FALSE(reversed_s(after)) << "reported once";
  EXPECT_EQ(after.telemetry.state, active) << "the cycles missed before are not of this second";
  session.run(1100);
  session.inputs.missed_cycles += 40;
  EXPECT_EQ(session.step().telemetry.state, active) << "and this second ends";
  session.inputs.missed_cycles += 40;
  EXPECT_EQ(session.step().telemetry.fault, Fault::steps_missed);
}

TEST(SafetyStep, ALateLoopDoesNotPreventArming) {
  Session session;
  session.run(300);
  (void)session.inputs.commands.push({.action = OperatorAction::arm});
  EXPECT_EQ(session.step(milliseconds(30)).telemetry.state, active);
}

TEST(SafetyStep, TheWindowsSilenceHoldsWhileRenderingAndWinsOverAnArmOfTheSameStep) {
  Session session;
  session.run(300);
  EXPECT_EQ(session.give(OperatorAction::fell_silent).telemetry.state, connected);
  session.run(10);
  (void)session.inputs.commands.push({.action = OperatorAction::arm});
  const Outputs& out = session.give(OperatorAction::fell_silent);
  EXPECT_EQ(out.telemetry.state, held);
  EXPECT_EQ(out.telemetry.fault, Fault::operator_silent);
}

TEST(SafetyStep, StopWinsOverEverythingOfTheSameStep) {
  for (const OperatorAction other : {OperatorAction::arm, OperatorAction::fell_silent}) {
    for (const bool armed : {false, true}) {
      Session session;
      if (armed) {
        session.arm();
      } else {
        session.run(300);
      }
      (void)session.inputs.commands.push({.action = OperatorAction::stop});
      const Outputs& out = session.give(other);
      EXPECT_EQ(out.telemetry.state, stopped);
      EXPECT_FALSE(out.motors.active);
      EXPECT_FALSE(session.reported(out, EventKind::state_changed, active, Fault::none));
      EXPECT_EQ(session.run(500).telemetry.state, stopped) << "latched";
      EXPECT_EQ(session.give(OperatorAction::arm).telemetry.state, active);
    }
  }
}

TEST(SafetyStep, AnArmBesideAStopIsNotAnsweredEvenWhileSomethingIsMissing) {
  Session session;
  session.change = [](Inputs& in) { silence(in.finger); };
  session.run(400);
  (void)session.inputs.commands.push({.action = OperatorAction::arm});
  const Outputs& out = session.give(OperatorAction::stop);
  EXPECT_EQ(out.telemetry.state, stopped);
  EXPECT_TRUE(session.reported(out, EventKind::state_changed, stopped, Fault::none));
  const bool refused =
      std::ranges::any_of(out.events.view(), [](const Event& event) { return event.kind == EventKind::arm_refused; });
  EXPECT_FALSE(refused);
}

TEST(SafetyStep, DisconnectedIsOnlyWhenEveryPartOfTheTouchpadIsSilent) {
  const auto gone = [](bool motors, bool ir, bool bridge) {
    return [=](Inputs& in) {
      if (motors) silence(in.motors);
      if (ir) silence(in.ir);
      if (bridge) silence(in.bridge);
    };
  };
  for (unsigned parts = 0; parts < 8; ++parts) {
    Session session;
    session.run(400);
    ASSERT_EQ(session.step().telemetry.state, ready);
    session.change = gone((parts & 1U) != 0, (parts & 2U) != 0, (parts & 4U) != 0);
    const SafetyState expected = parts == 7 ? disconnected : parts == 0 ? ready : connected;
    EXPECT_EQ(session.step().telemetry.state, expected) << parts;
    EXPECT_FALSE(session.step().motors.active);
  }
  Session session;
  session.arm();
  session.run(400);
  session.change = gone(true, true, true);
  const Outputs& out = session.step();
  EXPECT_EQ(out.telemetry.state, held);
  EXPECT_EQ(out.telemetry.fault, Fault::motors_stale) << "the most urgent of the three";
  session.change = nullptr;
  EXPECT_EQ(session.run(500).telemetry.state, held);
}

TEST(SafetyStep, WithATargetSetByHandARobotIsNotNeededButItsLossHolds) {
  Session session;
  session.change = [](Inputs& in) { in.robot.phase = LinkPhase::waiting; };
  session.run(300);
  session.give(OperatorAction::target_by_hand, 0.6);
  ASSERT_EQ(session.run(2).telemetry.state, ready);
  session.change = nullptr;
  session.run(10);
  session.give(OperatorAction::arm);
  ASSERT_EQ(session.run(10).telemetry.state, active);
  session.change = [](Inputs& in) { in.robot.phase = LinkPhase::lost; };
  const Outputs& out = session.step();
  EXPECT_EQ(out.telemetry.state, held);
  EXPECT_EQ(out.telemetry.fault, Fault::robot_lost);
  session.run(10);
  EXPECT_EQ(session.give(OperatorAction::arm).telemetry.state, active) << "without it";
  EXPECT_EQ(session.run(500).telemetry.state, active) << "that it is still lost is no new loss";
}

TEST(SafetyStep, WithNeitherRobotNorHandThereIsNoTarget) {
  Session session;
  session.change = [](Inputs& in) { in.robot.phase = LinkPhase::none; };
  session.run(300);
  EXPECT_TRUE(session.step().faults.test(static_cast<std::size_t>(Fault::no_target)));
  session.give(OperatorAction::target_by_hand, 0.6);
  EXPECT_FALSE(session.step().faults.any());
  session.give(OperatorAction::target_from_robot);
  EXPECT_TRUE(session.step().faults.test(static_cast<std::size_t>(Fault::no_target)));
}

TEST(SafetyStep, ARefusedTargetByHandLeavesTheTargetWithTheRobot) {
  Session session;
  session.arm();
  ASSERT_DOUBLE_EQ(session.run(2).telemetry.target_N_per_mm, 0.6);  // the robot's
  session.inputs.robot.state.value.stiffness_N_per_mm = 0.6;
  const Outputs& out = session.give(OperatorAction::target_by_hand, 50.0);
  EXPECT_TRUE(std::ranges::any_of(out.events.view(),
                                  [](const Event& event) { return event.kind == EventKind::parameter_refused; }));
  session.change = [](Inputs& in) { in.robot.state.value.stiffness_N_per_mm = 0.45; };
  EXPECT_NEAR(session.run(2000).telemetry.target_N_per_mm, 0.45, 1e-6);
  session.change = [](Inputs& in) { in.robot.phase = LinkPhase::waiting; };
  EXPECT_EQ(session.step().telemetry.fault, Fault::robot_waiting) << "the robot is still needed";
}

TEST(SafetyStep, WhyItWentToHeldIsReportedBesideAsManyKeysAndCommandsAsAStepTakes) {
  Session session;
  session.arm();
  session.run(10);
  for (std::size_t i = 0; i < kMaximumCommandsPerStep; ++i) {
    (void)session.inputs.robot.commands.push(i % 2 == 0 ? RobotCommand::use_soc : RobotCommand::use_dft321);
    (void)session.inputs.commands.push({.action = OperatorAction::target_by_hand, .value = 0.6});
    (void)session.inputs.changes.push({.index = 0xFFFF, .value = 0.0});
  }
  const Outputs& out = session.step(milliseconds(30));
  EXPECT_EQ(out.telemetry.state, held);
  EXPECT_TRUE(session.reported(out, EventKind::state_changed, held, Fault::step_gap));
}

TEST(SafetyStep, TheFactorOfAPlaceEndsWithContactMode) {
  // Two sessions with the same finger beside the middle: in one the mode was contact before.
  const auto parameter = [](std::string_view id) {
    Parameters parameters;
    const auto bound = bindParameters(parameters);
    return static_cast<std::uint16_t>(findParameter(bound, id) - bound.data());
  };
  const auto reachable = [&](bool was_contact) {
    Session session;
    session.change = [](Inputs& in) {
      in.finger.value.x_mm = 25.0;
      in.bridge.value.value_mV_per_V = 0.0;  // no force: nothing is learned of the cloth, and the law alone drives
      in.robot.state.value.stiffness_N_per_mm = 3.0;  // out of reach: what is reachable tells the factor
    };
    const auto mode = [&](sensing::IndentationMode value) {
      session.inputs.changes.clear();
      (void)session.inputs.changes.push(
          {.index = parameter("sensing.indentation_mode"), .value = static_cast<double>(value)});
      session.step();
      session.inputs.changes.clear();
    };
    mode(was_contact ? sensing::IndentationMode::contact : sensing::IndentationMode::membrane);
    session.run(300);
    session.give(OperatorAction::arm);
    session.run(500);
    mode(sensing::IndentationMode::membrane);
    return session.run(10).telemetry;
  };
  const TelemetrySample after = reachable(true), alone = reachable(false);
  ASSERT_EQ(after.state, active);
  ASSERT_EQ(alone.state, active);
  ASSERT_TRUE(alone.target_clamped);
  EXPECT_NEAR(after.reachable_target_N_per_mm, alone.reachable_target_N_per_mm, 1e-9);
}

TEST(SafetyStep, WhatNeverCameOrComesFromTheFutureIsMissing) {
  for (const bool future : {false, true}) {
    Session session;
    session.change = [future](Inputs& in) {
      if (future) {
        in.motors.taken = in.now + milliseconds(2);
      } else {
        in.motors = {};
      }
    };
    session.run(300);
    const Outputs& out = session.step();
    EXPECT_TRUE(out.faults.test(static_cast<std::size_t>(Fault::motors_stale))) << future;
    EXPECT_EQ(out.telemetry.state, connected);
  }
}

TEST(SafetyStep, APauseOfTheRobotsIsNoFaultAndMovesNothing) {
  Session session;
  session.arm();
  session.run(300);
  session.change = [](Inputs& in) { in.robot.phase = LinkPhase::paused; };
  const control::MotorCommand before = session.step().motors;
  const Vec3 touch_mm = session.step().touch.position_mm;
  for (int i = 0; i < 300; ++i) {
    const Outputs& out = session.step();
    ASSERT_EQ(out.telemetry.state, active);
    ASSERT_EQ(out.motors.vibration_duty_percent, (std::array<double, 2>{0.0, 0.0}));
    ASSERT_EQ(out.motors.reference_ticks, before.reference_ticks);
    ASSERT_EQ(out.touch.position_mm, touch_mm);
  }
}

TEST(SafetyStep, TheMotorsAreOnInActiveAndHeldOnly) {
  Session session;
  session.change = [](Inputs& in) {
    silence(in.motors);
    silence(in.ir);
    silence(in.bridge);
  };
  const auto is = [&](SafetyState state, bool on) {
    const Outputs& out = session.step();
    EXPECT_EQ(out.telemetry.state, state);
    EXPECT_EQ(out.motors.active, on) << toString(state);
  };
  session.run(300);
  is(disconnected, false);
  session.change = [](Inputs& in) { in.robot.phase = LinkPhase::waiting; };
  session.run(300);
  is(connected, false);
  session.arm();
  is(active, true);
  session.give(OperatorAction::fell_silent);
  is(held, true);
  session.give(OperatorAction::stop);
  is(stopped, false);
}

TEST(SafetyStep, ANumberThatIsNoActionOrCommandIsReportedAtMostAndChangesNothing) {
  // A recording of a later program may hold some.
  Session session;
  session.arm();
  const Parameters before = session.pipeline.parameters();
  (void)session.inputs.commands.push({.action = static_cast<OperatorAction>(200), .value = 5.0});
  (void)session.inputs.robot.commands.push(static_cast<RobotCommand>(200));
  EXPECT_EQ(session.step().telemetry.state, active);
  EXPECT_EQ(session.step().faults, FaultSet{});
  EXPECT_EQ(session.pipeline.parameters().texture.k_vib, before.texture.k_vib);
  EXPECT_EQ(session.pipeline.parameters().step.hand_target_N_per_mm, before.step.hand_target_N_per_mm);
  EXPECT_TRUE(Pipeline::parameterOf(static_cast<RobotCommand>(200)).empty());
  EXPECT_TRUE(Pipeline::parameterOf(RobotCommand::resume).empty()) << "a command that sets none";
}

}  // namespace
}  // namespace fyd::pipeline
