// The remote side of FRI against a controller scripted by the test, over real sockets.
#include "core/device/robot/fri_robot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

#include "tests/wait.h"

namespace fyd::device {
namespace {

using protocol::FriControl;
using protocol::FriQuality;
using protocol::FriState;
using ::testing::HasSubstr;

constexpr std::uint32_t kImpedance = 0x3100;  // frame, Cartesian stiffness and damping

protocol::Endpoint any(const char* host = "127.0.0.1:0") { return protocol::parseEndpoint(host).value(); }

/// What waits in the receive queue of the socket that is bound there, as the kernel counts it; nothing: there is none.
std::optional<std::size_t> waiting_bytes(const protocol::Endpoint& at) {
  std::uint32_t address = 0;  // the kernel prints it as it is in the memory
  std::memcpy(&address, at.address.data(), sizeof address);
  const std::string local = fmt::format("{:08X}:{:04X}", address, at.port);
  std::ifstream table("/proc/net/udp");
  std::string slot, found, remote, state, queues;
  for (std::string line; std::getline(table, line);) {
    std::istringstream(line) >> slot >> found >> remote >> state >> queues;
    if (found == local) return std::stoul(queues.substr(queues.find(':') + 1), nullptr, 16);
  }
  return std::nullopt;
}

class Fri : public ::testing::Test {
 protected:
  void SetUp() override {
    measurement.control = FriControl::cartesian_impedance;
    measurement.quality = FriQuality::good;
    measurement.measurement_period_s = measurement.command_period_s = 0.005F;
    // Tool down, at (0.5, 0.1, 0.3) m.
    measurement.commanded_frame = {1, 0, 0, 0.5F, 0, -1, 0, 0.1F, 0, 0, -1, 0.3F};
    measurement.frame = measurement.commanded_frame;
    for (std::size_t i = 0; i < 7; ++i) {
      measurement.commanded_joints[i] = 0.25F * static_cast<float>(i);
      measurement.joint_offsets[i] = 0.5F;
    }
  }
  void open(FriSettings settings = {}) {
    settings.bind = any();
    robot = FriRobot::open(settings).value();
  }
  // One measurement, one exchange, one answer, which is taken.
  Result<RobotReadings> cycle(const Vec3& target = {}) {
    ++measurement.header.sequence;
    now += std::chrono::milliseconds(5);
    send();
    auto result = robot->exchange(target, now);
    answered = take();
    if (answered && measurement.state == FriState::command && command.flags == kImpedance) {
      measurement.commanded_frame = measurement.frame = command.frame;
    }
    return result;
  }
  void cycles(int count, const Vec3& target) {
    for (int i = 0; i < count; ++i) EXPECT_EQ(reason(target), "follows");
  }
  std::string reason(const Vec3& target = {}) {
    const auto result = cycle(target);
    return result ? std::string("follows") : result.error().text();
  }
  void send() { deliver(krc, protocol::encodeFriMeasurement(measurement)); }
  /// Returns once it is in the robot's queue: on a busy machine loopback delivers after send() has returned.
  void deliver(protocol::UdpSocket& from, std::span<const std::uint8_t> bytes) {
    // A page of it may leave out a socket, when another one is closed between two pages.
    std::optional<std::size_t> before;
    ASSERT_TRUE(comesTrue("the robot's socket in /proc/net/udp",
                          [&] { return (before = waiting_bytes(robot->local())).has_value(); }));
    ASSERT_EQ(from.send(bytes, robot->local()), protocol::SendOutcome::sent);
    ASSERT_TRUE(comesTrue("the datagram in the robot's queue",
                          [&] { return waiting_bytes(robot->local()).value_or(0) > *before; }));
  }
  /// The robot's next answer. One that it has sent is waited for.
  bool take() {
    std::array<std::uint8_t, 1000> buffer{};
    const bool due = robot->counters().answers > taken;
    const auto received = krc.receive(buffer, due ? Duration(kPatience) : Duration::zero());
    EXPECT_EQ(received.has_value(), due);
    if (received) ++taken;
    return received && decodeFriCommand({buffer.data(), received->size}, command) == protocol::FriRefusal::none;
  }

