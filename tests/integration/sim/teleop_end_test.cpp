// Two linked devices over real sockets: started and stopped in any order, with one of them lost.
#include "core/sim/teleop/teleop_end.h"

#include <cmath>
#include <thread>

#include <gtest/gtest.h>

#include "core/sim/teleop/desktop_arm.h"
#include "core/teleop/coupling/coupling_choice.h"
#include "core/teleop/prediction/predictor_choice.h"
#include "tests/integration/sim/delivered_socket.h"

namespace fyd::sim {
namespace {

using Phase = TeleopEnd::Phase;

/// One end with a socket of its own and a device that stands where it is told to.
struct Peer {
  explicit Peer(bool at_hand, double deadband = 0.0)
      : end({.at_hand = at_hand,
             .coupling = teleop::CouplingChoice::spring,
             .coupling_settings = {},
             .predictor = teleop::PredictorChoice::order0,
             .smooth_s = 0.0,
             .deadband = deadband}) {}

  /// @param talks false: its cable is out
  void step(double now_s, Peer& other, bool talks = true) {
    socket.receive([&](std::span<const std::uint8_t> bytes, const protocol::Endpoint&) {
      if (talks) end.receive(bytes, now_s);
    });
    force_N = end.step(device, now_s);
    const auto bytes = end.datagram(now_s);
    if (bytes.empty()) return;
    ++sent;
    if (talks) socket.send(bytes, other.socket);
  }

