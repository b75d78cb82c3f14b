// FYD Link over bad networks, in virtual time: loss, reordering, stalls, cuts.
#include <gtest/gtest.h>

#include "core/protocol/link_phase.h"
#include "tests/unit/protocol/link_pair.h"

namespace fyd::protocol {
namespace {

using pipeline::LinkPhase;

constexpr double kHour_s = 3'600.0;

TEST(LinkNetwork, AnHourAtFiveMillisecondsJitterAndOnePercentLossHasNoFalseStop) {
  LinkPair pair;
  pair.weather = {.delay_ms = 10.0, .jitter_ms = 10.0, .loss = 0.01};  // ±5 ms about 15
  ASSERT_TRUE(pair.connect());
  double loss_percent = 0.0;
  for (int second = 0; second < static_cast<int>(kHour_s); ++second) {
    pair.run(1.0);
    loss_percent += pair.touchpad.figures(pair.now).loss_percent / kHour_s;
  }
  EXPECT_EQ(pair.touchpad.counters().lost, 0U);
  EXPECT_EQ(pair.robot.counters().lost, 0U);
  EXPECT_EQ(pair.sessions, 1U);
  EXPECT_GT(static_cast<double>(pair.states), 0.95 * 100.0 * kHour_s);
  EXPECT_LT(pair.touchpad.lostLimit_ms(), 60.0);
  const LinkFigures figures = pair.touchpad.figures(pair.now);
  EXPECT_NEAR(loss_percent, 1.0, 0.2);  // the mean of what is shown, each of a second
  EXPECT_GT(figures.round_trip_ms, 20.0);
  EXPECT_LT(figures.round_trip_ms, 42.0);
  EXPECT_NEAR(figures.clock_offset_ms, 0.0, 5.0);  // at most half the best round trip's asymmetry
}

TEST(LinkNetwork, AnHourAtTwentyPercentLossAndTenPercentReorderStaysInOrder) {
  LinkPair pair;
  pair.weather = {.delay_ms = 5.0, .jitter_ms = 5.0, .loss = 0.2, .reorder = 0.1, .duplicate = 0.05};
  ASSERT_TRUE(pair.connect());
  std::uint16_t newest = 0;
  bool backwards = false;
  std::uint64_t asked = 0;
  pair.on_step = [&] {
    if (!pair.robot.touch()) return;
    const std::uint16_t sequence = pair.robot.touch()->sequence;
    backwards = backwards || static_cast<std::int16_t>(sequence - newest) < 0;
    newest = sequence;
    if (++asked % 1'000 == 0) static_cast<void>(pair.robot.command(pipeline::RobotCommand::vibration_up));
  };
  pair.run(kHour_s);
  EXPECT_FALSE(backwards);
  EXPECT_EQ(pair.sessions, 1U);
  EXPECT_GT(static_cast<double>(pair.states), 0.6 * 100.0 * kHour_s);
  EXPECT_NEAR(static_cast<double>(pair.commands.size()), std::floor(static_cast<double>(asked) / 1'000), 3.0);
  const auto& refusals = pair.touchpad.refusals();
  EXPECT_EQ(refusals[static_cast<std::size_t>(LinkRefusal::key)], 0U);
  EXPECT_GT(refusals[static_cast<std::size_t>(LinkRefusal::repeated)], 0U);
  EXPECT_GT(refusals[static_cast<std::size_t>(LinkRefusal::late)], 0U);
}

TEST(LinkNetwork, StallsOf637MillisecondsAreLossesAndNothingOldIsUsedAfterwards) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  pair.run(1.0);
  for (std::uint64_t i = 1; i <= 50; ++i) {
    pair.stalled = true;
    pair.run(0.637);
    EXPECT_EQ(pair.touchpad.phase(), LinkPhase::lost);
    EXPECT_EQ(pair.robot.phase(), RobotPhase::lost);
    pair.stalled = false;
    pair.keep_samples = true;
    pair.samples.clear();
    const auto stale = pair.touchpad.refusals()[static_cast<std::size_t>(LinkRefusal::stale)];
    pair.step();  // all at once
    EXPECT_GT(pair.touchpad.refusals()[static_cast<std::size_t>(LinkRefusal::stale)], stale + 25U);
    for (const auto& sample : pair.samples) EXPECT_LT(pair.now - sample.taken, std::chrono::milliseconds(330));
    pair.run(0.4);
    EXPECT_EQ(pair.touchpad.phase(), LinkPhase::running);
    EXPECT_EQ(pair.touchpad.counters().lost, i);
  }
  EXPECT_EQ(pair.sessions, 1U);
}

// At a random moment everything stops: lost is declared within the limit, and a millisecond of polling.
TEST(LinkNetwork, LostLinkIsNoticedWithinTheLimitAThousandTimes) {
  std::mt19937_64 random(6);
  LinkPair pair;
  pair.weather = {.delay_ms = 2.0, .jitter_ms = 5.0};
  ASSERT_TRUE(pair.connect());
  for (std::uint64_t i = 0; i < 1'000; ++i) {
    pair.run(0.1 + 1e-3 * static_cast<double>(random() % 60));
    ASSERT_EQ(pair.touchpad.phase(), LinkPhase::running);
    pair.cut = true;
    const Instant cut = pair.now;
    // What is under way still arrives, 7 ms later at most; heartbeats and states come every 5 ms.
    ASSERT_TRUE(pair.runUntil([&] { return pair.touchpad.phase() == LinkPhase::lost; }, 1.0)) << i;
    const double limit_ms = pair.touchpad.lostLimit_ms();
    EXPECT_GE(limit_ms, 30.0);
    EXPECT_LE(limit_ms, 60.0);
    EXPECT_LE(toMilliseconds(pair.now - cut), limit_ms + 7.0 + 1.0) << i;
    pair.run(1e-3 * static_cast<double>(random() % 500));
    EXPECT_EQ(pair.touchpad.phase(), LinkPhase::lost);  // nothing brings it back but the robot
    pair.cut = false;
    ASSERT_TRUE(pair.runUntil([&] { return pair.touchpad.phase() == LinkPhase::running; }, 5.0));
  }
  EXPECT_EQ(pair.touchpad.counters().lost, 1'000U);
}

TEST(LinkNetwork, RobotThatSendsHeartbeatsButNoStatesIsLost) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  pair.run(0.5);
  // Only short datagrams pass: states carry accelerations and are longer.
  std::vector<Packet> beats;
  pair.on_sent = [&](const Packet& bytes, const Endpoint& from) {
    if (from == LinkPair::kRobot && bytes.size() < 60) beats.push_back(bytes);
  };
  pair.cut = true;
  for (int i = 0; i < 200; ++i) {
    pair.step();
    for (const Packet& beat : beats) pair.giveTouchpad(beat);
    beats.clear();
  }
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::lost);
}

TEST(LinkNetwork, SatelliteAndSlowLinesWork) {
  LinkParameters parameters;
  parameters.lost_cap_ms = 500;
  parameters.freshness_ms = 1'000;
  LinkRobotSettings settings;
  settings.limits = parameters;
  settings.rates = {.state_Hz = 20, .touch_Hz = 20};
  LinkPair pair(parameters, settings);
  pair.weather = {.delay_ms = 300.0, .jitter_ms = 20.0, .loss = 0.02};
  ASSERT_TRUE(pair.connect());
  pair.run(60.0);
  EXPECT_EQ(pair.touchpad.counters().lost, 0U);
  EXPECT_NEAR(pair.touchpad.figures(pair.now).round_trip_ms, 620.0, 25.0);
}

}  // namespace
}  // namespace fyd::protocol
