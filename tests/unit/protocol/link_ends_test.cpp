// Both ends of FYD Link: sessions, commands, every phase with every message, peers that come and go.
#include <optional>

#include <gtest/gtest.h>

#include "app/bench/parts/allocation_count.h"
#include "core/protocol/link_phase.h"
#include "tests/unit/protocol/link_pair.h"

namespace fyd::protocol {
namespace {

using pipeline::LinkPhase;
using pipeline::RobotCommand;

std::uint64_t count(const LinkRefusalCounters& refusals, LinkRefusal refusal) {
  return refusals[static_cast<std::size_t>(refusal)];
}

TEST(LinkEnds, ConnectDescribeThemselvesAndExchangeAtTheNegotiatedRates) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  EXPECT_EQ(pair.robot.boardText(), "board");
  EXPECT_EQ(pair.robot.info().k_vib, 1.5);
  EXPECT_EQ(pair.robot.info().reference_ticks[1], -4200.0);
  EXPECT_EQ(pair.touchpad.peer(), LinkPair::kRobot);
  const auto states = pair.states;
  const auto touches = pair.touches;
  pair.run(10.0);
  EXPECT_NEAR(static_cast<double>(pair.states - states), 1'000.0, 3.0);
  EXPECT_NEAR(static_cast<double>(pair.touches - touches), 1'000.0, 3.0);
  EXPECT_NEAR(pair.robot.touch()->position_mm.x, 10.0, 0.0101);
  EXPECT_TRUE(pair.robot.touch()->in_contact);
  EXPECT_NEAR(*pair.robot.touch()->indentation_mm, 2.5, 1e-3);
  EXPECT_NEAR(pair.state.stiffness_N_per_mm, 0.62, 1e-6);
  EXPECT_NEAR(pair.state.force_N, 1.5, 1e-3);
  EXPECT_EQ(pair.touchpad.counters().lost, 0U);
  EXPECT_EQ(pair.robot.counters().refused, 0U);
}

TEST(LinkEnds, SlowerWishesAreGrantedAndTooSlowOnesAreNot) {
  LinkRobotSettings settings;
  settings.rates = {.state_Hz = 50, .touch_Hz = 20};
  LinkPair slow({}, settings);
  ASSERT_TRUE(slow.connect());
  EXPECT_EQ(slow.robot.rates().state_Hz, 50.0);
  EXPECT_EQ(slow.robot.rates().touch_Hz, 20.0);
  settings.rates.state_Hz = 1;  // three periods would not lie within the lost limit's cap
  LinkPair slower({}, settings);
  ASSERT_TRUE(slower.connect());
  EXPECT_EQ(slower.robot.rates().state_Hz, 30.0);
  LinkParameters isdn;
  isdn.flow_bit_per_s = 32'000;
  LinkPair line(isdn);
  ASSERT_TRUE(line.connect());
  EXPECT_LE(line.robot.rates().touch_Hz, 58.0);  // 43 + 28 bytes, 568 bit
  line.run(0.1);
  ASSERT_TRUE(line.robot.touch());
  EXPECT_FALSE(line.robot.touch()->indentation_mm);
}

// In the parameter's range, whatever the rate: the robot's own cap is 100 ms.
TEST(LinkEnds, TheSlowestTouchesThatCanBeSetKeepTheRobotsLink) {
  LinkParameters parameters;
  const std::vector<Parameter> bound = bindParameters(parameters);
  parameters.touch_rate_Hz = findParameter(bound, "link.touch_rate_Hz")->info.minimum;
  LinkPair pair(parameters);
  ASSERT_TRUE(pair.connect());
  pair.run(10.0);
  EXPECT_EQ(pair.robot.counters().lost, 0U);
}

TEST(LinkEnds, AtTenStatesASecondTheNewestThirtyTwoAccelerationsGoAndTheOthersAreCounted) {
  LinkPair pair(LinkParameters{.lost_cap_ms = 400.0, .state_rate_Hz = 10.0});  // three periods lie within the cap
  ASSERT_TRUE(pair.connect());
  pair.run(1.0);
  pair.keep_samples = true;
  const std::uint64_t states = pair.states, dropped = pair.robot.linkCounters().samples_dropped;
  pair.run(2.0);
  ASSERT_EQ(pair.states - states, 20U);
  EXPECT_EQ(pair.samples.size(), 20U * kMaximumBatch);
  EXPECT_NEAR(static_cast<double>(pair.robot.linkCounters().samples_dropped - dropped), 20.0 * (100 - 32), 100.0);
  for (std::size_t i = 1; i < pair.samples.size(); ++i) {  // one a millisecond, and a gap before each state's first
    const double gap_ms = i % kMaximumBatch == 0 ? 69.0 : 1.0;
    ASSERT_NEAR(toMilliseconds(pair.samples[i].taken - pair.samples[i - 1].taken), gap_ms, 0.02) << i;
  }
}

TEST(LinkEnds, AccelerationsArriveWithTheirOwnTimesOnTheTouchpadsClock) {
  LinkPair pair;
  pair.weather = {.delay_ms = 4.0};
  pair.robot_alive = false;
  pair.run(3.0);
  pair.robot_alive = true;
  ASSERT_TRUE(pair.connect());
  pair.run(1.0);
  pair.keep_samples = true;
  std::vector<Instant> taken;
  double phase = 0.0;
  pair.on_step = [&] {
    pair.report.acceleration_g = {std::sin(phase), 0.0, 0.0};
    phase += 0.1;
  };
  const Instant begin = pair.now;
  pair.run(2.0);
  pair.on_step = {};
  // One sample a millisecond, none lost, none twice, in order, each stamped with the time it was taken at.
  ASSERT_GT(pair.samples.size(), 1'950U);
  for (std::size_t i = 1; i < pair.samples.size(); ++i) {
    EXPECT_NEAR(toMilliseconds(pair.samples[i].taken - pair.samples[i - 1].taken), 1.0, 0.02);
  }
  std::size_t compared = 0;
  for (const auto& sample : pair.samples) {
    const double step = toMilliseconds(sample.taken - begin);
    if (step < 20.0) continue;
    // The value of the step it was taken in: the offset of the two clocks, 3 s here, is known to half a round trip.
    const double expected = std::sin(0.1 * (std::round(step) - 2.0));
    EXPECT_NEAR(sample.acceleration_g.x, expected, 2e-4);
    ++compared;
  }
  EXPECT_GT(compared, 1'900U);
  // The robot's program began 3 s later, so its session's clock is behind by that.
  EXPECT_NEAR(1e-6 * static_cast<double>(pair.touchpad.clock()->offset_us()), -3.0, 0.001);
}

TEST(LinkEnds, CommandsAreTakenOnceAndInOrderThoughHalfIsLost) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  pair.weather = {.delay_ms = 2.0, .jitter_ms = 5.0, .loss = 0.3, .reorder = 0.1, .duplicate = 0.2};
  std::vector<RobotCommand> asked;
  for (int round = 0; round < 10; ++round) {
    for (const RobotCommand command : {RobotCommand::vibration_up, RobotCommand::use_soc, RobotCommand::vibration_down,
                                       RobotCommand::use_dft321, RobotCommand::images_on, RobotCommand::images_off,
                                       RobotCommand::motor_reference_on, RobotCommand::motor_reference_off}) {
      ASSERT_TRUE(pair.robot.command(command));
      asked.push_back(command);
    }
    ASSERT_TRUE(pair.runUntil([&] { return pair.robot.linkCounters().commands == asked.size(); }, 20.0));
  }
  EXPECT_EQ(pair.commands, asked);
  EXPECT_GT(pair.touchpad.counters().repeated_commands, 0U);
}

TEST(LinkEnds, EachRepeatOfACommandIsCountedAndTheFirstIsNone) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  ASSERT_TRUE(pair.robot.command(RobotCommand::use_soc));
  ASSERT_TRUE(pair.runUntil([&] { return pair.robot.linkCounters().commands == 1; }, 1.0));
  EXPECT_EQ(pair.robot.linkCounters().command_repeats, 0U);
  pair.cut = true;
  ASSERT_TRUE(pair.robot.command(RobotCommand::use_dft321));
  for (int ms = 0; ms < 200; ++ms) pair.step();
  EXPECT_GE(pair.robot.linkCounters().command_repeats, 3U);  // each exactly when it is due, for a step is 1 ms
}

TEST(LinkEnds, PauseIsNegotiatedBringsTheInfoAndIsNoLoss) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  pair.answer.info.k_vib = 2.5;
  ASSERT_TRUE(pair.robot.command(RobotCommand::send_info_and_pause));
  ASSERT_TRUE(pair.runUntil([&] { return pair.robot.phase() == RobotPhase::paused; }, 1.0));
  EXPECT_EQ(pair.robot.info().k_vib, 2.5);
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::paused);
  pair.cut = true;
  pair.run(5.0);
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::paused);
  EXPECT_EQ(pair.touchpad.counters().lost, 0U);
  pair.cut = false;
  ASSERT_TRUE(pair.robot.command(RobotCommand::resume));
  ASSERT_TRUE(pair.runUntil([&] { return pair.robot.phase() == RobotPhase::running; }, 1.0));
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::running);
  pair.run(1.0);
  EXPECT_EQ(pair.touchpad.counters().lost, 0U);
}

