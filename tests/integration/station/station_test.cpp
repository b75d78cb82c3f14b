// The station with its threads, on real sockets. Nothing here depends on how fast the machine is, only on the order
// of events; a wait ends as soon as its condition holds.
#include "core/station/station.h"

#include <atomic>
#include <functional>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/robot/robot_runner.h"
#include "core/protocol/udp_socket.h"
#include "core/sim/robot/robot_arm.h"
#include "core/station/touchpad_thread.h"
#include "tests/temporary_folder.h"
#include "tests/wait.h"

namespace fyd::station {
namespace {

using pipeline::OperatorAction;
using pipeline::SafetyState;

using Sample = pipeline::TelemetrySample;
using Enough = std::function<bool(const Sample&)>;

/// Drains telemetry until `enough` says so.
testing::AssertionResult waitFor(Station& station, std::string_view what, const Enough& enough,
                                 Duration patience = kPatience) {
  std::vector<Sample> batch(1000);
  Sample last;
  const auto drained = [&] {
    const std::size_t taken = station.takeTelemetry(batch);
    for (std::size_t i = 0; i < taken; ++i) {
      last = batch[i];
      if (enough(last)) return true;
    }
    return false;
  };
  auto found = comesTrue(what, drained, patience);
  if (!found) found << "; at last " << toString(last.state) << ", " << toString(last.fault);
  return found;
}

testing::AssertionResult waitForState(Station& station, SafetyState state) {
  return waitFor(station, fmt::format("the state {}", toString(state)),
                 [state](const Sample& sample) { return sample.state == state; });
}

/// Arms as an operator does: again, when a busy machine missed steps and held the station in that very moment.
testing::AssertionResult arm(Station& station) {
  const Instant end = Clock::now() + kPatience;
  testing::AssertionResult armed = testing::AssertionFailure();
  while (!armed && Clock::now() < end) {
    if (!station.command({.action = OperatorAction::arm}))
      return testing::AssertionFailure() << "nothing takes commands";
    armed = waitFor(
        station, "the state Active", [](const Sample& sample) { return sample.state == SafetyState::active; },
        std::chrono::seconds(1));
  }
  return armed;
}

/// Whether this machine was too late, on which the robots of these tests run as well.
bool machineWasLate(pipeline::Fault fault) {
  return fault == pipeline::Fault::step_gap || fault == pipeline::Fault::steps_missed ||
         fault == pipeline::Fault::robot_lost;
}

/// What comes only while the touchpad renders; armed again, as by an operator, each time the machine held it.
testing::AssertionResult waitWhileRendering(Station& station, std::string_view what, const Enough& enough) {
  return waitFor(station, what, [&](const Sample& sample) {
    if (sample.state == SafetyState::held && machineWasLate(sample.fault)) {
      (void)station.command({.action = OperatorAction::arm});
    }
    return enough(sample);
  });
}

/// The state at each of the next `count` steps.
testing::AssertionResult staysFor(Station& station, int count, SafetyState state,
                                  const std::function<void()>& meanwhile = {}) {
  int seen = 0;
  return waitFor(station, fmt::format("{} steps", count), [&](const Sample& sample) {
    if (meanwhile) meanwhile();
    EXPECT_EQ(sample.state, state) << toString(sample.state);
    return ++seen == count;
  });
}

std::unique_ptr<Station> opened(const StationOptions& options) {
  auto station = Station::open(options);
  EXPECT_TRUE(station) << station.error().text();
  return station ? std::move(*station) : nullptr;
}

/// A robot of its own beside the station, as another process would be.
class OutsideRobot {
 public:
  OutsideRobot(const std::string& touchpad, const std::string& bind) {
    device::RobotRunnerOptions options;
    options.touchpad = *protocol::parseEndpoint(touchpad);
    options.bind = *protocol::parseEndpoint(bind);
    options.link.reply_timeout = std::chrono::seconds(5);  // a busy machine's pauses are no missed replies here
    auto robot = device::RobotRunner::open(options, std::make_unique<sim::RobotArm>(sim::SimParameters{}));
    EXPECT_TRUE(robot) << robot.error().text();
    robot_ = std::move(*robot);
    thread_ = std::jthread([this](const std::stop_token& stop) { robot_->run(stop); });
  }
  [[nodiscard]] device::RobotRunnerStatus status() const { return robot_->status(); }
  void stop() {
    thread_.request_stop();
    thread_.join();
  }

