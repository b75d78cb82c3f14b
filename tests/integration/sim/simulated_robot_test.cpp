// The simulated robot over real sockets, against the touchpad's end of the protocol.
#include "core/device/robot/robot_runner.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "core/protocol/classic/classic_touchpad_end.h"
#include "core/sim/robot/robot_arm.h"
#include "tests/wait.h"

namespace fyd::sim {
namespace {

using pipeline::RobotCommand;
using std::chrono::milliseconds;

// A touchpad that answers every state, in a thread of its own.
class AnsweringTouchpad {
 public:
  explicit AnsweringTouchpad(const protocol::Endpoint& local = protocol::parseEndpoint("127.0.0.1:0").value())
      : socket_(protocol::UdpSocket::open(local).value()),
        thread_([this](const std::stop_token& stop) { serve(stop); }) {}

  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }
  void stop() {
    thread_.request_stop();
    thread_.join();
  }
  /// After stop.
  [[nodiscard]] const protocol::ClassicTouchpadEnd& end() const { return end_; }
  [[nodiscard]] const std::vector<RobotCommand>& commands() const { return commands_; }
  [[nodiscard]] const pipeline::RobotState& state() const { return state_; }
  [[nodiscard]] const std::optional<pipeline::RobotMotorReference>& motorReference() const { return reference_; }

 private:
  void serve(const std::stop_token& stop) {
    std::vector<std::uint8_t> buffer(protocol::kMaximumDatagram);
    protocol::TouchpadAnswer answer;
    answer.touch = {.position_mm = {6, 3, -1}, .in_contact = true, .force_N = 0.5};
    answer.board_text = "test board";
    while (!stop.stop_requested()) {
      const auto received = socket_.receive(buffer, milliseconds(5));
      if (!received) {
        end_.advance(Clock::now());
        continue;
      }
      const auto& got = end_.handle({buffer.data(), received->size}, received->from, Clock::now(), answer);
      for (const auto& reply : got.replies) static_cast<void>(socket_.send(reply.bytes, reply.to));
      if (got.command != RobotCommand::none) commands_.push_back(got.command);
      if (got.state) state_ = *got.state;
      if (got.motor_reference) reference_ = got.motor_reference;
    }
  }

