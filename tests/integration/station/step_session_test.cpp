// The pure step closed over the simulated touchpad in virtual time: whole sessions, and every way into Held.
#include <gtest/gtest.h>

#include "core/sim/touchpad/lockstep.h"

namespace fyd {
namespace {

using pipeline::Fault;
using pipeline::OperatorAction;
using pipeline::SafetyState;
using sim::Lockstep;
using sim::LockstepOptions;

void arm(Lockstep& session) { (void)session.next.commands.push({.action = OperatorAction::arm}); }

/// Active, the finger pressing 6 mm in the middle.
std::unique_ptr<Lockstep> activeSession(const LockstepOptions& options = {}) {
  auto session = std::make_unique<Lockstep>(options);
  session->run(0.5);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::ready);
  arm(*session);
  session->run(0.5);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::active);
  return session;
}

TEST(StepSession, ThePressedClothTakesTheRobotsStiffness) {
  LockstepOptions options;
  options.robot_stiffness_N_per_mm = 0.65;
  auto session = activeSession(options);
  session->run(2.0);
  EXPECT_NEAR(session->world().truth().stiffness_N_per_mm, 0.65, 0.02 * 0.65);
  const auto& telemetry = session->outputs().telemetry;
  EXPECT_NEAR(telemetry.indentation_mm, 6.0, 0.6);
  EXPECT_NEAR(telemetry.stiffness_N_per_mm, 0.65, 0.1 * 0.65);
  EXPECT_NEAR(telemetry.force_N, 6.0 * 0.65, 0.2);
  EXPECT_LT(session->outputs().touch.position_mm.z, -4.0);
}

/// The robot feels another stiffness from now on, at a place.
void feel(Lockstep& session, double stiffness_N_per_mm, double x_mm) {
  session.spoil = [stiffness_N_per_mm, x_mm](pipeline::Inputs& in) {
    in.robot.state.value.stiffness_N_per_mm = stiffness_N_per_mm;
    in.robot.state.value.position_mm.x = x_mm;
  };
}

TEST(StepSession, AClothThatIsPressedStiffensOnlyWhereTheRobotHasMovedOn) {
  LockstepOptions options;
  options.robot_stiffness_N_per_mm = 0.60;
  auto session = activeSession(options);
  session->run(1.0);
  feel(*session, 0.70, 0.0);
  session->run(1.5);
  const auto& telemetry = session->outputs().telemetry;
  EXPECT_EQ(telemetry.robot_stiffness_N_per_mm, 0.70);
  EXPECT_EQ(telemetry.target_N_per_mm, 0.60);
  EXPECT_NEAR(session->world().truth().stiffness_N_per_mm, 0.60, 0.02);
  feel(*session, 0.70, 5.0);
  session->run(1.5);
  EXPECT_NEAR(session->world().truth().stiffness_N_per_mm, 0.70, 0.02);
  feel(*session, 0.60, 5.0);
  session->run(1.5);
  EXPECT_NEAR(session->world().truth().stiffness_N_per_mm, 0.60, 0.02);
}

TEST(StepSession, TheOperatorsOwnTargetIsNotCoupled) {
  LockstepOptions options;
  options.robot_stiffness_N_per_mm = 0.60;
  auto session = activeSession(options);
  (void)session->next.commands.push({.action = OperatorAction::target_by_hand, .value = 0.70});
  session->run(0.1);
  EXPECT_EQ(session->outputs().telemetry.target_N_per_mm, 0.70);
  feel(*session, 0.65, 0.0);
  session->run(0.1);
  (void)session->next.commands.push({.action = OperatorAction::target_from_robot});
  session->run(0.1);
  EXPECT_EQ(session->outputs().telemetry.target_N_per_mm, 0.65) << "what the robot feels when it is asked for";
}