 private:
  std::unique_ptr<device::RobotRunner> robot_;
  std::jthread thread_;
};

std::string localOf(const Station& station) { return station.status().link.local; }

TEST(Station, AWholeSessionFromTheFingerToTheRobotAndBack) {
  auto station = opened({});
  station->start();
  ASSERT_TRUE(waitForState(*station, SafetyState::ready));
  ASSERT_TRUE(arm(*station));
  station->moveSimulatedFinger(0, 0, 6);
  EXPECT_TRUE(waitFor(*station, "the finger's contact, force and indentation",
                      [](const auto& s) { return s.contact && s.force_N > 1.0 && s.indentation_mm > 3.0; }));
  EXPECT_TRUE(
      waitFor(*station, "a stiffness that can be observed", [](const auto& s) { return s.stiffness_observable; }));
  EXPECT_TRUE(waitWhileRendering(*station, "the robot to follow the finger",
                                 [](const auto& s) { return s.robot_z_mm < -1.0; }));
  EXPECT_GT(station->cameraView().number, 0U);
  std::string missing;
  EXPECT_TRUE(comesTrue("every line of the readiness list", [&] {
    missing.clear();
    for (const ReadinessLine& line : station->readiness())
      if (!line.ok) missing += line.what.text() + "; ";
    return missing.empty();
  })) << missing;
  ASSERT_TRUE(comesTrue("100 states", [&] { return station->status().link.states_received > 100U; }));
  station->shutDown();  // nothing is under way any more
  const LinkStatus link = station->status().link;
  EXPECT_EQ(link.states_received, link.touches_sent);
}

TEST(Station, TheSimulatedFingerTakesUpAnotherPathWhileTheSessionRuns) {
  auto station = opened({});
  station->start();
  ASSERT_TRUE(waitForState(*station, SafetyState::ready));
  for (const double x_mm : {-20.0, 15.0}) {
    station->playSimulatedFinger(sim::FingerPath::constant(x_mm, 5.0, 4.0));
    EXPECT_TRUE(waitFor(*station, "the finger where the path has it", [x_mm](const auto& s) {
      return s.contact && std::abs(s.finger_x_mm - x_mm) < 1.0 && std::abs(s.finger_y_mm - 5.0) < 1.0;
    }));
  }
}

TEST(Station, StopIsHeardAndLatches) {
  auto station = opened({});
  station->start();
  ASSERT_TRUE(waitForState(*station, SafetyState::ready));
  ASSERT_TRUE(arm(*station));
  station->requestStop();
  ASSERT_TRUE(waitForState(*station, SafetyState::stopped));
  EXPECT_TRUE(staysFor(*station, 200, SafetyState::stopped));
}

TEST(Station, AWindowThatStopsAnsweringHoldsTheTouchpadAndItsReturnDoesNotArmIt) {
  auto station = opened({.real_time = true});
  station->start();
  Sample held;
  // An operator arms again whenever a busy machine holds it for another reason; what counts is the instant at which the
  // window's patience ends. A machine that holds it just then needs another silence.
  for (int silence = 0; silence < 60 && held.fault != pipeline::Fault::operator_silent; ++silence) {
    station->windowAlive();
    const Instant last_sign = Clock::now();
    int since_arm = 0;
    int silent_for = 0;
    ASSERT_TRUE(waitFor(*station, "the end of the window's patience", [&](const Sample& sample) {
      constexpr int kArmTaken = 20;  // steps, after which no arm is under way any more
      ++since_arm;
      const bool silent = sample.state == SafetyState::held && sample.fault == pipeline::Fault::operator_silent;
      silent_for = silent ? silent_for + 1 : 0;
      if (silent_for > kArmTaken) held = sample;
      const bool may_arm = sample.state == SafetyState::held || sample.state == SafetyState::ready;
      if (!silent && may_arm && since_arm > kArmTaken) {
        (void)station->command({.action = OperatorAction::arm});
        since_arm = 0;
      }
      return silent_for > kArmTaken || sample.now - last_sign > std::chrono::seconds(1);
    }));
  }
  EXPECT_EQ(held.fault, pipeline::Fault::operator_silent) << toString(held.fault);
  EXPECT_TRUE(staysFor(*station, 200, SafetyState::held, [&] { station->windowAlive(); }));
  ASSERT_TRUE(arm(*station));
}

TEST(Station, AWindowThatStopsAnsweringHoldsNothingWhereEverythingIsSimulated) {
  auto station = opened({});
  station->start();
  ASSERT_TRUE(waitForState(*station, SafetyState::ready));
  station->windowAlive();
  ASSERT_TRUE(arm(*station));
  EXPECT_TRUE(staysFor(*station, 1500, SafetyState::active));
  EXPECT_EQ(station->status().loop.missed_cycles, 0U);
  EXPECT_TRUE(station->status().loop.waits);
}

TEST(Station, ARobotThatGoesSilentHoldsTheTouchpadAndItsReturnDoesNotArmIt) {
  StationOptions options;
  options.robot = "classic:127.0.0.1:0";
  auto station = opened(options);
  station->start();
  auto robot = std::make_unique<OutsideRobot>(localOf(*station), "127.0.0.2:0");
  ASSERT_TRUE(waitForState(*station, SafetyState::ready));
  ASSERT_TRUE(arm(*station));
  robot->stop();
  ASSERT_TRUE(waitForState(*station, SafetyState::held));
  robot = std::make_unique<OutsideRobot>(localOf(*station), "127.0.0.2:0");
  ASSERT_TRUE(
      waitFor(*station, "the robot's return", [](const auto& s) { return s.link == pipeline::LinkPhase::running; }));
  ASSERT_TRUE(staysFor(*station, 300, SafetyState::held));
  ASSERT_TRUE(arm(*station));
}

TEST(Station, GarbageByTheThousandIsCountedAndChangesNothing) {
  StationOptions options;
  options.robot = "classic:127.0.0.1:0";
  auto station = opened(options);
  station->start();
  OutsideRobot robot(localOf(*station), "127.0.0.2:0");
  ASSERT_TRUE(waitForState(*station, SafetyState::ready));
  ASSERT_TRUE(arm(*station));

  auto socket = protocol::UdpSocket::open(*protocol::parseEndpoint("127.0.0.3:0"));
  ASSERT_TRUE(socket);
  const auto target = *protocol::parseEndpoint(localOf(*station));
  std::uint32_t noise = 12345;
  std::vector<std::uint8_t> garbage;
  constexpr int kAtOnce = 50;  // fits into the socket's buffer: each is heard, however busy the machine is
  for (int i = 0; i < 5000; ++i) {
    garbage.resize(static_cast<std::size_t>(i) % 100);
    for (auto& byte : garbage) byte = static_cast<std::uint8_t>((noise = noise * 1664525U + 1013904223U) >> 24);
    ASSERT_EQ(socket->send(garbage, target), protocol::SendOutcome::sent);
    if (i % kAtOnce != kAtOnce - 1) continue;
    const auto sent = static_cast<std::uint64_t>(i) + 1;
    ASSERT_TRUE(comesTrue("all garbage to be refused", [&] { return station->status().link.refused >= sent; }));
  }
  // Nothing but the machine's own lateness has held it, and what that held renders again.
  EXPECT_TRUE(waitWhileRendering(*station, "the state Active", [&, seen = 0](const auto& s) mutable {
    if (s.state == SafetyState::held) {
      EXPECT_TRUE(machineWasLate(s.fault)) << toString(s.fault);
    }
    seen = s.state == SafetyState::active ? seen + 1 : 0;
    return seen == 20;
  }));
  EXPECT_EQ(robot.status().connections, 1U);
  EXPECT_EQ(robot.status().counters.missed_replies, 0U);
}

TEST(Station, ATakenPortIsAClearError) {
  auto socket = protocol::UdpSocket::open(*protocol::parseEndpoint("127.0.0.1:0"));
  ASSERT_TRUE(socket);
  StationOptions options;
  options.robot = "classic:" + protocol::toString(socket->local());
  const auto station = Station::open(options);
  ASSERT_FALSE(station);
  EXPECT_THAT(station.error().text(), testing::HasSubstr(protocol::toString(socket->local())));
}

TEST(Station, WrongOptionsAreClearErrors) {
  const auto problem = [](auto change) {
    StationOptions options;
    change(options);
    const auto station = Station::open(options);
    return station ? std::string("no error") : station.error().text();
  };
  EXPECT_THAT(problem([](auto& o) { o.robot = "robby"; }),
              testing::HasSubstr("robot 'robby': expected simulated, scene:FILE, none"));
  EXPECT_THAT(problem([](auto& o) { o.robot = "scene:nowhere.toml"; }), testing::HasSubstr("nowhere.toml"));
  EXPECT_THAT(problem([](auto& o) { o.robot = "simulated:oracle"; }),
              testing::HasSubstr("predictor \"oracle\": expected one of thesis, order0"));
  EXPECT_THAT(problem([](auto& o) { o.robot = "classic:3490"; }), testing::HasSubstr("3490"));
  EXPECT_THAT(problem([](auto& o) { o.finger_csv = "nowhere.csv"; }), testing::HasSubstr("nowhere.csv"));
  EXPECT_THAT(problem([](auto& o) { o.surface = "nowhere.toml"; }), testing::HasSubstr("nowhere.toml"));
}

TEST(Station, AMissingCameraIsShownAndNeverReady) {
  StationOptions options;
  options.camera = "no-such-camera.avi";
  auto station = opened(options);
  station->start();
  ASSERT_TRUE(waitFor(*station, "300 steps in the state Connected",
                      [](const auto& s) { return s.state == SafetyState::connected && s.step > 300; }));
  const auto status = station->status();
  EXPECT_FALSE(status.parts[1].ok);
  EXPECT_THAT(status.parts[1].problem.text(), testing::HasSubstr("no-such-camera.avi"));
  ASSERT_TRUE(station->command({.action = OperatorAction::arm}));
  bool refused = false;
  EXPECT_TRUE(waitFor(*station, "the refusal to arm", [&](const auto& s) {
    EXPECT_EQ(s.state, SafetyState::connected);
    for (const Notice& notice : station->takeNotices())
      refused |= notice.event.kind == pipeline::EventKind::arm_refused;
    return refused;
  }));
}

TEST(Station, LiveParametersReachTheStepAndWrongOnesAreRefused) {
  StationOptions options;
  options.robot = "none";
  auto station = opened(options);
  EXPECT_TRUE(station->setParameter("texture.k_vib", 2.0));
  EXPECT_FALSE(station->setParameter("texture.k_vib", -1.0));
  EXPECT_FALSE(station->setParameter("texture.k_vib", std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(station->setParameter("texture.nonsense", 1.0));
  EXPECT_FALSE(station->setParameter("pipeline.ir_maximum_age_ms", 50.0)) << "not live";
  station->start();
  EXPECT_TRUE(comesTrue("the notice that texture.k_vib is now 2", [&] {
    return std::ranges::any_of(station->takeNotices(),
                               [](const Notice& notice) { return notice.message.text() == "texture.k_vib is now 2."; });
  }));
  EXPECT_EQ(station->currentProfile().step.texture.k_vib, 2.0);
}

// The recorder's thread writes the profile into each file while the operator's thread goes on changing it.
TEST(Station, ValuesChangeWhileRecordingsBegin) {
  const Folder folder;
  StationOptions options;
  options.robot = "none";
  auto station = opened(options);
  station->start();
  int recorded = 0;
  std::atomic<bool> over{false};
  std::jthread recording([&] {
    for (int i = 0; i < 5; ++i) {
      const auto begun = station->startRecording({.path = folder.file(fmt::format("{}.h5", i))});
      EXPECT_TRUE(begun) << begun.error().text();
      const auto ended = station->stopRecording();
      EXPECT_TRUE(ended) << ended.error().text();
      ++recorded;
    }
    over = true;
  });
  double value = 1.0;
  EXPECT_TRUE(comesTrue("five recordings", [&] {
    const double next = value < 2.0 ? value + 0.1 : 1.0;
    if (station->setParameter("texture.k_vib", next)) value = next;
    (void)station->takeNotices();
    return over.load();
  }));
  recording.join();
  EXPECT_EQ(recorded, 5);
  EXPECT_TRUE(comesTrue("the last change", [&] {
    (void)station->takeNotices();
    return station->currentProfile().step.texture.k_vib == value;
  }));
}

TEST(CommandGuard, SilenceOfTheLoopStopsTheVibrationAndKeepsTheReferences) {
  StampedMotorCommand stamped{
      .command = {.reference_ticks = {1000, -1000}, .vibration_duty_percent = {50, 50}, .active = true},
      .given = instantAt(1.0)};
  EXPECT_EQ(guardedCommand(stamped, instantAt(1.019)), stamped.command);
  const auto guarded = guardedCommand(stamped, instantAt(1.021));
  EXPECT_EQ(guarded.vibration_duty_percent[0], 0.0);
  EXPECT_EQ(guarded.reference_ticks, stamped.command.reference_ticks);
}

}  // namespace
}  // namespace fyd::station
