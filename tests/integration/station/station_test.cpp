// The station with its threads, on real sockets. Nothing here depends on how fast the machine is, only on the order
// of events; a wait ends as soon as what it waits for has come.
#include "core/station/station.h"

#include <functional>
#include <thread>

#include <gtest/gtest.h>

#include "core/protocol/udp_socket.h"
#include "core/sim/robot_arm.h"
#include "core/sim/simulated_robot.h"
#include "core/station/touchpad_thread.h"

namespace fyd::station {
namespace {

using pipeline::OperatorAction;
using pipeline::SafetyState;

/// Drains telemetry until `enough` says so; false after `patience`.
bool waitFor(Station& station, const std::function<bool(const pipeline::TelemetrySample&)>& enough,
             Duration patience = std::chrono::seconds(30)) {
  std::vector<pipeline::TelemetrySample> batch(1000);
  const Instant deadline = Clock::now() + patience;
  while (Clock::now() < deadline) {
    const std::size_t taken = station.takeTelemetry(batch);
    for (std::size_t i = 0; i < taken; ++i) {
      if (enough(batch[i])) return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

bool waitForState(Station& station, SafetyState state) {
  return waitFor(station, [state](const pipeline::TelemetrySample& sample) { return sample.state == state; });
}

/// Arms as an operator does: again, when a busy machine missed steps and held the station in that very moment.
bool arm(Station& station) {
  for (int i = 0; i < 30; ++i) {
    if (!station.command({.action = OperatorAction::arm})) return false;
    const auto active = [](const pipeline::TelemetrySample& sample) { return sample.state == SafetyState::active; };
    if (waitFor(station, active, std::chrono::seconds(1))) return true;
  }
  return false;
}

std::unique_ptr<Station> opened(const StationOptions& options) {
  auto station = Station::open(options);
  EXPECT_TRUE(station) << station.error().message;
  return station ? std::move(*station) : nullptr;
}

/// A robot of its own beside the station, as another process would be.
class OutsideRobot {
 public:
  OutsideRobot(const std::string& touchpad, const std::string& bind) {
    sim::SimulatedRobotOptions options;
    options.touchpad = *protocol::parseEndpoint(touchpad);
    options.bind = *protocol::parseEndpoint(bind);
    auto robot = sim::SimulatedRobot::open(options, std::make_unique<sim::RobotArm>(sim::SimParameters{}));
    EXPECT_TRUE(robot) << robot.error().message;
    robot_ = std::move(*robot);
    thread_ = std::jthread([this](const std::stop_token& stop) { robot_->run(stop); });
  }
  [[nodiscard]] sim::SimulatedRobotStatus status() const { return robot_->status(); }
  void stop() {
    thread_.request_stop();
    thread_.join();
  }

 private:
  std::unique_ptr<sim::SimulatedRobot> robot_;
  std::jthread thread_;
};

std::string localOf(const Station& station) { return station.status().link.local; }

TEST(Station, AWholeSessionFromTheFingerToTheRobotAndBack) {
  auto station = opened({});
  station->start();
  ASSERT_TRUE(waitForState(*station, SafetyState::ready));
  ASSERT_TRUE(arm(*station));
  station->moveSimulatedFinger(0, 0, 6);
  EXPECT_TRUE(waitFor(*station, [](const auto& s) { return s.contact && s.force_N > 1.0 && s.indentation_mm > 3.0; }));
  EXPECT_TRUE(waitFor(*station, [](const auto& s) { return s.stiffness_observable; }));
  EXPECT_TRUE(waitFor(*station, [](const auto& s) { return s.robot_z_mm < -1.0; })) << "the robot follows the finger";
  while (station->status().link.states_received <= 100U) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const StationStatus status = station->status();
  EXPECT_EQ(status.link.states_received, status.link.touches_sent);
  EXPECT_GT(station->cameraView().number, 0U);
  for (const ReadinessLine& line : station->readiness()) EXPECT_TRUE(line.ok) << line.what;
}

TEST(Station, StopIsHeardAndLatches) {
  auto station = opened({});
  station->start();
  ASSERT_TRUE(waitForState(*station, SafetyState::ready));
  ASSERT_TRUE(arm(*station));
  station->requestStop();
  ASSERT_TRUE(waitForState(*station, SafetyState::stopped));
  std::vector<pipeline::TelemetrySample> batch(1000);
  for (int i = 0; i < 20; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const std::size_t taken = station->takeTelemetry(batch);
    for (std::size_t k = 0; k < taken; ++k) EXPECT_EQ(batch[k].state, SafetyState::stopped);
  }
}

TEST(Station, AWindowThatStopsAnsweringHoldsTheTouchpadAndItsReturnDoesNotArmIt) {
  auto station = opened({});
  station->start();
  pipeline::TelemetrySample held;
  // A busy machine may hold it for another reason first: then once more.
  for (int i = 0; i < 60 && held.lack != pipeline::Lack::operator_silent; ++i) {
    ASSERT_TRUE(waitFor(*station, [&](const auto& sample) {
      station->windowAlive();
      return sample.state == SafetyState::ready || sample.state == SafetyState::held;
    }));
    ASSERT_TRUE(arm(*station));
    ASSERT_TRUE(waitFor(*station, [&](const auto& sample) {
      held = sample;
      return sample.state == SafetyState::held;
    }));
  }
  EXPECT_EQ(held.lack, pipeline::Lack::operator_silent);
  std::vector<pipeline::TelemetrySample> batch(1000);
  for (int i = 0; i < 20; ++i) {
    station->windowAlive();
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    const std::size_t taken = station->takeTelemetry(batch);
    for (std::size_t k = 0; k < taken; ++k) EXPECT_EQ(batch[k].state, SafetyState::held);
  }
  ASSERT_TRUE(arm(*station));
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
  ASSERT_TRUE(waitFor(*station, [](const auto& s) { return s.link == pipeline::LinkPhase::running; }));
  int seen = 0;
  ASSERT_TRUE(waitFor(*station, [&seen](const auto& s) {
    EXPECT_EQ(s.state, SafetyState::held);
    return ++seen == 300;  // samples, with the robot back
  }));
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
  for (int i = 0; i < 5000; ++i) {
    garbage.resize(static_cast<std::size_t>(i) % 100);
    for (auto& byte : garbage) byte = static_cast<std::uint8_t>((noise = noise * 1664525U + 1013904223U) >> 24);
    (void)socket->send(garbage, target);
    if (i % 50 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ASSERT_TRUE(waitFor(*station, [](const auto& s) { return s.step > 0; }));
  EXPECT_GT(station->status().link.refused, 1000U);
  EXPECT_TRUE(waitFor(*station, [](const auto& s) { return s.state == SafetyState::active; }));
  EXPECT_EQ(robot.status().counters.missed_replies, 0U);
}

TEST(Station, ATakenPortIsAClearError) {
  auto socket = protocol::UdpSocket::open(*protocol::parseEndpoint("127.0.0.1:0"));
  ASSERT_TRUE(socket);
  StationOptions options;
  options.robot = "classic:" + protocol::toString(socket->local());
  const auto station = Station::open(options);
  ASSERT_FALSE(station);
  EXPECT_THAT(station.error().message, testing::HasSubstr(protocol::toString(socket->local())));
}

TEST(Station, WrongOptionsAreClearErrors) {
  const auto problem = [](auto change) {
    StationOptions options;
    change(options);
    const auto station = Station::open(options);
    return station ? std::string("no error") : station.error().message;
  };
  EXPECT_THAT(problem([](auto& o) { o.robot = "robby"; }),
              testing::HasSubstr("robot 'robby': expected simulated, none"));
  EXPECT_THAT(problem([](auto& o) { o.robot = "classic:3490"; }), testing::HasSubstr("3490"));
  EXPECT_THAT(problem([](auto& o) { o.finger_csv = "nowhere.csv"; }), testing::HasSubstr("nowhere.csv"));
  EXPECT_THAT(problem([](auto& o) { o.surface = "nowhere.toml"; }), testing::HasSubstr("nowhere.toml"));
}

TEST(Station, AMissingCameraIsShownAndNeverReady) {
  StationOptions options;
  options.camera = "no-such-camera.avi";
  auto station = opened(options);
  station->start();
  ASSERT_TRUE(waitFor(*station, [](const auto& s) { return s.state == SafetyState::connected && s.step > 300; }));
  const auto status = station->status();
  EXPECT_FALSE(status.parts[1].ok);
  EXPECT_THAT(status.parts[1].problem, testing::HasSubstr("no-such-camera.avi"));
  ASSERT_TRUE(station->command({.action = OperatorAction::arm}));
  bool refused = false;
  EXPECT_TRUE(waitFor(*station, [&](const auto& s) {
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
  ASSERT_TRUE(waitFor(*station, [](const auto& s) { return s.step > 10; }));
  bool changed = false;
  for (const Notice& notice : station->takeNotices()) changed |= notice.text == "texture.k_vib is now 2.";
  EXPECT_TRUE(changed);
  EXPECT_EQ(station->currentProfile().step.texture.k_vib, 2.0);
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
