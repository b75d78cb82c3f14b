// What the haptic loop is told of a link that changes faster than it looks: a robot by hand, over real sockets.
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "core/protocol/classic/classic_codec.h"
#include "core/protocol/udp_socket.h"
#include "core/station/link_thread.h"
#include "tests/wait.h"

namespace fyd::station {
namespace {

using pipeline::LinkPhase;
using std::chrono::milliseconds;

class LinkOfARobot : public testing::Test {
 protected:
  LinkOfARobot()
      : robot(*protocol::UdpSocket::open(*protocol::parseEndpoint("127.0.0.2:0"))),
        link(*LinkThread::open(*protocol::parseEndpoint("127.0.0.1:0"), {})) {
    link->start();
  }
  void say(std::span<const std::uint8_t> bytes) { robot.send(bytes, link->local()); }
  /// Says a state until it is answered, which the end does at once.
  void state() {
    std::vector<std::uint8_t> buffer(protocol::kMaximumDatagram);
    const auto bytes = protocol::encodeState({.robot = {.stiffness_N_per_mm = 0.5}});
    while (robot.receive(buffer, Duration::zero())) continue;
    EXPECT_TRUE(comesTrue("an answer", [&] {
      say(bytes);
      const auto got = robot.receive(buffer, milliseconds(50));
      return got && got->size == protocol::kClassicTouchSize;
    }));
  }
  void running() {
    say(protocol::encodeAck());
    state();
    EXPECT_TRUE(comesTrue("the link to run", [&] { return link->snapshot.read().phase == LinkPhase::running; }));
  }

  protocol::UdpSocket robot;
  std::unique_ptr<LinkThread> link;
};

TEST_F(LinkOfARobot, ALossThatEndsBeforeTheLoopLooksIsTold) {
  running();
  std::this_thread::sleep_for(milliseconds(400));  // far longer than any limit for a robot that has said two states
  state();
  EXPECT_TRUE(comesTrue("the link to run again", [&] { return link->snapshot.read().phase == LinkPhase::running; }));
  EXPECT_EQ(link->snapshot.read().losses, 1U);
  EXPECT_EQ(link->status().figures.lost, 1U);
}

TEST_F(LinkOfARobot, AnotherRobotIsTold) {
  running();
  EXPECT_EQ(link->snapshot.read().sessions, 1U);
  running();
  EXPECT_EQ(link->snapshot.read().sessions, 2U);
}

TEST(SeenPhase, ALossAndANewSessionAreSeenForAStepEach) {
  SeenPhase seen;
  LinkSnapshot newest{.phase = LinkPhase::running, .losses = 1, .sessions = 1};
  const auto next = [&] { return seen.next(newest); };
  EXPECT_EQ(next(), LinkPhase::lost);
  EXPECT_EQ(next(), LinkPhase::waiting);
  EXPECT_EQ(next(), LinkPhase::running);
  newest.sessions = 2;  // restarted while it was paused, and runs
  EXPECT_EQ(next(), LinkPhase::waiting);
  EXPECT_EQ(next(), LinkPhase::running);
  newest.phase = LinkPhase::paused;
  EXPECT_EQ(next(), LinkPhase::paused);
}

}  // namespace
}  // namespace fyd::station
