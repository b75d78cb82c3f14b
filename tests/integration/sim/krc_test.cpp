// The controller's simulator and the robot end in one process, over real sockets.
#include "core/sim/robot/krc.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "core/device/robot/fri_robot.h"
#include "core/device/robot/robot_runner.h"
#include "tests/wait.h"

namespace fyd::sim {
namespace {

using protocol::FriQuality;
using protocol::FriState;
using std::chrono::milliseconds;

protocol::Endpoint at(const char* text) { return protocol::parseEndpoint(text).value(); }

SimParameters quiet() {
  SimParameters parameters;
  parameters.accelerometer_noise_g = 0.0;
  parameters.material_stiffness_N_per_mm = 0.5;
  return parameters;
}

// A robot end on a KRC, each in a thread of its own. Nobody plays the touchpad.
struct Pair {
  explicit Pair(KrcOptions krc_options, device::RobotRunnerOptions options = {}) {
    auto arm = device::FriRobot::open({.bind = at("127.0.0.1:0")}).value();
    krc_options.remote = arm->local();
    krc_options.bind = at("127.0.0.3:0");
    krc_options.arm = quiet();
    krc = Krc::open(krc_options).value();
    options.touchpad = at("127.0.0.1:9");
    options.bind = at("127.0.0.2:0");
    runner = device::RobotRunner::open(options, std::move(arm)).value();
    robot_thread = std::jthread([this](const std::stop_token& stop) { runner->run(stop); });
    krc_thread = std::jthread([this](const std::stop_token& stop) { krc->run(stop); });
  }
  void stop() {
    robot_thread.request_stop();
    robot_thread.join();
    krc_thread.request_stop();
    krc_thread.join();
  }
  std::unique_ptr<Krc> krc;
  std::unique_ptr<device::RobotRunner> runner;
  std::jthread robot_thread;
  std::jthread krc_thread;
};

TEST(Krc, ProbesTheMaterialThroughTheControllerInRealTime) {
  device::RobotRunnerStatus robot;
  KrcStatus krc;
  // A machine that stands still loses the link quality, rightly; such a trial says nothing of the probe.
  for (int trial = 0; trial < 8 && (trial == 0 || krc.counters.command_losses > 0); ++trial) {
    Pair pair({.period_ms = 8.0, .monitor_for_s = 0.0}, {.probe = {.dwell_s = 0.25, .samples = 3}});
    ASSERT_TRUE(comesTrue("the end of the probe", [&] { return pair.runner->status().prepared; }));
    pair.stop();
    robot = pair.runner->status();
    krc = pair.krc->status();
  }
  EXPECT_EQ(robot.probe_outcome, device::ProbeOutcome::measured);
  EXPECT_NEAR(robot.probed_stiffness_N_per_mm, 0.5, 0.02);
  EXPECT_EQ(krc.counters.wrong_mirrors, 0U);
  EXPECT_EQ(krc.counters.wrong_flags, 0U);
  EXPECT_EQ(krc.counters.wrong_echoes, 0U);
  EXPECT_EQ(krc.counters.leaps, 0U);
  EXPECT_EQ(krc.stiffness_N_per_m, 1000.0F);
  EXPECT_EQ(krc.rotation_stiffness_Nm_per_rad, 300.0F);
  EXPECT_EQ(krc.damping, 0.3F);
  EXPECT_LT(krc.lowest_z_mm, -3.0);
}

TEST(Krc, AModeThatEndsStopsTheProbeAndNothingLeapsWhenItReturns) {
  device::RobotRunnerStatus robot;
  KrcStatus krc;
  // The robot must follow when the mode ends the first time; on a machine that stands still it earns that too late.
  for (int trial = 0; trial < 8 && robot.robot_resumed == 0; ++trial) {
    Pair pair({.period_ms = 5.0,
               .monitor_for_s = 0.0,
               .modes = {{1.1, FriState::monitor}, {1.4, FriState::command}, {2.0, FriState::off}}},
              {.probe = {.dwell_s = 0.2}});
    ASSERT_TRUE(comesTrue("the mode off", [&] { return pair.krc->status().mode == FriState::off; }));
    ASSERT_TRUE(comesTrue("the word for it", [&] {
      return pair.runner->status().robot_problem.text().find("KRC off") != std::string::npos;
    }));
    pair.stop();
    robot = pair.runner->status();
    krc = pair.krc->status();
    EXPECT_EQ(robot.probed_stiffness_N_per_mm, 0.0);
    EXPECT_EQ(krc.counters.leaps, 0U);
    EXPECT_EQ(krc.counters.wrong_mirrors, 0U);
  }
  EXPECT_EQ(robot.probe_outcome, device::ProbeOutcome::aborted);
  EXPECT_GE(robot.robot_resumed, 1U);
}

/// What the controller says once it has run until `enough`.
KrcStatus ranUntil(const KrcOptions& options, std::string_view what,
                   const std::function<bool(const KrcStatus&)>& enough) {
  const auto krc = Krc::open(options).value();
  std::jthread thread([&](const std::stop_token& stop) { krc->run(stop); });
  EXPECT_TRUE(comesTrue(what, [&] { return enough(krc->status()); }));
  thread.request_stop();
  thread.join();
  return krc->status();
}

TEST(Krc, NoAnswersNoQualityNoCommandMode) {
  const auto nobody = protocol::UdpSocket::open(at("127.0.0.1:0")).value();
  const KrcStatus status = ranUntil(
      {.remote = nobody.local(), .bind = at("127.0.0.3:0"), .period_ms = 1.0, .monitor_for_s = 0},
      "more measurements than the quality looks at", [](const auto& now) { return now.counters.measurements > 250U; });
  EXPECT_EQ(status.mode, FriState::monitor);
  EXPECT_EQ(status.quality, FriQuality::unacceptable);
  EXPECT_EQ(status.counters.answers, 0U);
}

// A remote played by hand: `reply` makes each answer.
class Remote {
 public:
  explicit Remote(std::function<void(const protocol::FriMeasurement&, protocol::FriCommand&)> reply)
      : thread_([this, reply = std::move(reply)](const std::stop_token& stop) {
          std::vector<std::uint8_t> buffer(1000);
          protocol::FriMeasurement measurement;
          protocol::FriCommand command;
          while (!stop.stop_requested()) {
            const auto received = socket_.receive(buffer, milliseconds(5));
            if (!received) continue;
            static_cast<void>(decodeFriMeasurement({buffer.data(), received->size}, measurement));
            command.header.reflected = measurement.header.sequence;
            reply(measurement, command);
            static_cast<void>(socket_.send(protocol::encodeFriCommand(command), received->from));
          }
        }) {}
  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }

