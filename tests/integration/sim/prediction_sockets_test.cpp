// Prediction over real sockets: messages pass an emulated bad network (network_emulator.h), in virtual time, and then
// the kernel. The robot end led by touches over FYD Link, and two linked devices.
#include <cmath>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/device/robot/following_robot.h"
#include "core/device/robot/touch_reference.h"
#include "core/protocol/link/link_robot_end.h"
#include "core/protocol/link/link_touchpad_end.h"
#include "core/sim/network/network_emulator.h"
#include "core/sim/robot/robot_arm.h"
#include "core/sim/teleop/desktop_arm.h"
#include "core/sim/teleop/teleop_end.h"
#include "tests/integration/sim/delivered_socket.h"

namespace fyd::sim {
namespace {

constexpr double kTick_s = 0.001;

struct Weather {
  std::string name;
  NetworkSettings network{.delay_ms = 30.0, .jitter_ms = 5.0};
  double silent_from_s = 1e9, silent_to_s = 1e9;  ///< nothing passes, either way
  double drift = 0.0;                             ///< of the far end's clock
  int first_lost = 0;                             ///< datagrams, each way
};

std::vector<Weather> weathers() {
  std::vector<Weather> out = {{.name = "20 % lost"}, {.name = "50 % lost"},  {.name = "637 ms of silence"},
                              {.name = "100 ppm"},   {.name = "first lost"}, {.name = "all twice"},
                              {.name = "overtaking"}};
  out[0].network.loss_percent = 20.0;
  out[1].network.loss_percent = 50.0;
  out[2].silent_from_s = 4.0;
  out[2].silent_to_s = 4.637;
  out[3].drift = 1e-4;
  out[4].first_lost = 1;
  out[5].network.duplicate_percent = 100.0;
  out[6].network.reorder_percent = 30.0;
  out[6].network.reorder_by_ms = 60.0;
  return out;
}

/// A socket whose datagrams are late, lost or doubled before they leave it.
class BadSocket {
 public:
  BadSocket(const Weather& weather, std::uint64_t seed)
      : weather_(weather), emulator_([&] {
          NetworkSettings out = weather.network;
          out.seed = seed;
          return out;
        }()) {}

  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }
  void send(std::span<const std::uint8_t> bytes, const protocol::Endpoint& to, double t_s) {
    if (bytes.empty()) return;
    const Passage passage = emulator_.pass(bytes.size(), instantAt(t_s));
    if (sent_++ < weather_.first_lost) return;
    if (t_s >= weather_.silent_from_s && t_s < weather_.silent_to_s) return;
    for (const Instant at : passage.out) {
      under_way_.emplace(toSeconds(at.time_since_epoch()), std::pair(to, std::vector(bytes.begin(), bytes.end())));
    }
  }
  void leave(double t_s, BadSocket& other) {
    for (; !under_way_.empty() && under_way_.begin()->first <= t_s; under_way_.erase(under_way_.begin())) {
      const auto& [to, bytes] = under_way_.begin()->second;
      EXPECT_EQ(to, other.local());
      socket_.send(bytes, other.socket_);
    }
  }
  template <class Take>
  void receive(Take&& take) {
    socket_.receive(take);
  }