TEST(LinkEnds, MotorReferencesArriveOnlyWhileTheyAreOn) {
  LinkPair pair;
  pair.report.motor_reference = {.first_ticks = 100, .second_ticks = -200};
  ASSERT_TRUE(pair.connect());
  pair.run(0.2);
  EXPECT_TRUE(pair.references.empty());
  pair.robot.command(RobotCommand::motor_reference_on);
  pair.run(0.5);
  ASSERT_FALSE(pair.references.empty());
  EXPECT_EQ(pair.references.back().second_ticks, -200.0);
  pair.robot.command(RobotCommand::motor_reference_off);
  pair.run(0.2);
  pair.references.clear();
  pair.run(0.2);
  EXPECT_TRUE(pair.references.empty());
}

TEST(LinkEnds, PicturesArriveWholeThoughFragmentsAreReorderedAndSomeLost) {
  LinkPair pair;
  Packet picture(50'000);
  for (std::size_t i = 0; i < picture.size(); ++i) picture[i] = static_cast<std::uint8_t>(i * i >> 3);
  ASSERT_TRUE(pair.connect());
  pair.answer.image = picture;
  pair.run(0.1);
  EXPECT_EQ(pair.images, 0U);  // nobody asked
  pair.robot.command(RobotCommand::images_on);
  ASSERT_TRUE(pair.runUntil([&] { return pair.images > 3; }, 2.0));
  EXPECT_EQ(Packet(pair.robot.image().begin(), pair.robot.image().end()), picture);
  pair.weather = {.delay_ms = 1.0, .loss = 0.01, .reorder = 0.002};
  pair.run(3.0);
  EXPECT_GT(pair.images, 10U);
  EXPECT_EQ(Packet(pair.robot.image().begin(), pair.robot.image().end()), picture);
  pair.robot.command(RobotCommand::images_off);
  pair.weather = {};
  pair.run(0.5);
  const auto before = pair.images;
  pair.run(0.5);
  EXPECT_EQ(pair.images, before);
}

TEST(LinkEnds, OfPicturesTheLargestArrivesAndALargerOneIsNotSent) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  pair.robot.command(RobotCommand::images_on);
  pair.run(0.5);
  EXPECT_EQ(pair.touchpad.counters().images, 0U) << "there is none yet";
  const Packet larger(kMaximumLinkImage + 1, 7);
  pair.answer.image = larger;
  pair.run(0.5);
  EXPECT_EQ(pair.touchpad.counters().images, 0U);
  const Packet largest(kMaximumLinkImage, 8);
  pair.answer.image = largest;
  ASSERT_TRUE(pair.runUntil([&] { return pair.images > 0; }, 2.0));
  EXPECT_EQ(Packet(pair.robot.image().begin(), pair.robot.image().end()), largest);
}