  protocol::UdpSocket socket_;
  protocol::ClassicTouchpadEnd end_{protocol::LinkParameters{}};
  std::vector<RobotCommand> commands_;
  pipeline::RobotState state_;
  std::optional<pipeline::RobotMotorReference> reference_;
  std::jthread thread_;
};

SimParameters quiet(double stiffness_N_per_mm) {
  SimParameters parameters;
  parameters.accelerometer_noise_g = 0.0;
  parameters.material_stiffness_N_per_mm = stiffness_N_per_mm;
  return parameters;
}

std::unique_ptr<device::RobotRunner> makeRobot(const protocol::Endpoint& touchpad,
                                               device::RobotRunnerOptions options = {},
                                               const SimParameters& parameters = quiet(0.6)) {
  options.touchpad = touchpad;
  options.bind = protocol::parseEndpoint("127.0.0.2:0").value();
  options.link.reply_timeout = std::chrono::seconds(5);  // a busy machine's pauses are no missed replies here
  options.farewell = std::chrono::seconds(5);
  return device::RobotRunner::open(options, std::make_unique<RobotArm>(parameters)).value();
}

TEST(SimulatedRobot, KnowsItsMaterialBeforeItConnects) {
  for (const double stiffness : {0.3, 0.6, 0.9}) {
    const auto robot = makeRobot(protocol::parseEndpoint("127.0.0.1:9").value(), {}, quiet(stiffness));
    const device::RobotRunnerStatus status = robot->status();
    EXPECT_EQ(status.probe_outcome, device::ProbeOutcome::measured) << stiffness;
    EXPECT_NEAR(status.probed_stiffness_N_per_mm, stiffness, 0.02 * stiffness);
    EXPECT_LT(status.readings.position_mm.norm(), 1.0);
  }
}

TEST(SimulatedRobot, FindsNothingWhereThereIsNothing) {
  SimParameters parameters = quiet(0.0);
  parameters.material = Material::none;
  const auto robot = makeRobot(protocol::parseEndpoint("127.0.0.1:9").value(), {}, parameters);
  EXPECT_EQ(robot->status().probe_outcome, device::ProbeOutcome::no_contact);
  EXPECT_EQ(robot->status().probed_stiffness_N_per_mm, 0.0);
}

TEST(SimulatedRobot, ExchangesInStepAndFollowsTheFinger) {
  AnsweringTouchpad touchpad;
  const auto robot = makeRobot(touchpad.local());
  std::jthread thread([&](const std::stop_token& stop) { robot->run(stop); });
  EXPECT_TRUE(comesTrue("the arm under the finger, and 50 states", [&] {
    const device::RobotRunnerStatus now = robot->status();
    return now.counters.states > 50U && std::abs(now.readings.position_mm.x - 6.0) < 0.5 &&
           std::abs(now.readings.position_mm.y - 3.0) < 0.5;
  }));
  thread.request_stop();
  thread.join();
  touchpad.stop();
  const device::RobotRunnerStatus status = robot->status();
  EXPECT_EQ(status.counters.touches, status.counters.states);
  EXPECT_EQ(status.counters.missed_replies, 0U);
  EXPECT_EQ(status.connections, 1U);
  EXPECT_EQ(touchpad.end().counters().states, status.counters.states);
  EXPECT_EQ(touchpad.end().counters().refused(), 0U);
  EXPECT_EQ(touchpad.end().phase(), pipeline::LinkPhase::closed);  // it said goodbye
  EXPECT_NEAR(touchpad.state().stiffness_N_per_mm, 0.6, 0.02);
  EXPECT_EQ(status.touch.position_mm, (Vec3{6, 3, -1}));
}

TEST(SimulatedRobot, GivesItsCommandsInOrderAndEndsAfterDisconnect) {
  AnsweringTouchpad touchpad;
  device::RobotRunnerOptions options;
  options.link.closing = milliseconds(100);
  options.motor_reference = {.first_ticks = 933, .second_ticks = -933};
  options.commands = {{.at_s = 0.2, .command = RobotCommand::disconnect},
                      {.at_s = 0.05, .command = RobotCommand::send_info_and_pause},
                      {.at_s = 0.1, .command = RobotCommand::resume},
                      {.at_s = 0.15, .command = RobotCommand::motor_reference_on}};
  const auto robot = makeRobot(touchpad.local(), options);
  robot->run({}, kPatience);
  touchpad.stop();
  EXPECT_THAT(touchpad.commands(), ::testing::ElementsAre(RobotCommand::send_info_and_pause, RobotCommand::resume,
                                                          RobotCommand::motor_reference_on, RobotCommand::disconnect));
  ASSERT_TRUE(touchpad.motorReference());
  EXPECT_EQ(touchpad.motorReference()->second_ticks, -933.0);
  EXPECT_EQ(robot->status().phase, protocol::RobotPhase::closed);
  EXPECT_EQ(robot->status().counters.infos, 2U);
  EXPECT_LT(robot->status().seconds, toSeconds(kPatience)) << "it ends by itself";
}

TEST(SimulatedRobot, ReconnectsWhenTheTouchpadGoesAwayAndReturns) {
  // At an address of its own, so that nobody is given its port meanwhile.
  auto first = std::make_unique<AnsweringTouchpad>(protocol::parseEndpoint("127.0.0.78:0").value());
  const protocol::Endpoint address = first->local();
  device::RobotRunnerOptions options;
  options.link.ack_retry = milliseconds(50);
  options.touchpad = address;
  options.bind = protocol::parseEndpoint("127.0.0.2:0").value();
  options.link.reply_timeout = milliseconds(20);
  options.link.misses_until_lost = 3;
  const auto robot = device::RobotRunner::open(options, std::make_unique<RobotArm>(quiet(0.6))).value();
  std::jthread thread([&](const std::stop_token& stop) { robot->run(stop); });
  ASSERT_TRUE(comesTrue("the first connection", [&] { return robot->status().connections >= 1U; }));
  first->stop();
  first.reset();
  const std::uint64_t lost = robot->status().counters.lost;
  ASSERT_TRUE(comesTrue("the touchpad to be lost", [&] { return robot->status().counters.lost > lost; }));
  const std::uint64_t connections = robot->status().connections;
  AnsweringTouchpad second(address);
  EXPECT_TRUE(comesTrue("another connection", [&] { return robot->status().connections > connections; }));
  EXPECT_GE(robot->status().counters.lost, 1U);
}

// Keeps what it was told, exchange by exchange, and asks for the stop once it is told to move that far in one.
class NotingArm final : public device::Robot {
 public:
  NotingArm(std::vector<Vec3>& told, double stop_at_mm, std::stop_source stop)
      : arm_(quiet(0.6)), told_(told), stop_at_mm_(stop_at_mm), stop_(std::move(stop)) {}
  [[nodiscard]] Message description() const override { return verbatim("noting"); }
  [[nodiscard]] bool inVirtualTime() const override { return true; }
  [[nodiscard]] Result<device::RobotReadings> exchange(const Vec3& target_mm, Instant now) override {
    if (!told_.empty() && (target_mm - told_.back()).norm() > stop_at_mm_) stop_.request_stop();
    told_.push_back(target_mm);
    return arm_.exchange(target_mm, now);
  }