TEST(StepSession, DirectFollowsTheRobotUnderTheFinger) {
  LockstepOptions options;
  options.parameters.step.coupling = teleop::TouchpadCouplingChoice::direct;
  options.robot_stiffness_N_per_mm = 0.60;
  auto session = activeSession(options);
  feel(*session, 0.70, 0.0);
  session->run(0.002);
  EXPECT_EQ(session->outputs().telemetry.target_N_per_mm, 0.70);
}

TEST(StepSession, TheEnergyOfATouchIsThatOfTheSimulatedFinger) {
  LockstepOptions options;
  const auto at = [](double t, double depth) {
    return sim::FingerPath::Knot{t, {.x_mm = 0, .y_mm = 0, .indentation_mm = depth, .lifted = depth <= 0}};
  };
  options.finger = sim::FingerPath::fromKnots({at(0, 0), at(1.5, 0), at(1.501, 0.01), at(2.0, 6), at(4.0, 6)});
  options.draw_pictures = false;
  auto session = activeSession(options);
  double energy_mJ = 0.0, last_mm = 0.0, last_N = 0.0;
  session->run(1.0, [&](const pipeline::Outputs&) {
    const auto truth = session->world().truth();
    const double depth_mm = truth.finger.lifted ? 0.0 : truth.finger.indentation_mm;
    energy_mJ += 0.5 * (truth.force_N + last_N) * (depth_mm - last_mm);
    last_mm = depth_mm;
    last_N = truth.force_N;
  });
  EXPECT_GT(energy_mJ, 5.0);
  EXPECT_NEAR(session->outputs().telemetry.finger_energy_mJ, energy_mJ, 0.15 * energy_mJ);
}

TEST(StepSession, ItStartsDisconnectedAndArmsOnlyWhenAsked) {
  Lockstep session{LockstepOptions{}};
  session.run(3.0, [](const pipeline::Outputs& outputs) {
    ASSERT_NE(outputs.telemetry.state, SafetyState::active);
    ASSERT_FALSE(outputs.motors.active);
    ASSERT_EQ(outputs.motors.vibration_duty_percent[0], 0.0);
  });
  EXPECT_EQ(session.outputs().telemetry.state, SafetyState::ready);
}

TEST(StepSession, ACameraThatIsBlackFromTheStartIsNeverReady) {
  Lockstep session{LockstepOptions{}};
  session.spoil = [](pipeline::Inputs& in) {
    in.finger.value = {};
    in.finger.value.reason = sensing::FingerReason::black_picture;
  };
  arm(session);
  session.run(1.0, [](const pipeline::Outputs& outputs) {
    ASSERT_NE(outputs.telemetry.state, SafetyState::ready);
    ASSERT_NE(outputs.telemetry.state, SafetyState::active);
  });
  EXPECT_EQ(session.outputs().telemetry.fault, Fault::camera_blind);
}

TEST(StepSession, AShortFlatPictureIsBorne) {
  auto session = activeSession();
  session->spoil = [](pipeline::Inputs& in) { in.finger.value.reason = sensing::FingerReason::flat_picture; };
  session->run(0.2);
  session->spoil = {};
  session->run(1.0);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::active);
}

TEST(StepSession, AFlatPictureIsNoUntouchedClothToTareOn) {
  LockstepOptions options;
  options.finger = sim::FingerPath::constant(0, 0, 0);
  Lockstep session{options};
  session.run(0.5);
  session.spoil = [](pipeline::Inputs& in) {
    in.finger.value = {};
    in.finger.value.reason = sensing::FingerReason::flat_picture;
  };
  (void)session.next.commands.push({.action = OperatorAction::tare});
  int failed = 0;
  session.run(8.0, [&](const pipeline::Outputs& outputs) {
    for (const pipeline::Event& event : outputs.events) {
      ASSERT_NE(event.kind, pipeline::EventKind::tare_done);
      failed += event.kind == pipeline::EventKind::tare_failed ? 1 : 0;
    }
  });
  EXPECT_EQ(failed, 1);
}