TEST(LinkEnds, PicturesGoOnInAPause) {
  LinkPair pair;
  const Packet picture(5'000, 7);
  ASSERT_TRUE(pair.connect());
  pair.answer.image = picture;
  pair.robot.command(RobotCommand::images_on);
  pair.robot.command(RobotCommand::send_info_and_pause);
  ASSERT_TRUE(pair.runUntil([&] { return pair.touchpad.phase() == LinkPhase::paused; }, 2.0));
  pair.run(0.1);
  const auto before = pair.images;
  pair.run(0.5);
  EXPECT_GT(pair.images, before + 10);
}

TEST(LinkEnds, ARobotThatIsLostGetsNoPicturesMore) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  const Packet picture(50'000, 0x55);
  pair.answer.image = picture;
  pair.robot.command(RobotCommand::images_on);
  ASSERT_TRUE(pair.runUntil([&] { return pair.images > 3; }, 2.0));
  pair.lost_on_the_way = [](const Packet&, const Endpoint& from) { return from == LinkPair::kRobot; };
  ASSERT_TRUE(pair.runUntil([&] { return pair.touchpad.phase() == LinkPhase::lost; }, 1.0));
  std::size_t largest = 0;
  pair.on_sent = [&](const Packet& packet, const Endpoint& from) {
    if (from == LinkPair::kTouchpad) largest = std::max(largest, packet.size());
  };
  pair.run(0.5);
  EXPECT_GT(largest, 0U) << "touches go on, for it to be heard again";
  EXPECT_LT(largest, 200U);
  pair.lost_on_the_way = nullptr;
  const auto before = pair.images;
  EXPECT_TRUE(pair.runUntil([&] { return pair.images > before + 3; }, 2.0));
}

// Somebody on the line drops the touches only, which their length tells, and lets them pass again.
TEST(LinkEnds, TouchesThatAloneStayedAwayAreAGapOfTheRobots) {
  for (const bool long_gap : {false, true}) {
    LinkPair pair;
    ASSERT_TRUE(pair.connect());
    std::size_t touch_bytes = 0;
    pair.on_sent = [&](const Packet& packet, const Endpoint& from) {
      if (from == LinkPair::kTouchpad) touch_bytes = std::max(touch_bytes, packet.size());
    };
    pair.run(0.5);
    const auto touches = pair.touches;
    pair.lost_on_the_way = [&](const Packet& packet, const Endpoint& from) {
      return from == LinkPair::kTouchpad && packet.size() == touch_bytes;
    };
    pair.run(long_gap ? 0.3 : 0.05);
    EXPECT_EQ(pair.robot.phase(), RobotPhase::running) << "heartbeats come";
    EXPECT_LE(pair.touches, touches + 3);
    EXPECT_EQ(pair.robot.counters().lost, 0U);
    pair.lost_on_the_way = nullptr;
    pair.run(0.3);
    EXPECT_GT(pair.touches, touches + 10);
    EXPECT_EQ(pair.robot.counters().lost, long_gap ? 1U : 0U);
  }
}

// So long that a 16-bit number of the states goes half round.
TEST(LinkEnds, AfterALongOutageOfOneWayTheNextStateIsTaken) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  pair.lost_on_the_way = [](const Packet&, const Endpoint& from) { return from == LinkPair::kRobot; };
  const auto said = pair.robot.counters().states;
  ASSERT_TRUE(pair.runUntil([&] { return pair.robot.counters().states - said > 40'000; }, 500.0));
  ASSERT_EQ(pair.touchpad.phase(), LinkPhase::lost);
  ASSERT_EQ(pair.robot.phase(), RobotPhase::running);
  pair.lost_on_the_way = nullptr;
  pair.run(0.2);
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::running);
  EXPECT_EQ(pair.sessions, 1U);
}

TEST(LinkEnds, GoodbyeOfTheRobotClosesAndANewHandshakeOpens) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  pair.robot.command(RobotCommand::disconnect);
  pair.run(0.1);
  EXPECT_EQ(pair.robot.phase(), RobotPhase::closed);
  EXPECT_FALSE(pair.robot.replyDue());
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::closed);
  const auto touches = pair.touchpad.counters().touches;
  pair.run(0.5);
  EXPECT_EQ(pair.touchpad.counters().touches, touches);
  pair.robot = LinkRobotEnd({}, testKey(), LinkPair::kTouchpad, seededRandom);
  ASSERT_TRUE(pair.connect());
  EXPECT_EQ(pair.sessions, 2U);
}