 private:
  protocol::UdpSocket socket_ = protocol::UdpSocket::open(at("127.0.0.1:0")).value();
  std::jthread thread_;
};

void mirror(const protocol::FriMeasurement& m, protocol::FriCommand& c) {
  c.flags = 0x1;
  for (std::size_t i = 0; i < 7; ++i) c.joints[i] = m.commanded_joints[i] + m.joint_offsets[i];
}

/// @param period_ms long enough for a busy machine where the quality must be earned
KrcStatus against(Remote& remote, double period_ms, std::string_view what,
                  const std::function<bool(const KrcStatus&)>& enough) {
  return ranUntil({.remote = remote.local(),
                   .bind = at("127.0.0.3:0"),
                   .period_ms = period_ms,
                   .monitor_for_s = 0.0,
                   .arm = quiet()},
                  what, enough);
}

TEST(Krc, LateAnswersDropTheQuality) {
  Remote remote([](const auto& m, auto& c) {
    mirror(m, c);
    --c.header.reflected;  // always the measurement before
  });
  const KrcStatus status =
      against(remote, 2.0, "late answers", [](const auto& now) { return now.counters.late_answers > 150U; });
  EXPECT_EQ(status.counters.answers, 0U);
  EXPECT_EQ(status.quality, FriQuality::unacceptable);
  EXPECT_EQ(status.mode, FriState::monitor);
}

TEST(Krc, AnEchoOfNothingSentIsCounted) {
  Remote remote([](const auto& m, auto& c) {
    mirror(m, c);
    c.header.reflected = static_cast<std::uint16_t>(m.header.sequence + 1000);
  });
  against(remote, 2.0, "wrong echoes", [](const auto& now) { return now.counters.wrong_echoes > 20U; });
}

TEST(Krc, JointsThatAreNotMirroredAreCounted) {
  Remote remote([](const auto& m, auto& c) {
    mirror(m, c);
    c.joints[2] += 0.001F;
  });
  against(remote, 2.0, "wrong mirrors", [](const auto& now) { return now.counters.wrong_mirrors > 20U; });
}

TEST(Krc, ALeapEndsCommandModeAndMovesNothing) {
  Remote remote([](const auto& m, auto& c) {
    mirror(m, c);
    if (m.state != FriState::command) return;
    c.flags = 0x3100;
    c.frame = m.commanded_frame;
    c.frame[3] += 0.1F;
  });
  const KrcStatus status = against(remote, 10.0, "a leap that ends the command mode", [](const auto& now) {
    return now.counters.leaps >= 1U && now.counters.command_losses >= 1U;
  });
  EXPECT_LT(status.position_mm.norm(), 0.01);
}

TEST(Krc, AnAnswerWithoutImpedanceFlagsMovesNothing) {
  Remote remote([](const auto& m, auto& c) {
    mirror(m, c);
    c.frame = m.commanded_frame;
    c.frame[11] += 0.0001F;
  });
  const KrcStatus status =
      against(remote, 10.0, "wrong flags", [](const auto& now) { return now.counters.wrong_flags > 20U; });
  EXPECT_LT(status.position_mm.norm(), 0.01);
}

TEST(Krc, WrongOptionsAreRefusedWithTheirValue) {
  const auto message = [](const KrcOptions& options) {
    const auto krc = Krc::open(options);
    return krc ? std::string("opened") : krc.error().text();
  };
  const auto remote = at("127.0.0.1:49938");
  EXPECT_THAT(message({.remote = remote, .bind = at("127.0.0.3:0"), .period_ms = 0.5}),
              ::testing::HasSubstr("period 0.5"));
  EXPECT_THAT(message({.remote = at("127.0.0.1:0"), .bind = at("127.0.0.3:0")}), ::testing::HasSubstr("no port"));
  EXPECT_THAT(message({.remote = remote, .bind = at("[::1]:0")}), ::testing::HasSubstr("both must be IPv4"));
}

}  // namespace
}  // namespace fyd::sim
