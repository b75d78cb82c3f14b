// What the haptic loop is told of a link that changes faster than it looks: a robot by hand, over real sockets.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <thread>
#include <vector>

#include "core/protocol/classic/classic_codec.h"
#include "core/protocol/udp_socket.h"
#include "core/station/link_thread.h"
#include "tests/unit/protocol/link_pair.h"
#include "tests/wait.h"

namespace fyd::station {
namespace {

using pipeline::LinkPhase;
using std::chrono::milliseconds;

class LinkOfARobot : public testing::Test {
 protected:
  explicit LinkOfARobot(const protocol::LinkParameters& parameters = {})
      : robot(*protocol::UdpSocket::open(*protocol::parseEndpoint("127.0.0.2:0"))),
        link(*LinkThread::open(*protocol::parseEndpoint("127.0.0.1:0"), parameters)) {
    link->start();
  }
  void say(std::span<const std::uint8_t> bytes) { robot.send(bytes, link->local()); }
  /// Says a state until it is answered, which the end does at once.
  void state(pipeline::RobotCommand command = pipeline::RobotCommand::none) {
    std::vector<std::uint8_t> buffer(protocol::kMaximumDatagram);
    const auto bytes = protocol::encodeState({.command = command, .robot = {.stiffness_N_per_mm = 0.5}});
    while (robot.receive(buffer, Duration::zero())) continue;
    EXPECT_TRUE(comesTrue("an answer", [&] {
      say(bytes);
      const auto got = robot.receive(buffer, milliseconds(50));
      return got && got->size == protocol::kClassicTouchSize;
    }));
  }
  void running() {
    say(protocol::encodeAck());
    becomesRunning("the link to run");
  }
  /// By states until it does: one lasts for the lost limit only, and whoever looks may stand still for longer.
  void becomesRunning(std::string_view what) {
    EXPECT_TRUE(comesTrue(what, [&] {
      state();
      return link->snapshot.read().phase == LinkPhase::running;
    }));
  }