  protocol::UdpSocket krc = protocol::UdpSocket::open(any()).value();
  std::unique_ptr<FriRobot> robot;
  protocol::FriMeasurement measurement;
  protocol::FriCommand command;
  bool answered = false;
  std::uint64_t taken = 0;  ///< answers
  Instant now = instantAt(100.0);
};

TEST_F(Fri, EchoesTheSequenceAndMirrorsJointsPlusOffsetsOutsideCommandMode) {
  open();
  for (const FriState state : {FriState::off, FriState::monitor}) {
    measurement.state = state;
    EXPECT_FALSE(cycle({10, 10, 10}));
    ASSERT_TRUE(answered);
    EXPECT_EQ(command.header.reflected, measurement.header.sequence);
    EXPECT_EQ(command.flags, 0x1U);
    EXPECT_FLOAT_EQ(command.joints[0], 0.5F);
    EXPECT_FLOAT_EQ(command.joints[6], 2.0F);
  }
}

TEST_F(Fri, CommandModeHoldsFirstThenCarriesTheTargetInMetresWithTheThesisImpedance) {
  open();
  measurement.state = FriState::command;
  const protocol::FriFrame found = measurement.commanded_frame;
  EXPECT_THAT(reason({10, 20, -30}), HasSubstr("just begun"));
  EXPECT_EQ(command.flags, kImpedance);
  EXPECT_EQ(command.frame, found);  // held
  EXPECT_EQ(reason({10, 20, -30}), "follows");
  EXPECT_EQ(command.frame, found);  // held once more, now that it succeeded
  cycles(100, {10, 20, -30});
  // X = −y, Y = −x, Z = z, in m from the start.
  EXPECT_NEAR(command.frame[3], 0.5 - 0.020, 1e-6);
  EXPECT_NEAR(command.frame[7], 0.1 - 0.010, 1e-6);
  EXPECT_NEAR(command.frame[11], 0.3 - 0.030, 1e-6);
  for (const std::size_t i : {0U, 1U, 2U, 4U, 5U, 6U, 8U, 9U, 10U}) EXPECT_EQ(command.frame[i], found[i]);
  for (const std::size_t i : {0U, 1U, 2U}) EXPECT_EQ(command.cartesian_stiffness[i], 1000.0F);
  for (const std::size_t i : {3U, 4U, 5U}) EXPECT_EQ(command.cartesian_stiffness[i], 300.0F);
  for (const float damping : command.cartesian_damping) EXPECT_EQ(damping, 0.3F);
}

TEST_F(Fri, ReadsPositionForceAndAccelerationInOurFrame) {
  open();
  measurement.force_torque[2] = 1.5F;  // the estimate's offset
  measurement.state = FriState::monitor;
  EXPECT_FALSE(cycle());
  measurement.state = FriState::command;
  EXPECT_FALSE(cycle());
  measurement.frame[3] += 0.004F;   // X = −y
  measurement.frame[7] -= 0.003F;   // Y = −x
  measurement.frame[11] -= 0.002F;  // Z = z
  measurement.force_torque[2] = 3.75F;
  measurement.krl.reals[1] = -0.5F;
  const auto readings = cycle({0, 0, -8});
  ASSERT_TRUE(readings);
  EXPECT_NEAR(readings->position_mm.x, 3.0, 1e-3);
  EXPECT_NEAR(readings->position_mm.y, -4.0, 1e-3);
  EXPECT_NEAR(readings->position_mm.z, -2.0, 1e-3);
  EXPECT_NEAR(readings->force_N, 2.25, 1e-6);
  EXPECT_EQ(readings->acceleration_g, (Vec3{0, -0.5, 0}));
  EXPECT_EQ(readings->taken, now);
  measurement.force_torque[2] = -5.0F;
  EXPECT_EQ(cycle()->force_N, 0.0);
}

TEST_F(Fri, SaysInWordsWhyTheArmDoesNotFollow) {
  open();
  EXPECT_THAT(robot->exchange({}, now).error().text(), HasSubstr("KRC: nothing heard on 127.0.0.1:"));
  EXPECT_THAT(reason(), HasSubstr("KRC off"));
  measurement.state = FriState::monitor;
  EXPECT_THAT(reason(), HasSubstr("KRC in monitor mode"));
  measurement.state = FriState::command;
  measurement.quality = FriQuality::bad;
  measurement.answer_rate = 0.42F;
  EXPECT_THAT(reason(), HasSubstr("link quality bad: 42 % of its measurements answered"));
  measurement.quality = FriQuality::perfect;
  measurement.error = 0x08;
  EXPECT_THAT(reason(), HasSubstr("drive errors 0x08"));
  measurement.error = 0;
  measurement.control = FriControl::joint_impedance;
  EXPECT_THAT(reason(), HasSubstr("control strategy joint impedance: expected Cartesian"));
  EXPECT_EQ(command.flags, 0x1U);  // holds by the mirrored joints
  measurement.control = FriControl::cartesian_impedance;
  EXPECT_THAT(reason(), HasSubstr("just begun"));
  EXPECT_EQ(reason(), "follows");
  now += std::chrono::milliseconds(300);
  EXPECT_THAT(robot->exchange({}, now).error().text(), HasSubstr("KRC silent for 300 ms"));
}

TEST_F(Fri, ATargetThatIsNoNumberIsRefusedAndTheArmBrakes) {
  open();
  measurement.state = FriState::command;
  EXPECT_FALSE(cycle());
  EXPECT_TRUE(cycle());
  cycles(10, {10, 20, 30});
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (int i = 0; i < 20; ++i) {
      EXPECT_THAT(reason({0, bad, 0}), HasSubstr("expected three finite numbers"));
      EXPECT_TRUE(answered);  // the controller is answered all the same
    }
    const auto before = command.frame;
    EXPECT_THAT(reason({0, bad, 0}), HasSubstr("expected three finite numbers"));
    EXPECT_EQ(command.frame, before);
  }
}

TEST_F(Fri, CommandModeThatBeginsAnewHoldsWhereTheControllerThenStands) {
  open();
  measurement.state = FriState::command;
  EXPECT_FALSE(cycle());
  EXPECT_TRUE(cycle());
  EXPECT_TRUE(cycle({10, 0, 0}));
  measurement.state = FriState::monitor;
  EXPECT_FALSE(cycle({20, 0, 0}));
  measurement.commanded_frame[11] += 0.05F;  // moved by hand meanwhile
  measurement.frame = measurement.commanded_frame;
  measurement.state = FriState::command;
  EXPECT_FALSE(cycle({20, 0, 0}));
  EXPECT_EQ(command.frame, measurement.commanded_frame);
  const auto readings = cycle({20, 0, 0});
  ASSERT_TRUE(readings);
  EXPECT_EQ(command.frame, measurement.commanded_frame);
  EXPECT_NEAR(readings->commanded_mm->z, 50.0, 1e-3);  // from where the limiter goes on
  EXPECT_EQ(robot->counters().command_entries, 2U);
}

// The workspace ends 70 mm below the first place.
TEST_F(Fri, AnArmThatWasMovedOutOfTheWorkspaceStaysThereUntilItIsLed) {
  open();
  measurement.state = FriState::monitor;
  EXPECT_FALSE(cycle());
  measurement.commanded_frame[11] -= 0.1F;
  measurement.frame = measurement.commanded_frame;
  const protocol::FriFrame found = measurement.commanded_frame;
  measurement.state = FriState::command;
  EXPECT_FALSE(cycle());
  const auto readings = cycle();
  ASSERT_TRUE(readings);
  cycles(200, *readings->commanded_mm);
  EXPECT_NEAR(command.frame[11], found[11], 1e-7);
  cycles(200, {0, 0, -150});
  EXPECT_NEAR(command.frame[11], found[11], 1e-7) << "no further out";
  cycles(300, {0, 0, -50});
  EXPECT_NEAR(command.frame[11], 0.3 - 0.05, 1e-6);
}

TEST_F(Fri, ACommandedFrameFarFromTheMeasuredOneIsNotTrusted) {
  open();
  measurement.state = FriState::command;
  measurement.frame[3] += 0.04F;
  EXPECT_FALSE(cycle());
  EXPECT_EQ(command.frame, measurement.frame);
}

TEST_F(Fri, OldRepeatedForeignAndDamagedMeasurementsAreCountedAndNotAnswered) {
  open();
  measurement.state = FriState::monitor;
  EXPECT_FALSE(cycle());
  EXPECT_TRUE(answered);
  send();  // repeated
  static_cast<void>(robot->exchange({}, now));
  EXPECT_FALSE(take());
  EXPECT_EQ(robot->counters().out_of_order, 1U);

  auto bytes = protocol::encodeFriMeasurement(measurement);
  bytes[6] ^= 0xFF;
  deliver(krc, bytes);
  deliver(krc, std::span(bytes).first(915));
  static_cast<void>(robot->exchange({}, now));
  EXPECT_FALSE(take());
  EXPECT_EQ(robot->counters().refused[static_cast<std::size_t>(protocol::FriRefusal::wrong_id)], 1U);
  EXPECT_EQ(robot->counters().refused[static_cast<std::size_t>(protocol::FriRefusal::wrong_size)], 1U);

  auto other = protocol::UdpSocket::open(any("127.0.0.2:0")).value();
  ++measurement.header.sequence;
  deliver(other, protocol::encodeFriMeasurement(measurement));
  static_cast<void>(robot->exchange({}, now));
  EXPECT_EQ(robot->counters().wrong_peer, 1U);
  EXPECT_EQ(robot->counters().measurements, 1U);
}

TEST_F(Fri, WhatNoArmMeasuresIsRefusedNotAnsweredAndNotMirrored) {
  open();
  measurement.state = FriState::monitor;
  EXPECT_FALSE(cycle());
  const protocol::FriMeasurement sound = measurement;
  std::uint64_t refused = 0;
  const auto spoil = [&](const auto& change, const char* words) {
    measurement = sound;
    measurement.header.sequence = static_cast<std::uint16_t>(sound.header.sequence + 2 * refused + 1);
    change(measurement);
    EXPECT_THAT(reason(), HasSubstr(words));
    EXPECT_FALSE(answered) << words;
    EXPECT_EQ(robot->counters().impossible, ++refused);
    // The next sound one is answered again, and mirrors nothing of what was refused.
    const auto sequence = measurement.header.sequence;
    measurement = sound;
    measurement.header.sequence = sequence;
    EXPECT_THAT(reason(), HasSubstr("monitor mode"));
    EXPECT_TRUE(answered);
    EXPECT_FLOAT_EQ(command.joints[6], 2.0F);
  };
  for (const FriState state : {FriState::monitor, FriState::command}) {
    spoil([&](auto& m) { m.state = state, m.commanded_joints.fill(1e30F); }, "commanded joint 1 is 1e+30 rad");
    spoil([&](auto& m) { m.state = state, m.frame.fill(0.0F); }, "rotation of the measured frame");
    spoil([&](auto& m) { m.state = state, m.commanded_frame[3] = 1e30F; }, "commanded frame is at (1e+30, 0.1, 0.3) m");
    spoil([&](auto& m) { m.state = state, m.frame[3] += 1.0F, m.commanded_frame[3] += 1.0F; }, "moved 1 m in 1 cycles");
    spoil([&](auto& m) { m.state = state, m.force_torque[2] = 1e30F; }, "tool force 3 is 1e+30 N");
  }
}

TEST_F(Fri, AnImpossibleMeasurementInAMotionMovesNothingAndItGoesOnFromRest) {
  open();
  measurement.state = FriState::command;
  EXPECT_FALSE(cycle());
  EXPECT_TRUE(cycle());
  cycles(20, {0, 0, -60});
  const auto good = measurement;
  measurement.commanded_frame.fill(0.0F);
  EXPECT_THAT(reason({0, 0, -60}), HasSubstr("rotation of the commanded frame"));
  EXPECT_FALSE(answered);
  measurement.commanded_frame = good.commanded_frame;
  EXPECT_EQ(reason({0, 0, -60}), "follows");  // anew: holds
  EXPECT_EQ(command.frame, good.commanded_frame);
  EXPECT_EQ(reason({0, 0, -60}), "follows");
  // From rest one axis goes j·h³/6 in the first tick: 250 000/√3 · 0.005³/6 = 0.003 mm.
  EXPECT_NEAR(command.frame[11], good.commanded_frame[11] - 3.0e-6, 1e-7);
}

TEST_F(Fri, OfSeveralThatWaitedTheOlderOnesAreAnsweredWithAHalt) {
  open();
  measurement.state = FriState::command;
  EXPECT_FALSE(cycle());
  EXPECT_TRUE(cycle());
  cycles(20, {0, 0, -60});
  const auto stands = measurement.commanded_frame;
  for (int i = 0; i < 3; ++i) {
    ++measurement.header.sequence;
    send();
  }
  now += std::chrono::milliseconds(15);
  EXPECT_TRUE(robot->exchange({0, 0, -60}, now));
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(take());
    EXPECT_EQ(command.header.reflected, measurement.header.sequence - 2 + i);
    EXPECT_EQ(command.frame, stands);
  }
  ASSERT_TRUE(take());
  EXPECT_EQ(command.header.reflected, measurement.header.sequence);
  EXPECT_NEAR(command.frame[11], stands[11] - 3.0e-6, 1e-7);
  EXPECT_FALSE(take());
}