// Its goodbye is lost, and the touchpad must not take what still comes for a robot that follows.
TEST(LinkEnds, ARobotThatHasSaidGoodbyeSendsNothingMore) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  pair.robot.command(RobotCommand::disconnect);
  pair.cut = true;
  pair.run(0.1);
  ASSERT_EQ(pair.robot.phase(), RobotPhase::closed);
  pair.cut = false;
  pair.run(1.0);
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::lost);
}

TEST(LinkEnds, GoodbyeOfTheTouchpadSendsTheRobotBackToCalling) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  std::vector<Packet> farewell;
  for (const Datagram& datagram : pair.touchpad.farewell(pair.now)) {
    farewell.emplace_back(datagram.bytes.begin(), datagram.bytes.end());
  }
  ASSERT_EQ(farewell.size(), 3U);
  static_cast<void>(pair.giveRobot(farewell[1]));
  EXPECT_EQ(pair.robot.phase(), RobotPhase::handshake);
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::closed);
  ASSERT_TRUE(pair.connect());  // it comes again when it is called again
}

TEST(LinkEnds, EveryPhaseWithEveryMessageFollowsTheTable) {
  for (const LinkPhase phase : {LinkPhase::running, LinkPhase::paused, LinkPhase::closed, LinkPhase::lost}) {
    for (int type = 0; type <= 9; ++type) {
      LinkPair pair;
      // The robot is played by hand.
      const LinkKey key = testKey();
      HelloNonce nonce{};
      seededRandom(nonce);
      Cookie cookie{};
      const auto reply = [&](Bytes datagram) {
        const auto& got = pair.touchpad.handle(datagram, LinkPair::kRobot, pair.now, pair.answer);
        return got.replies.empty() ? Packet{} : Packet(got.replies[0].bytes.begin(), got.replies[0].bytes.end());
      };
      ASSERT_EQ(readChallenge(key, reply(makeHello(key, nonce)), nonce, cookie), LinkRefusal::none);
      Caller caller(key, cookie, seededRandom);
      std::array<std::uint8_t, kMaximumLinkDatagram> buffer{};
      const std::size_t call = caller.write(vectorBytes("robot_hello"), buffer);
      std::array<std::uint8_t, kMaximumLinkDatagram> plain{};
      const auto payload = caller.read(reply(Bytes(buffer).first(call)), plain);
      ASSERT_TRUE(payload);
      const auto hello = decodeTouchpadHello(*payload);
      ASSERT_TRUE(hello.ok());
      const SessionKeys keys = caller.keys();
      Sealer sealer(keys.from_initiator, sessionOf(keys));
      const LinkTime skew = 77'000'000;  // the robot's clock
      const auto ownTime = [&] {
        return skew + static_cast<LinkTime>(
                          std::chrono::duration_cast<std::chrono::microseconds>(pair.now.time_since_epoch()).count());
      };
      const auto give = [&](auto&& write) {
        Packet out(kMaximumLinkDatagram);
        out.resize(sealer.seal(out, write(Sealer::messagePart(out))));
        return pair.touchpad.handle(out, LinkPair::kRobot, pair.now, pair.answer);
      };
      const PositionCode code = *PositionCode::make(asOnTheWire(RobotHello{}.workspace));
      std::uint16_t sequence = 0;
      const auto state = [&](auto out) { return encodeLink(LinkState{.sequence = ++sequence}, code, ownTime(), out); };
      std::uint16_t id = 0;
      const auto command = [&](RobotCommand what) {
        return [&, what](auto out) { return encodeLink(LinkCommand{.id = ++id, .command = what}, ownTime(), out); };
      };
      const auto wait = [&](int ms) {
        pair.now += std::chrono::milliseconds(ms);
        static_cast<void>(pair.touchpad.advance(pair.now, pair.answer));
      };
      give([&](auto out) { return encodeLink(LinkHeartbeat{.echo_us = hello.value.sent_us}, ownTime(), out); });
      EXPECT_EQ(pair.touchpad.phase(), LinkPhase::waiting);
      give(state);  // too soon: who polls the phase must see the new session first
      EXPECT_EQ(pair.touchpad.phase(), LinkPhase::waiting);
      wait(6);
      give(state);
      ASSERT_EQ(pair.touchpad.phase(), LinkPhase::running);
      if (phase == LinkPhase::paused) give(command(RobotCommand::send_info_and_pause));
      if (phase == LinkPhase::closed) give([&](auto out) { return encodeLink(LinkGoodbye{}, ownTime(), out); });
      if (phase == LinkPhase::lost) wait(150);
      ASSERT_EQ(pair.touchpad.phase(), phase);

      wait(1);
      const auto refused_before = pair.touchpad.refusals();
      const auto got = [&] {
        switch (type) {
          case 0: return give(state);
          case 1: return give(command(RobotCommand::vibration_up));
          case 2: return give(command(RobotCommand::send_info_and_pause));
          case 3: return give(command(RobotCommand::resume));
          case 4:
            return give(
                [&](auto out) { return encodeLink(LinkHeartbeat{.echo_us = hello.value.sent_us}, ownTime(), out); });
          case 5: return give([&](auto out) { return encodeLink(LinkGoodbye{}, ownTime(), out); });
          case 6: return give([&](auto out) { return encodeLink(LinkTouch{}, code, ownTime(), out); });
          case 7: return give([&](auto out) { return encodeLink(LinkCommandAck{.id = 1}, ownTime(), out); });
          case 8: return give([&](auto out) { return encodeLink(LinkInfo{}, ownTime(), out); });
          default:
            return give([&](auto out) {
              return encodeLink(LinkImageFragment{.size = 1, .bytes = Bytes(vectorBytes("goodbye")).first(1)},
                                ownTime(), out);
            });
        }
      }();
      LinkPhase expected = phase;
      if (phase != LinkPhase::closed) {
        if (type == 0 && phase == LinkPhase::lost) expected = LinkPhase::running;
        if (type == 2) expected = LinkPhase::paused;
        if (type == 3) expected = LinkPhase::running;
        if (type == 5) expected = LinkPhase::closed;
      }
      EXPECT_EQ(pair.touchpad.phase(), expected) << "phase " << int(phase) << " message " << type;
      const bool closed = phase == LinkPhase::closed;
      EXPECT_EQ(got.state.has_value(), type == 0 && !closed);
      EXPECT_EQ(got.command != RobotCommand::none, type >= 1 && type <= 3 && !closed);
      const bool wrong_way = type >= 6;
      const LinkRefusal why = closed ? LinkRefusal::phase : LinkRefusal::message;
      const bool refused = wrong_way || (closed && type != 4);
      EXPECT_EQ(count(pair.touchpad.refusals(), why) - count(refused_before, why), refused ? 1U : 0U) << type;
    }
  }
}