  TeleopEnd end;
  DeliveredSocket socket;
  DeviceState device;
  Vec3 force_N;
  int sent = 0;
};

struct TeleopPair {
  /// Virtual milliseconds: what one sends the other finds at its next step.
  void run(int milliseconds, bool hand_talks = true, bool far_talks = true) {
    for (int i = 0; i < milliseconds; ++i, now_s += 0.001) {
      hand.step(now_s, far, hand_talks);
      far.step(now_s, hand, far_talks);
    }
  }
  explicit TeleopPair(double deadband = 0.0) : hand(true, deadband), far(false, deadband) {}
  Peer hand, far;
  double now_s = 100.0;
};

TEST(TeleopEnd, EitherMayStartFirstAndNoForceComesBeforeBothRun) {
  for (const bool hand_first : {true, false}) {
    TeleopPair pair;
    pair.hand.device.position_mm = {10.0, 0.0, 0.0};
    Peer& first = hand_first ? pair.hand : pair.far;
    Peer& second = hand_first ? pair.far : pair.hand;
    pair.run(50);
    EXPECT_EQ(pair.hand.sent + pair.far.sent, 0);
    first.end.start(7);
    pair.run(300);
    EXPECT_EQ(first.end.phase(), Phase::waiting);
    EXPECT_EQ(second.end.phase(), Phase::stopped);
    EXPECT_EQ(pair.hand.force_N, Vec3{});
    EXPECT_EQ(pair.far.force_N.norm(), 0.0);
    second.end.start(8);
    pair.run(2000);
    EXPECT_EQ(first.end.phase(), Phase::linked);
    EXPECT_EQ(second.end.phase(), Phase::linked);
    EXPECT_NEAR(pair.far.end.other_mm()[0], 10.0, DesktopArm::kPrecision_mm);
    EXPECT_GT(pair.far.force_N.x, 1.0);    // pulled to the hand
    EXPECT_LT(pair.hand.force_N.x, -1.0);  // which is pulled back
  }
}

TEST(TeleopEnd, EitherMayStopAndStartAgainAndTheOtherWaits) {
  for (const bool hand_stops : {true, false}) {
    TeleopPair pair;
    pair.hand.device.position_mm = {10.0, 0.0, 0.0};
    pair.hand.end.start(1);
    pair.far.end.start(2);
    pair.run(1000);
    Peer& stops = hand_stops ? pair.hand : pair.far;
    Peer& stays = hand_stops ? pair.far : pair.hand;
    stops.end.stop();
    pair.run(100);
    EXPECT_EQ(stops.end.phase(), Phase::stopped);
    EXPECT_EQ(stays.end.phase(), Phase::waiting);
    EXPECT_EQ(pair.hand.force_N.norm(), 0.0);
    EXPECT_EQ(pair.far.force_N.norm(), 0.0);
    const int sent = stops.sent;
    pair.run(200);
    EXPECT_EQ(stops.sent, sent);  // farewells end
    stops.end.start(3);
    pair.run(300);
    EXPECT_EQ(stops.end.phase(), Phase::linked);
    EXPECT_EQ(stays.end.phase(), Phase::linked);
    stays.end.stop();
    stops.end.stop();  // both at once
    pair.run(100);
    EXPECT_EQ(pair.hand.end.phase(), Phase::stopped);
    EXPECT_EQ(pair.far.end.phase(), Phase::stopped);
  }
}

TEST(TeleopEnd, ALostEndLeavesTheOtherWithoutForceAndIsTakenBack) {
  for (const bool hand_vanishes : {true, false}) {
    TeleopPair pair;
    pair.hand.device.position_mm = {10.0, 0.0, 0.0};
    pair.hand.end.start(1);
    pair.far.end.start(2);
    pair.run(1000);
    ASSERT_EQ(pair.far.end.phase(), Phase::linked);
    pair.run(400, !hand_vanishes, hand_vanishes);
    EXPECT_EQ((hand_vanishes ? pair.far : pair.hand).end.phase(), Phase::linked);  // a silence that networks have
    pair.run(200, !hand_vanishes, hand_vanishes);
    EXPECT_EQ(pair.hand.end.phase(), Phase::lost);
    EXPECT_EQ(pair.far.end.phase(), Phase::lost);
    EXPECT_EQ(pair.hand.force_N.norm(), 0.0);
    EXPECT_EQ(pair.far.force_N.norm(), 0.0);
    pair.far.device.velocity_mm_per_s = {100.0, 0.0, 0.0};
    pair.run(1, !hand_vanishes, hand_vanishes);
    EXPECT_LT(pair.far.force_N.x, 0.0);  // it brakes
    pair.far.device.velocity_mm_per_s = {};
    pair.run(1000);
    EXPECT_EQ(pair.hand.end.phase(), Phase::linked);
    EXPECT_EQ(pair.far.end.phase(), Phase::linked);
  }
}

TEST(TeleopEnd, WhileLinkingTheDistanceIsClosedSlowlyNotInAJump) {
  TeleopPair pair;
  pair.hand.device.position_mm = {40.0, 0.0, 0.0};
  pair.hand.end.start(1);
  pair.far.end.start(2);
  double before = 0.0, most = 0.0, hand_before = 0.0, hand_most = 0.0;
  for (int i = 0; i < 2000; ++i) {
    pair.run(1);
    most = std::max(most, std::abs(pair.far.force_N.x - before));
    before = pair.far.force_N.x;
    hand_most = std::max(hand_most, std::abs(pair.hand.force_N.x - hand_before));
    hand_before = pair.hand.force_N.x;
  }
  EXPECT_LE(most, 0.1);  // 50 mm/s · 1000 N/m · 1 ms is 0.05 N
  EXPECT_LE(hand_most, 0.1);
  EXPECT_GT(before, 5.0);
  EXPECT_LT(hand_before, -5.0);
}

TEST(TeleopEnd, AMessageOfTheStartBeforeLinksNobodyAgain) {
  TeleopPair pair;
  pair.hand.end.start(1);
  pair.far.end.start(2);
  pair.run(200);
  TeleopEnd twin({.at_hand = true, .coupling_settings = {}});
  twin.start(1);
  static_cast<void>(twin.step({.position_mm = {-20.0, 0.0, 0.0}}, pair.now_s));
  const auto bytes = twin.datagram(pair.now_s);
  const std::vector<std::uint8_t> late(bytes.begin(), bytes.end());
  pair.hand.device.position_mm = {10.0, 0.0, 0.0};
  pair.hand.end.start(3);  // without a farewell: it had crashed
  pair.run(300);
  ASSERT_NEAR(pair.far.end.other_mm()[0], 10.0, DesktopArm::kPrecision_mm);
  pair.far.end.receive(late, pair.now_s);
  pair.run(1);
  EXPECT_NEAR(pair.far.end.other_mm()[0], 10.0, DesktopArm::kPrecision_mm);
}

TEST(TeleopEnd, ADeviceThatMeasuresNothingGetsNoForceAndIsTakenAgain) {
  for (const bool far : {true, false}) {
    TeleopPair pair;
    pair.hand.device.position_mm = {10.0, 0.0, 0.0};
    pair.hand.end.start(1);
    pair.far.end.start(2);
    Peer& blind = far ? pair.far : pair.hand;
    const DeviceState good = blind.device;
    blind.device.position_mm.x = blind.device.velocity_mm_per_s.y = std::nan("");
    pair.run(300);
    EXPECT_EQ(blind.force_N, Vec3{});
    EXPECT_EQ(blind.end.phase(), Phase::linked);
    blind.device = good;
    pair.run(1000);
    EXPECT_GT(pair.far.force_N.x, 1.0);
    EXPECT_LT(pair.hand.force_N.x, -1.0);
  }
}

TEST(TeleopEnd, WhatADeviceDoesWhileItMeasuresNothingIsNoWork) {
  for (const bool far : {true, false}) {
    TeleopPair pair;
    pair.hand.device.position_mm = {10.0, 0.0, 0.0};
    pair.hand.end.start(1);
    pair.far.end.start(2);
    pair.run(1000);
    Peer& blind = far ? pair.far : pair.hand;
    ASSERT_GT(std::abs(blind.force_N.x), 1.0);
    const double before_J = blind.end.telemetry().energy_J;
    DeviceState good = blind.device;
    blind.device.force_N.z = std::nan("");  // one value is enough
    pair.run(100);
    EXPECT_EQ(blind.force_N, Vec3{});
    good.position_mm.x += 30.0;
    blind.device = good;
    pair.run(1);
    EXPECT_EQ(blind.end.telemetry().energy_J, before_J);
    EXPECT_GT(std::abs(blind.force_N.x), 1.0);
  }
}

TEST(TeleopEnd, WithADeadbandAHandAtRestIsRefreshedAndAMoveIsToldAtOnce) {
  TeleopPair pair(0.10);
  pair.hand.device.position_mm = {10.0, 0.0, 0.0};
  pair.hand.end.start(1);
  pair.far.end.start(2);
  pair.run(1000);
  ASSERT_EQ(pair.far.end.phase(), Phase::linked);
  const int before = pair.hand.sent;
  pair.run(1000);
  EXPECT_LE(pair.hand.sent - before, 21);  // one in 50 ms
  EXPECT_GE(pair.hand.sent - before, 19);
  EXPECT_EQ(pair.far.end.phase(), Phase::linked);
  EXPECT_NEAR(pair.far.end.told(pair.now_s - 0.2).value[0], 10.0, DesktopArm::kPrecision_mm);
  EXPECT_TRUE(pair.far.end.told(pair.now_s - 0.2).known);
  pair.hand.device.position_mm.x = 10.05;  // not felt
  const int still = pair.hand.sent;
  pair.run(1);
  EXPECT_LE(pair.hand.sent - still, 1);
  pair.hand.device.position_mm.x = 10.3;
  const int moved = pair.hand.sent;
  pair.run(1);
  EXPECT_EQ(pair.hand.sent, moved + 1);
  pair.run(400, false, false);  // a silence that networks have
  pair.run(300);
  EXPECT_EQ(pair.far.end.phase(), Phase::linked);
  EXPECT_NEAR(pair.far.end.other_mm()[0], 10.3, DesktopArm::kPrecision_mm);
  pair.run(600, false, false);
  EXPECT_EQ(pair.far.end.phase(), Phase::lost);
  pair.hand.end.stop();
  pair.hand.end.start(3);
  pair.run(300);
  EXPECT_EQ(pair.far.end.phase(), Phase::linked);
  EXPECT_NEAR(pair.far.end.told(pair.now_s - 0.1).value[0], 10.3, DesktopArm::kPrecision_mm);
}

TEST(TeleopEnd, AMessageDatedFarAheadIsPassedOver) {
  TeleopPair pair;
  pair.hand.end.start(1);
  pair.far.end.start(2);
  pair.run(200);
  TeleopEnd twin({.at_hand = true, .coupling_settings = {}});
  twin.start(1);
  static_cast<void>(twin.step({.position_mm = {-20.0, 0.0, 0.0}}, pair.now_s + 3600.0));
  pair.far.end.receive(twin.datagram(pair.now_s + 3600.0), pair.now_s);
  pair.hand.device.position_mm.x = 10.0;
  pair.run(200);
  EXPECT_NEAR(pair.far.end.other_mm()[0], 10.0, DesktopArm::kPrecision_mm);
}

TEST(TeleopEnd, NoiseFromAStrangerAndAnOvertakenFarewellChangeNothing) {
  TeleopPair pair;
  pair.hand.end.start(1);
  pair.far.end.start(2);
  pair.run(200);
  std::vector<std::uint8_t> noise(60);
  for (int i = 0; i < 2000; ++i) {
    for (auto& each : noise) each = static_cast<std::uint8_t>(i * 7 + static_cast<int>(&each - noise.data()) * i);
    pair.far.end.receive(std::span(noise).first(static_cast<std::size_t>(i) % 60), pair.now_s);
  }
  EXPECT_EQ(pair.far.end.phase(), Phase::linked);
  // The hand's last message before its farewell comes after it.
  const auto late = [&] {
    pair.run(10);
    TeleopEnd twin({.at_hand = true, .coupling_settings = {}});
    twin.start(1);
    static_cast<void>(twin.step({}, pair.now_s));
    const auto bytes = twin.datagram(pair.now_s);
    return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
  }();
  pair.hand.end.stop();
  pair.run(50);
  ASSERT_EQ(pair.far.end.phase(), Phase::waiting);
  pair.far.end.receive(late, pair.now_s);
  EXPECT_EQ(pair.far.end.phase(), Phase::waiting);
}

}  // namespace
}  // namespace fyd::sim