 private:
  Weather weather_;
  NetworkEmulator emulator_;
  DeliveredSocket socket_;
  std::multimap<double, std::pair<protocol::Endpoint, std::vector<std::uint8_t>>> under_way_;
  int sent_ = 0;
};

Vec3 finger(double t_s) { return {12.0 * std::sin(3.0 * t_s), 8.0 * std::cos(2.3 * t_s), -1.0}; }

/// Millisecond by millisecond where the arm was told to be, led by `finger` through both ends of FYD Link.
std::vector<Vec3> robotLed(const Weather& weather, const device::MotionLimits& limits, double seconds) {
  const protocol::LinkKey key = protocol::LinkKey::generate();
  BadSocket here(weather, 11), there(weather, 12);
  protocol::LinkTouchpadEnd touchpad(protocol::LinkParameters{}, key);
  protocol::LinkRobotEnd end(protocol::LinkRobotSettings{}, key, here.local());
  device::FollowingRobot robot(std::make_unique<RobotArm>(SimParameters{}), limits);
  device::TouchReferenceSettings settings;
  settings.mapping.scale_z = 1.0;
  device::TouchReference reference(settings, robot.lag_s());
  std::vector<Vec3> told;
  for (int i = 0; i < static_cast<int>(seconds / kTick_s); ++i) {
    const double t_s = kTick_s * i;
    const Instant now = instantAt(1000.0 + t_s), robots = instantAt(5000.0 + t_s * (1.0 + weather.drift));
    const protocol::TouchpadAnswer answer{.touch = {.position_mm = finger(t_s), .in_contact = true, .force_N = 1.0},
                                          .taken = now,
                                          .info = {},
                                          .board_text = "test",
                                          .image = {}};
    here.receive([&](protocol::Bytes bytes, const protocol::Endpoint& from) {
      for (const auto& each : touchpad.handle(bytes, from, now, answer).replies) here.send(each.bytes, each.to, t_s);
    });
    for (const auto& each : touchpad.advance(now, answer)) here.send(each.bytes, each.to, t_s);
    const device::MovingTarget target = reference.at(robots, end.phase());
    EXPECT_TRUE(target.position_mm.finite() && target.velocity_mm_s.finite()) << weather.name << " at " << t_s;
    const auto readings = robot.exchange(target.position_mm, kTick_s, now, target.velocity_mm_s);
    const protocol::RobotReport report{.robot = {.position_mm = readings.value().position_mm},
                                       .acceleration_taken = robots};
    for (const auto& each : end.tick(robots, report)) there.send(each.bytes, each.to, t_s);
    there.receive([&](protocol::Bytes bytes, const protocol::Endpoint& from) {
      reference.take(end.handle(bytes, from, robots), end.counters(), robot.commanded_mm(), robots);
    });
    here.leave(t_s, there);
    there.leave(t_s, here);
    told.push_back(robot.commanded_mm());
  }
  return told;
}

/// RMS along the cloth of the arm's motion against the finger's since `from`, its own start taken away.
double apart_mm(const std::vector<Vec3>& told, std::size_t from) {
  double squares = 0.0;
  Vec3 offset;
  const double count = static_cast<double>(told.size() - from);
  for (std::size_t i = from; i < told.size(); ++i) {
    offset = offset + (1.0 / count) * (told[i] - finger(kTick_s * static_cast<double>(i) + 0.033));
  }
  for (std::size_t i = from; i < told.size(); ++i) {
    const Vec3 d = told[i] - finger(kTick_s * static_cast<double>(i) + 0.033) - offset;
    squares += d.x * d.x + d.y * d.y;
  }
  return std::sqrt(squares / count);
}

TEST(PredictionOverSockets, TheRobotEndStaysWithinItsLimitsAndFollowsAgain) {
  const device::MotionLimits limits;
  for (const Weather& weather : weathers()) {
    const std::vector<Vec3> told = robotLed(weather, limits, 9.0);
    double speed = 0.0, acceleration = 0.0, jerk = 0.0;
    for (std::size_t i = 3; i < told.size(); ++i) {
      ASSERT_TRUE(told[i].finite()) << weather.name;
      ASSERT_LE(std::abs(told[i].x), limits.workspace_mm.x) << weather.name;
      const Vec3 v = 1e3 * (told[i] - told[i - 1]), u = 1e3 * (told[i - 1] - told[i - 2]),
                 w = 1e3 * (told[i - 2] - told[i - 3]);
      speed = std::max(speed, v.norm());
      acceleration = std::max(acceleration, 1e3 * (v - u).norm());
      jerk = std::max(jerk, 1e6 * (v - 2.0 * u + w).norm());
    }
    EXPECT_LE(speed, limits.speed_mm_s * 1.0001) << weather.name;
    EXPECT_LE(acceleration, limits.acceleration_mm_s2 * 1.0001) << weather.name;
    EXPECT_LE(jerk, limits.jerk_mm_s3 * 1.0001) << weather.name;
    EXPECT_GT(speed, 20.0) << weather.name;                // it moved
    EXPECT_LT(apart_mm(told, 7000), 0.5) << weather.name;  // held, it would be 2.6 mm and more
  }
}

struct LinkedDevice {
  LinkedDevice(const TeleopEndSettings& settings, const Weather& weather, std::uint64_t seed, double more_kg)
      : end(settings), socket(weather, seed), arm(more_kg) {}
  TeleopEnd end;
  BadSocket socket;
  DesktopArm arm;
};

TEST(PredictionOverSockets, TwoLinkedDevicesStayFiniteAndFollowAgainWithAndWithoutADeadband) {
  const auto wanted = [](double t_s) { return Vec3{30.0 * std::sin(3.0 * t_s), 15.0 * std::sin(2.0 * t_s), 0.0}; };
  for (const Weather& weather : weathers()) {
    for (const double deadband : {0.0, 0.10}) {
      TeleopEndSettings settings{
          .at_hand = true,
          .coupling_settings = {.stiffness_N_per_m = 1000.0, .damping_N_s_per_m = 6.7, .most_force_N = 6.4},
          .deadband = deadband};
      LinkedDevice hand(settings, weather, 21, 0.5);
      settings.at_hand = false;
      LinkedDevice far(settings, weather, 22, 0.0);
      hand.end.start(1);
      far.end.start(2);
      const std::string name = weather.name + (deadband > 0.0 ? ", deadband" : "");
      double squares = 0.0, count = 0.0, fastest = 0.0;
      bool linked_at_end = false;
      for (int i = 0; i < 9000; ++i) {
        const double t_s = kTick_s * i, far_s = t_s * (1.0 + weather.drift);
        const auto step = [&](LinkedDevice& device, LinkedDevice& other, double now_s) {
          device.socket.receive([&](std::span<const std::uint8_t> bytes, const protocol::Endpoint&) {
            device.end.receive(bytes, 100.0 + now_s);
          });
          const Vec3 force = device.end.step({.position_mm = device.arm.measured_mm(),
                                              .velocity_mm_per_s = device.arm.velocity_mm_per_s(),
                                              .force_N = {},
                                              .orientation = {}},
                                             100.0 + now_s);
          EXPECT_TRUE(force.finite()) << name << " at " << t_s;
          for (const double each : {force.x, force.y, force.z}) EXPECT_LE(std::abs(each), 6.4) << name << " at " << t_s;
          device.socket.send(device.end.datagram(100.0 + now_s), other.socket.local(), t_s);
          device.socket.leave(t_s, other.socket);
          return force;
        };
        const Vec3 felt = step(hand, far, t_s), drive = step(far, hand, far_s);
        const Vec3 pull = wanted(t_s) - hand.arm.position_mm();
        for (int part = 0; part < 10; ++part) {
          hand.arm.step(felt, pull - 0.03 * hand.arm.velocity_mm_per_s(), 0.1 * kTick_s);
          far.arm.step(drive, {}, 0.1 * kTick_s);
        }
        fastest = std::max(fastest, far.arm.velocity_mm_per_s().norm());
        linked_at_end = far.end.phase() == TeleopEnd::Phase::linked && hand.end.phase() == TeleopEnd::Phase::linked;
        if (i < 7000) continue;
        const Vec3 d = far.arm.position_mm() - hand.arm.position_mm();
        squares += d.x * d.x + d.y * d.y + d.z * d.z;
        count += 1.0;
      }
      EXPECT_TRUE(linked_at_end) << name;
      EXPECT_LT(std::sqrt(squares / count), 1.5) << name;
      EXPECT_LT(fastest, 1000.0) << name;  // the hand: 95 mm/s and what it has to catch up with
    }
  }
}

}  // namespace
}  // namespace fyd::sim