TEST(LinkEnds, SecondRobotIsToldSoAndTakesOverOnlyAfterSilence) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  const Endpoint other = linkAddress(2);
  LinkRobotEnd second({}, testKey(), LinkPair::kTouchpad, seededRandom);
  const auto exchange = [&] {
    for (const Datagram& datagram : second.tick(pair.now, {})) {
      const Packet bytes(datagram.bytes.begin(), datagram.bytes.end());
      const auto& got = pair.touchpad.handle(bytes, other, pair.now, pair.answer);
      std::vector<Packet> replies;
      replies.reserve(got.replies.size());
      for (const Datagram& reply : got.replies) replies.emplace_back(reply.bytes.begin(), reply.bytes.end());
      for (const Packet& reply : replies) static_cast<void>(second.handle(reply, LinkPair::kTouchpad, pair.now));
    }
  };
  pair.on_step = exchange;
  pair.run(3.0);
  EXPECT_EQ(second.phase(), RobotPhase::handshake);
  EXPECT_EQ(second.lastStatus(), CallStatus::second_robot);
  EXPECT_EQ(second.problem(), "another robot is served");
  EXPECT_EQ(pair.touchpad.peer(), LinkPair::kRobot);
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::running);
  EXPECT_EQ(pair.touchpad.counters().lost, 0U);
  EXPECT_GE(count(pair.touchpad.refusals(), LinkRefusal::second_robot), 2U);
  pair.robot_alive = false;
  EXPECT_TRUE(pair.runUntil([&] { return pair.touchpad.peer() == other; }, 4.0));
}