  protocol::UdpSocket robot;
  std::unique_ptr<LinkThread> link;
};

TEST_F(LinkOfARobot, ALossThatEndsBeforeTheLoopLooksIsTold) {
  running();
  const std::uint64_t before = link->snapshot.read().losses;
  std::this_thread::sleep_for(milliseconds(400));  // far longer than any limit
  becomesRunning("the link to run again");
  // Answers go out before the snapshot is written: what runs may be the link of before.
  EXPECT_TRUE(comesTrue("the loss", [&] { return link->snapshot.read().losses > before; }));
  EXPECT_TRUE(comesTrue("as many losses in the status",
                        [&] { return link->snapshot.read().losses == link->status().figures.lost; }));
}

TEST_F(LinkOfARobot, AnotherRobotIsTold) {
  running();
  EXPECT_EQ(link->snapshot.read().sessions, 1U);
  running();
  // Answers go out before the snapshot is written: what runs may be the first session yet.
  EXPECT_TRUE(comesTrue("the second session", [&] { return link->snapshot.read().sessions > 1U; }));
  EXPECT_EQ(link->snapshot.read().sessions, 2U);
}

protocol::LinkParameters withImages() {
  protocol::LinkParameters out;
  out.classic_images = true;
  return out;
}

class PicturesOfARobot : public LinkOfARobot {
 protected:
  PicturesOfARobot() : LinkOfARobot(withImages()) {}
  /// Of one state: the picture among its answers, up to the last of them; nothing while there is no answer.
  std::optional<std::vector<std::uint8_t>> pictureAfterAState() {
    std::vector<std::uint8_t> buffer(protocol::kMaximumDatagram), out;
    while (robot.receive(buffer, Duration::zero())) continue;
    say(protocol::encodeState({.robot = {.stiffness_N_per_mm = 0.5}}));
    for (;;) {
      const auto got = robot.receive(buffer, kPatience);
      if (!got) return std::nullopt;
      const std::span bytes(buffer.data(), got->size);
      if (const auto length = protocol::decodeImageLength(bytes); length.ok() && length.value == 0) return out;
      if (got->size == protocol::kClassicTouchSize || got->size == protocol::kClassicImageLengthSize) continue;
      out.insert(out.end(), bytes.begin(), bytes.end());
      return out;
    }
  }
};

TEST_F(PicturesOfARobot, APictureGoesOutOnceWhoeverElseSpeaksBefore) {
  running();
  state(pipeline::RobotCommand::images_on);
  ASSERT_TRUE(comesTrue("the wish for pictures", [&] { return link->wantsImages(); }));
  const std::vector<std::uint8_t> picture(777, 42);
  link->offerImage(picture);
  auto stranger = std::move(*protocol::UdpSocket::open(*protocol::parseEndpoint("127.0.0.3:0")));
  const auto refused = link->status().refused;
  stranger.send(picture, link->local());
  ASSERT_TRUE(comesTrue("the stranger to be refused", [&] { return link->status().refused > refused; }));
  EXPECT_EQ(pictureAfterAState(), picture);
  EXPECT_EQ(pictureAfterAState(), std::vector<std::uint8_t>{});
}

/// Both ends of a link, asked twenty times a second how long the texture is to wait.
struct WatchedDelay {
  explicit WatchedDelay(const protocol::LinkParameters& parameters = {}) : pair(parameters) {}
  void run(double seconds) {
    for (int i = 0; i < static_cast<int>(std::lround(20.0 * seconds)); ++i) {
      pair.run(0.05);
      const protocol::LinkFigures figures = pair.touchpad.figures(pair.now);
      told_ms = needed.add(figures);
      most_ms = std::max(most_ms, figures.sample_delay_ms);
      most_told_ms = std::max(most_told_ms, told_ms);
    }
  }
  protocol::LinkPair pair;
  NeededDelay needed;
  double told_ms = 0.0;
  double most_told_ms = 0.0;
  double most_ms = 0.0;  ///< that the figures asked for
};

// What the texture waits for stays raised, so only what lasts may raise it.
TEST(NeededDelay, OneLateMomentOfTheNetworkRaisesNothingAndAWorseNetworkDoes) {
  WatchedDelay watched;
  ASSERT_TRUE(watched.pair.connect());
  watched.run(0.9);
  EXPECT_EQ(watched.told_ms, 0.0);
  watched.run(3.0);
  const double usual_ms = watched.told_ms;
  EXPECT_GE(usual_ms, 10.0);  // the batches'
  EXPECT_LE(usual_ms, 15.0);
  EXPECT_LT(watched.most_ms, 100.0);
  watched.pair.weather.delay_ms = 400.0;  // for one heartbeat and one state
  watched.pair.run(0.01);
  watched.pair.weather.delay_ms = 1.0;
  watched.run(5.0);
  EXPECT_GT(watched.most_ms, 100.0);
  EXPECT_EQ(watched.most_told_ms, usual_ms);
  watched.pair.weather.delay_ms = 400.0;  // for the last heartbeat before an outage
  watched.pair.run(0.01);
  watched.pair.cut = true;
  watched.run(3.0);
  EXPECT_GT(watched.pair.touchpad.figures(watched.pair.now).sample_delay_ms, 100.0) << "the last that is known";
  EXPECT_NE(watched.pair.touchpad.phase(), LinkPhase::running);
  watched.pair.weather.delay_ms = 1.0;
  watched.pair.cut = false;
  ASSERT_TRUE(watched.pair.connect());
  watched.run(5.0);
  EXPECT_EQ(watched.most_told_ms, usual_ms);
  watched.pair.weather.delay_ms = 40.0;
  watched.run(3.0);
  EXPECT_GE(watched.told_ms, usual_ms + 35.0);
}

// The jitter forgets a late moment with the messages, not with the time.
TEST(NeededDelay, OneLateMomentOfASlowLinkRaisesNothingEither) {
  for (const double rate_Hz : {50.0, 30.0, 20.0}) {
    WatchedDelay watched({.lost_cap_ms = 200.0, .state_rate_Hz = rate_Hz, .touch_rate_Hz = rate_Hz});
    ASSERT_TRUE(watched.pair.connect()) << rate_Hz;
    watched.run(8.0);
    const double usual_ms = watched.told_ms;
    EXPECT_GE(usual_ms, 1e3 / rate_Hz);
    watched.pair.weather.delay_ms = 300.0;
    watched.pair.run(1.0 / rate_Hz);
    watched.pair.weather.delay_ms = 1.0;
    watched.run(15.0);
    EXPECT_GT(watched.most_ms, usual_ms + 40.0) << rate_Hz;
    EXPECT_EQ(watched.most_told_ms, usual_ms) << rate_Hz;
  }
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