TEST(StepSession, ALiftedFingerIsNoFault) {
  LockstepOptions options;
  options.finger = sim::FingerPath::constant(0, 0, 0);
  auto session = activeSession(options);
  session->run(3.0);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::active);
  EXPECT_FALSE(session->outputs().touch.in_contact);
}

struct Spoiling {
  const char* name;
  std::function<void(pipeline::Inputs&)> spoil;
  Fault fault;
  double within_s;
};

class EveryFault : public testing::TestWithParam<Spoiling> {};

TEST_P(EveryFault, HoldsLatchesAndLeavesOnlyByTheOperator) {
  auto session = activeSession();
  // The robot asks for another stiffness all the while: whatever is not frozen moves.
  feel(*session, 0.70, 5.0);
  session->run(0.02);
  ASSERT_EQ(session->outputs().telemetry.state, SafetyState::active);
  session->spoil = [asks = session->spoil](pipeline::Inputs& in) {
    asks(in);
    GetParam().spoil(in);
  };
  const double most_ticks =
      1e-3 * session->pipeline().parameters().control.rate_limit_deg_per_s * control::kTicksPerDegree + 1.0;  // rounded
  auto before = session->outputs().motors.reference_ticks;
  bool held = false;
  session->run(GetParam().within_s, [&](const pipeline::Outputs& outputs) {
    const auto told = outputs.motors.reference_ticks;
    held = held || outputs.telemetry.state == SafetyState::held;
    for (std::size_t i = 0; i < told.size(); ++i) {
      ASSERT_LE(std::abs(told[i] - before[i]), held ? 0.0 : most_ticks) << i << ", held " << held;
    }
    before = told;
  });
  ASSERT_TRUE(held);
  ASSERT_EQ(session->outputs().telemetry.state, SafetyState::held);
  EXPECT_EQ(session->outputs().telemetry.fault, GetParam().fault);
  const auto frozen = session->outputs().motors.reference_ticks;

  arm(*session);  // refused while the fault lasts
  session->run(0.2, [&](const pipeline::Outputs& outputs) {
    ASSERT_EQ(outputs.motors.vibration_duty_percent[0], 0.0);
    ASSERT_EQ(outputs.motors.reference_ticks, frozen);
    ASSERT_EQ(outputs.telemetry.state, SafetyState::held);
  });

  feel(*session, 0.80, 10.0);
  session->run(2.0, [&](const pipeline::Outputs& outputs) {  // healthy again, and still held
    ASSERT_EQ(outputs.motors.reference_ticks, frozen);
    ASSERT_EQ(outputs.telemetry.state, SafetyState::held);
  });
  arm(*session);
  session->run(0.1);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::active);
  EXPECT_GT(session->outputs().motors.reference_ticks[0] - frozen[0], 50) << "what was asked is followed now";
}

template <class T>
void freeze(Timed<T>& input) {
  input.taken = instantAt(1001.0);
}