TEST(LinkEnds, PeerRestartedAHundredTimesGetsANewSessionEachTime) {
  LinkPair pair;
  pair.weather = {.delay_ms = 1.0, .jitter_ms = 2.0, .loss = 0.05};
  for (std::uint64_t i = 1; i <= 100; ++i) {
    pair.robot = LinkRobotEnd({}, testKey(), LinkPair::kTouchpad, seededRandom);
    ASSERT_TRUE(pair.runUntil([&] { return pair.sessions == i; }, 10.0)) << i;
    const auto states = pair.states;
    ASSERT_TRUE(pair.runUntil([&] { return pair.states > states + 5; }, 1.0)) << i;
    EXPECT_EQ(pair.touchpad.phase(), LinkPhase::running);
  }
}

TEST(LinkEnds, RestartedTouchpadIsCalledAgain) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  for (int i = 0; i < 10; ++i) {
    pair.touchpad = LinkTouchpadEnd({}, testKey(), seededRandom);
    ASSERT_TRUE(pair.runUntil([&] { return pair.touchpad.phase() == LinkPhase::running; }, 5.0)) << i;
  }
  EXPECT_EQ(pair.robot.linkCounters().sessions, 11U);
}

TEST(LinkEnds, WithoutTheKeyThePortIsSilent) {
  LinkPair pair({}, {}, testKey(1));
  pair.run(5.0);
  EXPECT_EQ(pair.touchpad.counters().hellos, 0U);
  EXPECT_GE(count(pair.touchpad.refusals(), LinkRefusal::key), 10U);
  EXPECT_EQ(pair.robot.counters().refused, 0U);  // nothing came back at all
  EXPECT_EQ(pair.robot.problem(), "no touchpad with this key answered");
  EXPECT_FALSE(pair.touchpad.peer());
  // Nor does the classic protocol get an answer here.
  const std::string ack = "ACK";
  EXPECT_TRUE(
      pair.touchpad
          .handle({reinterpret_cast<const std::uint8_t*>(ack.data()), 3}, LinkPair::kRobot, pair.now, pair.answer)
          .replies.empty());
}