TEST_F(Fri, SequenceNumbersWrap) {
  open();
  measurement.header.sequence = 0xFFFD;
  for (int i = 0; i < 5; ++i) {
    EXPECT_FALSE(cycle());
    EXPECT_TRUE(answered);
    EXPECT_EQ(command.header.reflected, measurement.header.sequence);
  }
  EXPECT_EQ(robot->counters().answers, 5U);
}

TEST_F(Fri, OnlyTheNamedControllerIsHeard) {
  FriSettings settings;
  settings.krc = any("127.0.0.9:0");
  open(settings);
  EXPECT_THAT(reason(), HasSubstr("nothing heard"));
  EXPECT_EQ(robot->counters().wrong_peer, 1U);
}

TEST(AxisMap, MapsThereAndBack) {
  const Vec3 ours{1, 2, 3};
  EXPECT_EQ(AxisMap{}.toBase(ours), (Vec3{-2, -1, 3}));
  for (const char* text : {"x,y,z", "-y,x,z", "z,-x,-y", "-x,-z,y"}) {
    const AxisMap map = parseAxisMap(text).value();
    EXPECT_EQ(map.toTouchpad(map.toBase(ours)), ours) << text;
  }
  EXPECT_EQ(parseAxisMap("z,-x,y")->toBase(ours), (Vec3{3, -1, 2}));
  for (const char* text : {"", "x,y", "x,x,z", "x,y,w", "x,y,z,", "x y z", "--x,y,z"}) {
    EXPECT_FALSE(parseAxisMap(text)) << text;
  }
}

}  // namespace
}  // namespace fyd::device