 private:
  RobotArm arm_;
  std::vector<Vec3>& told_;
  double stop_at_mm_;
  std::stop_source stop_;
};

// Whatever this machine's clock does to the cycles, each is one tick; and a stop in the middle of the way brakes.
TEST(SimulatedRobot, KeepsItsLimitsFromCycleToCycleAndComesToRestWhenItIsStopped) {
  for (const double rate_Hz : {1000.0, 300.0}) {
    AnsweringTouchpad touchpad;
    std::vector<Vec3> told;
    device::RobotRunnerOptions options;
    options.touchpad = touchpad.local();
    options.bind = protocol::parseEndpoint("127.0.0.2:0").value();
    options.rate_Hz = rate_Hz;
    options.probe_material = false;
    options.reference.mapping.scale_xy = 5.0;  // 30 mm to go, which takes more than a second
    options.limits = {.speed_mm_s = 30.0, .acceleration_mm_s2 = 100.0, .jerk_mm_s3 = 1000.0};
    // Stopped by its speed, two thirds of the highest: no time of this machine says when it is under way.
    const std::stop_source stop;
    auto arm = std::make_unique<NotingArm>(told, 20.0 / rate_Hz, stop);
    const auto robot = device::RobotRunner::open(options, std::move(arm)).value();
    ASSERT_FALSE(stop.stop_requested());
    told.clear();  // of the preparation, whose ticks are others
    robot->run(stop.get_token(), kPatience);
    touchpad.stop();
    ASSERT_TRUE(stop.stop_requested()) << "it was under way";
    ASSERT_GT(told.size(), 10U);
    Vec3 velocity;
    Vec3 acceleration;
    double fastest = 0.0;
    for (std::size_t i = 1; i < told.size(); ++i) {
      const Vec3 v = rate_Hz * (told[i] - told[i - 1]);
      const Vec3 a = rate_Hz * (v - velocity);
      const Vec3 j = rate_Hz * (a - acceleration);
      ASSERT_LE(v.norm(), 30.0 + 1e-6);
      ASSERT_LE(a.norm(), 100.0 + 1e-3);
      ASSERT_LE(j.norm(), 1000.0 + 1.0);
      velocity = v;
      acceleration = a;
      fastest = std::max(fastest, v.norm());
    }
    EXPECT_GT(fastest, 20.0);
    EXPECT_LT(velocity.norm(), 0.02 * fastest) << "it came to rest";
    EXPECT_LT(told.back().x, 25.0) << "before it arrived";
  }
}

/// Follows while it is told to, as a controller that is put into another mode.
class WilfulArm final : public device::Robot {
 public:
  WilfulArm(const SimParameters& parameters, std::shared_ptr<std::atomic<bool>> follows)
      : arm_(parameters), follows_(std::move(follows)) {}
  [[nodiscard]] Message description() const override { return arm_.description(); }
  [[nodiscard]] bool inVirtualTime() const override { return arm_.inVirtualTime(); }
  [[nodiscard]] Result<device::RobotReadings> exchange(const Vec3& target_mm, Instant now) override {
    if (!*follows_) return fail("in another mode");
    return arm_.exchange(target_mm, now);
  }