// Everything that was ever sent is sent again, at once, later, from another address, and to the other end.
TEST(LinkEnds, ReplayReflectionAndCrossSessionReuseChangeNothing) {
  LinkPair pair;
  std::vector<std::pair<Packet, Endpoint>> heard;
  pair.on_sent = [&](const Packet& bytes, const Endpoint& from) { heard.emplace_back(bytes, from); };
  ASSERT_TRUE(pair.connect());
  pair.robot.command(RobotCommand::vibration_up);
  pair.run(1.0);
  pair.on_sent = {};
  pair.run(0.01);  // what is under way arrives
  const auto old = heard;
  const auto replayAll = [&] {
    const auto sessions = pair.sessions;
    const auto commands = pair.commands.size();
    const auto states = pair.touchpad.counters().states;
    const auto touches = pair.robot.counters().touches;
    for (const auto& [bytes, from] : old) {
      for (const Endpoint& sender : {from, linkAddress(9), LinkPair::kRobot}) {
        pair.giveTouchpad(bytes, sender);
        static_cast<void>(pair.giveRobot(bytes, LinkPair::kTouchpad));
      }
    }
    EXPECT_EQ(pair.sessions, sessions);
    EXPECT_EQ(pair.commands.size(), commands);
    EXPECT_EQ(pair.touchpad.counters().states, states);
    EXPECT_EQ(pair.robot.counters().touches, touches);
    EXPECT_EQ(pair.robot.phase(), RobotPhase::running);
    EXPECT_EQ(pair.touchpad.phase(), LinkPhase::running);
  };
  replayAll();
  pair.run(20.0);  // cookies are old now
  replayAll();
  pair.robot = LinkRobotEnd({}, testKey(), LinkPair::kTouchpad, seededRandom);  // another session
  ASSERT_TRUE(pair.runUntil([&] { return pair.sessions == 2; }, 5.0));
  ASSERT_TRUE(pair.connect());
  pair.run(0.1);
  replayAll();
  pair.run(1.0);
  EXPECT_EQ(pair.touchpad.counters().lost, 0U);
  pair.touchpad = LinkTouchpadEnd({}, testKey(), seededRandom);  // it forgot everything but the key
  for (const auto& [bytes, from] : old) pair.giveTouchpad(bytes, from);
  EXPECT_FALSE(pair.touchpad.peer());
  EXPECT_EQ(pair.touchpad.counters().calls, 0U);
}

// A replayed call with a cookie that is still good occupies the waiting place at most; the session goes on.
TEST(LinkEnds, FreshCallThatIsNeverConfirmedEndsNoSession) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  LinkRobotEnd impostor({}, testKey(), LinkPair::kTouchpad, seededRandom);
  for (int i = 0; i < 300; ++i) {
    for (const Datagram& datagram : impostor.tick(pair.now, {})) {
      const Packet bytes(datagram.bytes.begin(), datagram.bytes.end());
      const auto& got = pair.touchpad.handle(bytes, LinkPair::kRobot, pair.now, pair.answer);  // a spoofed address
      if (got.replies.empty() || got.replies[0].bytes[1] != versionAndKind(LinkKind::challenge)) continue;
      const Packet reply(got.replies[0].bytes.begin(), got.replies[0].bytes.end());
      static_cast<void>(impostor.handle(reply, LinkPair::kTouchpad, pair.now));
    }
    pair.run(0.01);
  }
  EXPECT_GT(pair.touchpad.counters().calls, 1U);
  EXPECT_EQ(pair.touchpad.counters().sessions, 1U);
  EXPECT_EQ(pair.touchpad.counters().lost, 0U);
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::running);
}

TEST(LinkEnds, DelayedMessagesAreStale) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  pair.run(1.0);
  std::vector<std::pair<Instant, Packet>> held;
  pair.on_sent = [&](const Packet& bytes, const Endpoint& from) {
    if (from == LinkPair::kRobot) held.emplace_back(pair.now, bytes);
  };
  pair.cut = true;
  pair.run(1.0);
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::lost);
  const auto states = pair.touchpad.counters().states;
  for (const auto& [sent, bytes] : held) {
    if (pair.now - sent > std::chrono::milliseconds(310)) pair.giveTouchpad(bytes);
  }
  EXPECT_EQ(pair.touchpad.counters().states, states);
  EXPECT_EQ(pair.touchpad.phase(), LinkPhase::lost);
  EXPECT_GT(count(pair.touchpad.refusals(), LinkRefusal::stale), 60U);
}