INSTANTIATE_TEST_SUITE_P(
    StepSession, EveryFault,
    testing::Values(
        Spoiling{"motors", [](pipeline::Inputs& in) { freeze(in.motors); }, Fault::motors_stale, 0.1},
        Spoiling{"ir", [](pipeline::Inputs& in) { freeze(in.ir); }, Fault::ir_stale, 0.2},
        Spoiling{"ir_out_of_span", [](pipeline::Inputs& in) { in.ir.value.items.fill(4095); }, Fault::ir_invalid, 0.4},
        Spoiling{"bridge", [](pipeline::Inputs& in) { freeze(in.bridge); }, Fault::bridge_stale, 0.2},
        Spoiling{
            "bridge_nan",
            [](pipeline::Inputs& in) { in.bridge.value.value_mV_per_V = std::numeric_limits<double>::quiet_NaN(); },
            Fault::bridge_invalid, 0.4},
        Spoiling{"bridge_at_its_converters_end", [](pipeline::Inputs& in) { in.bridge.value.value_mV_per_V = 7.77; },
                 Fault::bridge_invalid, 0.4},
        Spoiling{"bridge_beyond_its_cell", [](pipeline::Inputs& in) { in.bridge.value.value_mV_per_V = -3.0; },
                 Fault::bridge_invalid, 0.4},
        Spoiling{"camera_unplugged", [](pipeline::Inputs& in) { freeze(in.finger); }, Fault::camera_stale, 0.4},
        Spoiling{"camera_black",
                 [](pipeline::Inputs& in) {
                   in.finger.value = {};
                   in.finger.value.reason = sensing::FingerReason::black_picture;
                 },
                 Fault::camera_blind, 0.6},
        Spoiling{"camera_flat",
                 [](pipeline::Inputs& in) {
                   in.finger.value = {};
                   in.finger.value.reason = sensing::FingerReason::flat_picture;
                 },
                 Fault::camera_blind, 0.6},
        Spoiling{"robot_lost", [](pipeline::Inputs& in) { in.robot.phase = pipeline::LinkPhase::lost; },
                 Fault::robot_lost, 0.02},
        Spoiling{"robot_closed", [](pipeline::Inputs& in) { in.robot.phase = pipeline::LinkPhase::closed; },
                 Fault::robot_closed, 0.02},
        Spoiling{"robot_nan",
                 [](pipeline::Inputs& in) {
                   in.robot.state.value.stiffness_N_per_mm = std::numeric_limits<double>::quiet_NaN();
                 },
                 Fault::robot_frozen, 0.02}),
    [](const auto& fault) { return std::string(fault.param.name); });

TEST(StepSession, TwentyMillisecondsWithoutAStepHold) {
  auto session = activeSession();
  session->spoil = [](pipeline::Inputs& in) { in.now += std::chrono::milliseconds(18); };
  session->step();
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::active) << "19 ms are borne";
  session->spoil = [](pipeline::Inputs& in) { in.now += std::chrono::milliseconds(38); };
  session->step();
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::held);
  EXPECT_EQ(session->outputs().telemetry.fault, Fault::step_gap);
}

TEST(StepSession, MoreThanFivePercentMissedHolds) {
  auto session = activeSession();
  session->next.missed_cycles += 40;
  session->run(0.5);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::active);
  session->next.missed_cycles += 60;
  session->run(0.01);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::held);
  EXPECT_EQ(session->outputs().telemetry.fault, Fault::steps_missed);
}

TEST(StepSession, StopIsImmediateAndLatches) {
  auto session = activeSession();
  (void)session->next.commands.push({.action = OperatorAction::stop});
  (void)session->next.commands.push({.action = OperatorAction::arm});  // stop wins over an arm of the same step
  session->step();
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::stopped);
  EXPECT_FALSE(session->outputs().motors.active);
  session->run(2.0);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::stopped);
}

TEST(StepSession, AWindowThatFallsSilentHoldsAndSaysSo) {
  auto session = activeSession();
  (void)session->next.commands.push({.action = OperatorAction::fell_silent});
  (void)session->next.commands.push({.action = OperatorAction::arm});  // nobody would take this one back
  session->step();
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::held);
  EXPECT_EQ(session->outputs().telemetry.fault, Fault::operator_silent);
  session->run(2.0);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::held);
  (void)session->next.commands.push({.action = OperatorAction::arm});
  session->run(0.01);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::active);
  (void)session->next.commands.push({.action = OperatorAction::stop});
  session->run(0.01);
  (void)session->next.commands.push({.action = OperatorAction::fell_silent});  // nothing moves: nothing to hold
  session->run(0.01);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::stopped);
}

TEST(StepSession, APauseOfTheRobotIsNoFaultAndIsSilent) {
  auto session = activeSession();
  session->next.robot.phase = pipeline::LinkPhase::paused;
  session->run(1.0, [](const pipeline::Outputs& outputs) { ASSERT_EQ(outputs.motors.vibration_duty_percent[0], 0.0); });
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::active);
}