 private:
  RobotArm arm_;
  std::shared_ptr<std::atomic<bool>> follows_;
};

TEST(SimulatedRobot, WhileItsArmDoesNotFollowTheTouchpadIsToldNothingButTheGoodbye) {
  AnsweringTouchpad touchpad;
  const auto follows = std::make_shared<std::atomic<bool>>(true);
  device::RobotRunnerOptions options;
  options.touchpad = touchpad.local();
  options.bind = protocol::parseEndpoint("127.0.0.2:0").value();
  options.link.reply_timeout = std::chrono::seconds(5);
  options.farewell = std::chrono::seconds(5);
  const auto robot = device::RobotRunner::open(options, std::make_unique<WilfulArm>(quiet(0.6), follows)).value();
  std::jthread thread([&](const std::stop_token& stop) { robot->run(stop); });
  const auto states = [&] { return robot->status().counters.states; };
  const auto failing = [&] { return !robot->status().robot_problem.empty(); };
  ASSERT_TRUE(comesTrue("20 states", [&] { return states() > 20U; }));
  *follows = false;
  ASSERT_TRUE(comesTrue("the arm's problem", failing));
  const std::uint64_t before = states();
  std::this_thread::sleep_for(milliseconds(300));
  EXPECT_EQ(states(), before);
  *follows = true;
  EXPECT_TRUE(comesTrue("20 states more", [&] { return states() > before + 20U; }));
  *follows = false;
  ASSERT_TRUE(comesTrue("the arm's problem again", failing));
  thread.request_stop();
  thread.join();
  touchpad.stop();
  EXPECT_EQ(robot->status().connections, 1U);
  EXPECT_GE(touchpad.end().counters().lost, 1U);
  EXPECT_EQ(touchpad.end().phase(), pipeline::LinkPhase::closed) << "it said goodbye";
}

TEST(SimulatedRobot, WrongOptionsAreRefusedWithTheirValue) {
  const auto message = [](const device::RobotRunnerOptions& options) {
    const auto robot = device::RobotRunner::open(options, std::make_unique<RobotArm>(SimParameters{}));
    return robot ? std::string("opened") : robot.error().text();
  };
  const auto any = protocol::parseEndpoint("127.0.0.2:0").value();
  const auto touchpad = protocol::parseEndpoint("127.0.0.1:3490").value();
  EXPECT_THAT(message({.touchpad = touchpad, .bind = any, .rate_Hz = 0.0}), ::testing::HasSubstr("0 states a second"));
  EXPECT_THAT(message({.touchpad = any, .bind = any}), ::testing::HasSubstr("127.0.0.2:0 has no port"));
  EXPECT_THAT(message({.touchpad = touchpad, .bind = protocol::parseEndpoint("[::1]:0").value()}),
              ::testing::HasSubstr("both must be IPv4"));
  const auto holder = protocol::UdpSocket::open(any).value();
  EXPECT_THAT(message({.touchpad = touchpad, .bind = holder.local()}), ::testing::HasSubstr("another program"));
}

}  // namespace
}  // namespace fyd::sim