// An attacker who holds the answer back must not make old touches look fresh.
TEST(LinkEnds, HandshakeThatTookTooLongTellsNothingOfTheClocks) {
  LinkPair pair;
  pair.weather.delay_ms = 450.0;  // a round trip of 900 ms where 600 are allowed
  ASSERT_TRUE(pair.runUntil([&] { return pair.robot.connection() != nullptr; }, 5.0));
  EXPECT_FALSE(pair.robot.connection()->clock().known());
  pair.run(0.9);
  EXPECT_EQ(pair.touches, 0U);
  EXPECT_EQ(pair.states, 0U);
}

TEST(LinkEnds, ClockJumpsOfEitherEndAreSurvivedWithoutUsingOldMessages) {
  for (const bool robot : {true, false}) {
    for (const double jump_s : {3'600.0, -3'600.0, 0.6, -0.6, 1e9}) {
      LinkPair pair;
      ASSERT_TRUE(pair.connect());
      pair.run(1.0);
      (robot ? pair.robot_clock : pair.touchpad_clock) += fromSeconds(jump_s);
      pair.run(3.0);
      EXPECT_TRUE(pair.runUntil(
          [&] { return pair.touchpad.phase() == LinkPhase::running && pair.robot.phase() == RobotPhase::running; },
          5.0))
          << (robot ? "robot " : "touchpad ") << jump_s;
      const auto states = pair.states;
      pair.run(1.0);
      EXPECT_GT(pair.states, states + 90);
    }
  }
}

TEST(LinkEnds, TimeThatStandsStillOrRunsBackwardsInEveryCallIsHarmless) {
  for (const bool robot : {true, false}) {
    for (const int back_ms : {1, 2}) {  // of a clock that goes on by one in each step
      SCOPED_TRACE(fmt::format("{} {}", robot ? "robot" : "touchpad", back_ms));
      LinkPair pair;
      ASSERT_TRUE(pair.connect());
      pair.on_step = [&] { (robot ? pair.robot_clock : pair.touchpad_clock) -= std::chrono::milliseconds(back_ms); };
      pair.run(1.0);
      pair.on_step = {};
      EXPECT_TRUE(pair.runUntil(
          [&] { return pair.touchpad.phase() == LinkPhase::running && pair.robot.phase() == RobotPhase::running; },
          5.0));
      const auto states = pair.states;
      pair.run(1.0);
      EXPECT_GT(pair.states, states + 90);
    }
  }
}

TEST(LinkEnds, RunningExchangeDoesNotAllocate) {
  LinkTouchpadEnd touchpad({}, testKey(), seededRandom);
  LinkRobotEnd robot({}, testKey(), LinkPair::kTouchpad, seededRandom);
  TouchpadAnswer answer;
  const Packet picture(9'000, 1);
  answer.image = picture;
  answer.board_text = "board";
  Instant now = instantAt(5.0);
  std::optional<bench::AllocationCount> counted;
  robot.command(RobotCommand::images_on);
  for (int i = 0; i < 2'000; ++i) {
    if (i == 1) counted.emplace();  // handshake and all that follows
    now += std::chrono::milliseconds(1);
    for (const Datagram& d : robot.tick(now, {})) {
      for (const Datagram& r : touchpad.handle(d.bytes, LinkPair::kRobot, now, answer).replies) {
        static_cast<void>(robot.handle(r.bytes, LinkPair::kTouchpad, now));
      }
    }
    for (const Datagram& d : touchpad.advance(now, answer)) {
      static_cast<void>(robot.handle(d.bytes, LinkPair::kTouchpad, now));
    }
  }
  EXPECT_EQ(counted->count(), 0U);
  EXPECT_GT(robot.counters().touches, 150U);
  EXPECT_GT(robot.counters().images, 10U);
}

TEST(LinkPhases, RobotsTableNeverMovesByItselfAndEndsOnlyClosed) {
  for (std::size_t e = 0; e < kRobotEventCount; ++e) {
    EXPECT_EQ(nextPhase(RobotPhase::closed, static_cast<RobotEvent>(e)), RobotPhase::closed);
  }
  EXPECT_EQ(nextPhase(RobotPhase::paused, RobotEvent::silence), RobotPhase::paused);
  EXPECT_EQ(nextPhase(RobotPhase::running, RobotEvent::silence), RobotPhase::lost);
  EXPECT_EQ(nextPhase(RobotPhase::lost, RobotEvent::heard), RobotPhase::running);
  EXPECT_EQ(nextPhase(RobotPhase::running, RobotEvent::goodbye), RobotPhase::handshake);
}

}  // namespace
}  // namespace fyd::protocol