TEST(StepSession, TheRobotsKeysChangeVibrationAndMethod) {
  auto session = activeSession();
  (void)session->next.robot.commands.push(pipeline::RobotCommand::vibration_up);
  (void)session->next.robot.commands.push(pipeline::RobotCommand::use_soc);
  session->step();
  EXPECT_NEAR(session->pipeline().parameters().texture.k_vib, 1.1, 1e-12);
  EXPECT_EQ(session->pipeline().parameters().texture.method, texture::MethodChoice::soc);
  for (int i = 0; i < 40; ++i) {
    (void)session->next.robot.commands.push(pipeline::RobotCommand::vibration_down);
    session->step();
  }
  EXPECT_EQ(session->pipeline().parameters().texture.k_vib, 0.0);
}

TEST(StepSession, TheRobotMaySetTheMotorReferencesWithinTheLimits) {
  auto session = activeSession();
  (void)session->next.robot.commands.push(pipeline::RobotCommand::motor_reference_on);
  session->next.robot.motor_reference.set({32000.0, -32000.0}, session->next.now);
  session->run(2.0);
  const auto& parameters = session->pipeline().parameters();
  EXPECT_NEAR(session->outputs().telemetry.stretch_reference_deg, parameters.control.travel_maximum_deg, 1e-9);
  (void)session->next.robot.commands.push(pipeline::RobotCommand::motor_reference_off);
  session->run(2.0);
  EXPECT_LT(session->outputs().telemetry.stretch_reference_deg, parameters.control.travel_maximum_deg);
}

TEST(StepSession, ATareRemovesAWrongZero) {
  LockstepOptions options;
  options.finger = sim::FingerPath::constant(0, 0, 0);
  options.sim.cloth_height_mm = 97.0;
  options.sim.bridge_offset_mV_per_V = 0.05;
  Lockstep session{options};
  session.run(0.5);
  EXPECT_GT(std::abs(session.outputs().telemetry.force_N), 0.2);
  (void)session.next.commands.push({.action = OperatorAction::tare});
  bool done = false;
  session.run(5.0, [&done](const pipeline::Outputs& outputs) {
    for (const pipeline::Event& event : outputs.events) done = done || event.kind == pipeline::EventKind::tare_done;
  });
  ASSERT_TRUE(done);
  EXPECT_NEAR(session.outputs().telemetry.force_N, 0.0, 0.05);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(session.pipeline().parameters().sensing.indentation.ir_offset_mm[i], 97.0, 0.5);
  }
}

TEST(StepSession, ATareUnderAFingerIsRefused) {
  auto session = activeSession();
  (void)session->next.commands.push({.action = OperatorAction::tare});
  bool failed = false;
  session->run(1.0, [&failed](const pipeline::Outputs& outputs) {
    for (const pipeline::Event& event : outputs.events)
      failed = failed || event.kind == pipeline::EventKind::tare_failed;
  });
  EXPECT_TRUE(failed);
}

struct FeltTexture {
  double loudest_percent = 0.0;
  double estimated_g = 0.0;  // RMS while the finger touches
  double simulated_g = 0.0;  // of the simulated way to the finger, which shares no formula with the estimate
};

FeltTexture feltWithoutARobot(texture::PwmChoice mapping) {
  LockstepOptions options;
  options.parameters.texture.pwm = mapping;
  options.robot_stiffness_N_per_mm = std::numeric_limits<double>::quiet_NaN();
  options.local.surface =
      texture::SurfaceModel{.name = "test", .bands = {{.wavelength_mm = 0.5, .quality = 2.0, .rms_g = 0.2}}};
  options.finger = sim::FingerPath::demonstration();
  Lockstep session(options);
  session.run(0.5);
  arm(session);
  FeltTexture out;
  double estimated = 0.0, simulated = 0.0;
  int samples = 0;
  session.run(12.0, [&](const pipeline::Outputs& outputs) {
    out.loudest_percent = std::max(out.loudest_percent, std::abs(outputs.motors.vibration_duty_percent[0]));
    if (outputs.telemetry.state != SafetyState::active || !outputs.telemetry.contact) return;
    estimated += outputs.telemetry.felt_acceleration_g * outputs.telemetry.felt_acceleration_g;
    simulated += session.world().truth().felt_g * session.world().truth().felt_g;
    ++samples;
  });
  EXPECT_EQ(session.outputs().telemetry.state, SafetyState::active);
  EXPECT_GT(samples, 1000);
  out.estimated_g = std::sqrt(estimated / samples);
  out.simulated_g = std::sqrt(simulated / samples);
  return out;
}

TEST(StepSession, WithoutARobotAStoredSurfaceIsFeltWhileTheFingerMoves) {
  const FeltTexture felt = feltWithoutARobot(texture::PwmChoice::felt);
  EXPECT_GT(felt.loudest_percent, 25.0);
  EXPECT_GT(felt.simulated_g, texture::kFeltThreshold_g);
  EXPECT_LT(std::abs(20.0 * std::log10(felt.simulated_g / felt.estimated_g)), 3.0);
  EXPECT_GT(felt.simulated_g, 2.0 * feltWithoutARobot(texture::PwmChoice::symmetric).simulated_g);
}

TEST(StepSession, TwoSessionsOfOneSeedAreEqual) {
  const auto run = [] {
    LockstepOptions options;
    options.finger = sim::FingerPath::demonstration();
    auto session = activeSession(options);
    session->run(3.0);
    return session->outputs().telemetry;
  };
  const auto first = run();
  const auto second = run();
  for (const pipeline::TelemetryField& field : pipeline::telemetryFields()) {
    const double a = field.read(first);
    const double b = field.read(second);
    EXPECT_TRUE(a == b || (std::isnan(a) && std::isnan(b))) << field.name;
  }
}

// The robot that comes back stands where the touch left it: anything else would move it with nobody's finger behind it.
TEST(StepSession, ARobotThatComesBackFindsTheTouchAsItLeftIt) {
  using pipeline::LinkPhase;
  auto session = activeSession();
  session->run(1.0);
  LinkPhase phase = LinkPhase::running;
  session->spoil = [&phase](pipeline::Inputs& in) {
    in.robot.phase = phase;
    if (phase == LinkPhase::waiting) in.robot.state = {};
  };
  Vec3 last = session->outputs().touch.position_mm;
  ASSERT_LT(last.z, -4.0);
  const auto stays = [&](LinkPhase next, double seconds) {
    phase = next;
    session->run(seconds, [&](const pipeline::Outputs& outputs) {
      ASSERT_NE(outputs.telemetry.state, SafetyState::active);
      ASSERT_EQ(outputs.touch.position_mm, last);
      ASSERT_FALSE(outputs.touch.in_contact);
    });
  };
  phase = LinkPhase::lost;
  session->run(0.002);
  last = session->outputs().touch.position_mm;
  for (const bool stopped : {false, true}) {
    if (stopped) (void)session->next.commands.push({.action = OperatorAction::stop});
    stays(LinkPhase::lost, 1.5);
    stays(LinkPhase::waiting, 0.1);
    stays(LinkPhase::running, 0.5);
    stays(LinkPhase::closed, 0.5);
    stays(LinkPhase::waiting, 0.1);
    stays(LinkPhase::running, 0.5);
  }
  // Armed again, the finger goes on from there.
  arm(*session);
  session->run(0.005);
  EXPECT_EQ(session->outputs().telemetry.state, SafetyState::active);
  EXPECT_NEAR(session->outputs().touch.position_mm.z, last.z, 1.0);
}

}  // namespace
}  // namespace fyd
