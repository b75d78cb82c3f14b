// Both ends of a classic session in virtual time, without sockets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <string_view>

#include "app/bench/parts/allocation_count.h"
#include "core/protocol/classic/classic_robot_end.h"
#include "core/protocol/classic/classic_touchpad_end.h"
#include "core/protocol/touch_mapping.h"
#include "tests/unit/protocol/classic_text.h"

namespace fyd::protocol {
namespace {

using pipeline::LinkPhase;
using pipeline::RobotCommand;

Endpoint address(int host, int port = kClassicPort) {
  return parseEndpoint(fmt::format("10.0.0.{}:{}", host, port)).value();
}
const Endpoint kRobot = address(1);
const Endpoint kOther = address(2);
const Endpoint kTouchpad = address(100);

// The touchpad's end with its clock, fed by hand.
class Touchpad {
 public:
  explicit Touchpad(const LinkParameters& parameters = {}) : end(parameters) {
    answer.touch = {.position_mm = {10, -5, -2}, .in_contact = true, .force_N = 1.0};
    answer.info = {.k_vib = 1.0, .reference_ticks = {4200, -4200}};
    answer.board_text = "board";
  }

  const TouchpadReception& take(Bytes datagram, const Endpoint& from = kRobot) {
    return end.handle(datagram, from, now, answer);
  }
  const TouchpadReception& ack(const Endpoint& from = kRobot) { return take(encodeAck(), from); }
  const TouchpadReception& state(RobotCommand command = RobotCommand::none, const Endpoint& from = kRobot) {
    wait(1);
    return take(encodeState({.command = command, .acceleration_g = {0.5, 0, 0}, .robot = {.stiffness_N_per_mm = 0.6}}),
                from);
  }
  void wait(double ms) {
    now += fromSeconds(ms * 1e-3);
    end.advance(now);
  }
  void connect() {
    static_cast<void>(ack());
    static_cast<void>(state());
  }

  Instant now = instantAt(100.0);
  TouchpadAnswer answer;
  ClassicTouchpadEnd end;
};

std::vector<std::string> sent(const TouchpadReception& reception) {
  std::vector<std::string> out;
  out.reserve(reception.replies.size());
  for (const Datagram& datagram : reception.replies) out.push_back(text(datagram.bytes));
  return out;
}

using ::testing::ElementsAre;

TEST(ClassicTouchpad, AnswersTheHandshakeWithTheInfoTriple) {
  Touchpad pad;
  EXPECT_EQ(pad.end.phase(), LinkPhase::waiting);
  const auto& reception = pad.ack();
  EXPECT_TRUE(reception.session_started);
  EXPECT_THAT(sent(reception), ElementsAre("00005", "board", "^010^0'04200^1'04200"));
  EXPECT_EQ(reception.replies[0].to, kRobot);
  EXPECT_EQ(pad.end.peer(), kRobot);
  EXPECT_EQ(pad.end.phase(), LinkPhase::waiting);
  static_cast<void>(pad.state());
  EXPECT_EQ(pad.end.phase(), LinkPhase::running);
}

TEST(ClassicTouchpad, BoardTextIsCutAndNeverEmpty) {
  Touchpad pad;
  const std::string long_text(2000, 'b');
  pad.answer.board_text = long_text;
  EXPECT_THAT(sent(pad.ack()), ElementsAre("01209", long_text.substr(0, 1209), "^010^0'04200^1'04200"));
  pad.answer.board_text = "";
  EXPECT_THAT(sent(pad.ack()), ElementsAre("00001", "-", "^010^0'04200^1'04200"));
}

TEST(ClassicTouchpad, GivesWhatAStateSaysWithItsArrivalTime) {
  Touchpad pad;
  pad.connect();
  const auto& reception = pad.state(RobotCommand::vibration_up);
  EXPECT_THAT(sent(reception), ElementsAre(kTouch));
  EXPECT_EQ(reception.command, RobotCommand::vibration_up);
  ASSERT_TRUE(reception.state && reception.accelerations.size() == 1);
  EXPECT_NEAR(reception.state->stiffness_N_per_mm, 0.6, 1e-12);
  EXPECT_TRUE(std::isnan(reception.state->force_N)) << "it has no place for it";
  EXPECT_EQ(reception.accelerations[0].taken, pad.now);
  EXPECT_NEAR(reception.accelerations[0].acceleration_g.x, 0.5, 1.0 / 6553);
}

TEST(ClassicTouchpad, EveryCommandInEveryPhaseGetsOneTouchAndTheTablesPhase) {
  const auto bring = [](Touchpad& pad, LinkPhase phase) {
    static_cast<void>(pad.ack());
    if (phase == LinkPhase::waiting) return;
    static_cast<void>(pad.state());
    if (phase == LinkPhase::paused) static_cast<void>(pad.state(RobotCommand::send_info_and_pause));
    if (phase == LinkPhase::closed) static_cast<void>(pad.state(RobotCommand::disconnect));
    if (phase == LinkPhase::lost) pad.wait(200);
  };
  for (const LinkPhase phase :
       {LinkPhase::waiting, LinkPhase::running, LinkPhase::paused, LinkPhase::closed, LinkPhase::lost}) {
    for (int c = 0; c <= 11; ++c) {
      Touchpad pad;
      bring(pad, phase);
      ASSERT_EQ(pad.end.phase(), phase);
      const auto command = static_cast<RobotCommand>(c);
      const auto& reception = pad.state(command);
      const auto replies = sent(reception);
      ASSERT_FALSE(replies.empty());
      EXPECT_EQ(replies[0], kTouch);
      EXPECT_EQ(replies.size(), command == RobotCommand::send_info_and_pause ? 4U : 1U);

      LinkPhase expected = phase == LinkPhase::paused ? LinkPhase::paused : LinkPhase::running;
      if (command == RobotCommand::send_info_and_pause) expected = LinkPhase::paused;
      if (command == RobotCommand::resume) expected = LinkPhase::running;
      if (command == RobotCommand::disconnect || phase == LinkPhase::closed) expected = LinkPhase::closed;
      EXPECT_EQ(pad.end.phase(), expected) << "phase " << static_cast<int>(phase) << " command " << c;
      EXPECT_EQ(reception.state.has_value(), phase != LinkPhase::closed);
    }
  }
}

TEST(ClassicTouchpad, InfoFollowsTheTouchAfterCommand5) {
  Touchpad pad;
  pad.connect();
  EXPECT_THAT(sent(pad.state(RobotCommand::send_info_and_pause)),
              ElementsAre(kTouch, "00005", "board", "^010^0'04200^1'04200"));
  EXPECT_THAT(sent(pad.state()), ElementsAre(kTouch));  // paused, and still answered
  EXPECT_EQ(pad.end.phase(), LinkPhase::paused);
}

TEST(ClassicTouchpad, DamagedStateIsAnsweredOnceAndNotUsed) {
  Touchpad pad;
  pad.connect();
  const std::string good = text(encodeState({.command = RobotCommand::disconnect}));
  for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
    std::string flipped = good;
    flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
    Touchpad fresh;
    fresh.connect();
    const auto& reception = fresh.take(bytesOf(flipped));
    EXPECT_GE(reception.replies.size(), 1U) << bit;
    EXPECT_EQ(text(reception.replies[0].bytes), kTouch) << bit;
    const bool used = decodeState(bytesOf(flipped)).ok();
    EXPECT_EQ(reception.state.has_value(), used) << bit;
    EXPECT_EQ(fresh.end.counters().states_damaged, used ? 0U : 1U) << bit;
  }
}

TEST(ClassicTouchpad, WhatIsNoStateIsNeverAnswered) {
  Touchpad pad;
  pad.connect();
  const std::string state = text(encodeState({}));
  for (std::size_t size = 0; size < 60; ++size) {
    EXPECT_TRUE(pad.take(bytesOf(std::string_view(state).substr(0, size))).replies.empty()) << size;
  }
  EXPECT_TRUE(pad.take(bytesOf("0'04200:0'04200.\n")).replies.empty());
  EXPECT_TRUE(pad.take(bytesOf(kTouch)).replies.empty());
  EXPECT_TRUE(pad.take(bytesOf(std::string(62, 'x'))).replies.empty());
  EXPECT_TRUE(pad.take(bytesOf(std::string(65'000, '?'))).replies.empty());
  EXPECT_EQ(pad.end.counters().out_of_turn, 1U);
  EXPECT_EQ(pad.end.counters().unrecognised, 63U);
  EXPECT_EQ(pad.end.phase(), LinkPhase::running);
}

TEST(ClassicTouchpad, StrangersAreCountedAndIgnored) {
  Touchpad pad;
  EXPECT_TRUE(pad.state().replies.empty());
  EXPECT_EQ(pad.end.counters().before_handshake, 1U);
  pad.connect();
  EXPECT_TRUE(pad.state(RobotCommand::disconnect, kOther).replies.empty());
  EXPECT_TRUE(pad.state(RobotCommand::disconnect, address(1, 4000)).replies.empty());  // same host, other port
  EXPECT_EQ(pad.end.counters().wrong_peer, 2U);
  EXPECT_EQ(pad.end.phase(), LinkPhase::running);
}

TEST(ClassicTouchpad, SecondRobotIsRefusedWhileOneRuns) {
  Touchpad pad;
  pad.connect();
  EXPECT_TRUE(pad.ack(kOther).replies.empty());
  EXPECT_EQ(pad.end.counters().second_robot, 1U);
  EXPECT_EQ(pad.end.peer(), kRobot);
  EXPECT_THAT(sent(pad.state()), ElementsAre(kTouch));
}

TEST(ClassicTouchpad, RestartedRobotStartsANewSessionAtAnyTime) {
  Touchpad pad;
  pad.connect();
  static_cast<void>(pad.state(RobotCommand::send_info_and_pause));
  EXPECT_TRUE(pad.ack().session_started);
  EXPECT_EQ(pad.end.phase(), LinkPhase::waiting);
  static_cast<void>(pad.state());
  EXPECT_EQ(pad.end.phase(), LinkPhase::running);
}

TEST(ClassicTouchpad, AnotherRobotTakesOverAfterGoodbyeOrLongSilence) {
  {
    Touchpad pad;
    pad.connect();
    pad.wait(21);
    EXPECT_EQ(pad.end.phase(), LinkPhase::lost);
    EXPECT_FALSE(pad.ack(kOther).session_started);
    pad.wait(980);
    EXPECT_TRUE(pad.ack(kOther).session_started);
  }
  {
    Touchpad pad;
    pad.connect();
    static_cast<void>(pad.state(RobotCommand::send_info_and_pause));
    pad.wait(900);
    EXPECT_FALSE(pad.ack(kOther).session_started);
    pad.wait(101);
    EXPECT_TRUE(pad.ack(kOther).session_started);
  }
  {
    Touchpad pad;
    pad.connect();
    static_cast<void>(pad.state(RobotCommand::disconnect));
    EXPECT_TRUE(pad.ack(kOther).session_started);
    EXPECT_EQ(pad.end.peer(), kOther);
    EXPECT_THAT(sent(pad.state(RobotCommand::none, kOther)), ElementsAre(kTouch));
    // The first robot's farewell is still answered, to its own address, and means nothing.
    const auto& farewell = pad.state(RobotCommand::disconnect, kRobot);
    EXPECT_THAT(sent(farewell), ElementsAre(kTouch));
    EXPECT_EQ(farewell.replies[0].to, kRobot);
    EXPECT_FALSE(farewell.state.has_value());
    EXPECT_EQ(pad.end.phase(), LinkPhase::running);
    pad.wait(3'000);
    EXPECT_TRUE(pad.state(RobotCommand::none, kRobot).replies.empty());
  }
}

TEST(ClassicTouchpad, StatesAfterGoodbyeAreAnsweredForThreeSeconds) {
  Touchpad pad;
  pad.connect();
  static_cast<void>(pad.state(RobotCommand::disconnect));
  for (int i = 0; i < 3'000; ++i) ASSERT_EQ(pad.state().replies.size(), 1U);
  EXPECT_EQ(pad.end.phase(), LinkPhase::closed);
  EXPECT_EQ(pad.end.counters().lost, 0U);
}

TEST(ClassicTouchpad, MotorReferencesAreTakenAfterCommand10Only) {
  Touchpad pad;
  pad.connect();
  EXPECT_FALSE(pad.take(bytesOf("0'04200:1'04000.\n")).motor_reference);
  static_cast<void>(pad.state(RobotCommand::motor_reference_on));
  const auto& taken = pad.take(bytesOf("0'04200:1'04000.\n"));
  ASSERT_TRUE(taken.motor_reference);
  EXPECT_EQ(taken.motor_reference->first_ticks, 4200.0);
  EXPECT_EQ(taken.motor_reference->second_ticks, -4000.0);
  EXPECT_TRUE(taken.replies.empty());
  static_cast<void>(pad.state(RobotCommand::motor_reference_off));
  EXPECT_FALSE(pad.take(bytesOf("0'04200:1'04000.\n")).motor_reference);
  EXPECT_EQ(pad.end.counters().out_of_turn, 2U);
}

TEST(ClassicTouchpad, ImagesAreOffUnlessTheProfileAllowsThem) {
  Touchpad pad;
  const std::string picture(3'000, 'p');
  pad.answer.image = bytesOf(picture);
  pad.connect();
  EXPECT_THAT(sent(pad.state(RobotCommand::images_on)), ElementsAre(kTouch));
}

TEST(ClassicTouchpad, ImagesFollowEveryTouchWhileOn) {
  LinkParameters parameters;
  parameters.classic_images = true;
  Touchpad pad(parameters);
  const std::string picture(3'000, 'p');
  pad.answer.image = bytesOf(picture);
  pad.connect();
  const auto with_image =
      ElementsAre(kTouch, "003000", picture.substr(0, 1400), picture.substr(0, 1400), picture.substr(0, 200));
  EXPECT_THAT(sent(pad.state(RobotCommand::images_on)), with_image);
  EXPECT_THAT(sent(pad.state()), with_image);
  EXPECT_EQ(sent(pad.state(RobotCommand::send_info_and_pause)).size(), 8U);
  EXPECT_THAT(sent(pad.state(RobotCommand::images_off)), ElementsAre(kTouch));

  const std::string largest(57'599, 'p');
  pad.answer.image = bytesOf(largest);
  const auto& longest = pad.state(RobotCommand::images_on);
  std::size_t total = 0;
  for (std::size_t i = 2; i < longest.replies.size(); ++i) total += longest.replies[i].bytes.size();
  EXPECT_EQ(total, largest.size());
  EXPECT_LE(pad.state(RobotCommand::send_info_and_pause).replies.size(), TouchpadReception::kMaximumReplies);
  const std::string too_large(57'600, 'p');
  pad.answer.image = bytesOf(too_large);
  EXPECT_THAT(sent(pad.state()), ElementsAre(kTouch, "000000"));
}

// ---- lost link ----

TEST(ClassicTouchpad, SilenceIsLostAfter20msAtOneKilohertz) {
  Touchpad pad;
  pad.connect();
  for (int i = 0; i < 200; ++i) static_cast<void>(pad.state());
  EXPECT_NEAR(pad.end.periodMs(), 1.0, 1e-6);
  pad.wait(20.0);
  EXPECT_EQ(pad.end.phase(), LinkPhase::running);
  pad.wait(0.1);
  EXPECT_EQ(pad.end.phase(), LinkPhase::lost);
  EXPECT_EQ(pad.end.counters().lost, 1U);
}

TEST(ClassicTouchpad, ARobotWhoseStatesAreAllDamagedIsAnsweredAndLost) {
  std::string damaged = text(encodeState({.robot = {.stiffness_N_per_mm = 0.6}}));
  damaged[1] = '<';  // no command
  Touchpad pad;
  static_cast<void>(pad.ack());
  const auto say = [&](int times) {
    for (int i = 0; i < times; ++i) {
      pad.wait(1.0);
      EXPECT_EQ(pad.take(bytesOf(damaged)).replies.size(), 1U);
    }
  };
  say(100);
  EXPECT_EQ(pad.end.phase(), LinkPhase::waiting) << "it has not said a stiffness yet";
  for (int i = 0; i < 200; ++i) static_cast<void>(pad.state());
  say(19);
  EXPECT_EQ(pad.end.phase(), LinkPhase::running);
  say(2);
  EXPECT_EQ(pad.end.phase(), LinkPhase::lost);
  static_cast<void>(pad.state());
  EXPECT_EQ(pad.end.phase(), LinkPhase::running);
}

TEST(ClassicTouchpad, SlowRobotIsGivenThreePeriodsUpToTheCap) {
  Touchpad pad;
  static_cast<void>(pad.ack());
  for (int i = 0; i < 100; ++i) {
    pad.wait(14.0);
    static_cast<void>(pad.state());  // and 1 ms more
  }
  EXPECT_NEAR(toMilliseconds(pad.end.lostLimit()), 45.0, 0.5);
  for (int i = 0; i < 100; ++i) {
    pad.wait(79.0);
    static_cast<void>(pad.state());
  }
  EXPECT_NEAR(toMilliseconds(pad.end.lostLimit()), 100.0, 1e-9);
}

TEST(ClassicTouchpad, JitterOf5msAnd1PercentLossIsNoLossInAnHour) {
  // States are sent every millisecond, each delayed by a random time of 5 ms mean deviation, 1 in 100 is lost.
  Touchpad pad;
  pad.connect();
  std::mt19937_64 random(7);
  std::normal_distribution<double> delay_ms(30.0, 5.0);
  const Instant start = pad.now;
  std::vector<double> pending;
  double sent_ms = 0.0;
  const std::string state = text(encodeState({.robot = {.stiffness_N_per_mm = 0.6}}));
  pending.push_back(0.0);
  for (int i = 0; i < 3'600'000; ++i, sent_ms += 1.0) {
    if (random() % 100 == 0) continue;
    pending.push_back(sent_ms + std::max(0.0, delay_ms(random)) - 30.0 + 1.0);
    std::push_heap(pending.begin(), pending.end(), std::greater<>());
    while (!pending.empty() && pending.front() <= sent_ms - 40.0) {
      std::pop_heap(pending.begin(), pending.end(), std::greater<>());
      pad.now = std::max(pad.now, start + fromSeconds(1e-3 * pending.back()));
      pending.pop_back();
      static_cast<void>(pad.take(bytesOf(state)));
    }
  }
  EXPECT_GT(pad.end.counters().states, 3'500'000U);
  EXPECT_EQ(pad.end.counters().lost, 0U);
}

TEST(ClassicTouchpad, SilenceAtAThousandRandomMomentsIsLostWithinTheStatedLimit) {
  std::mt19937_64 random(17);
  std::exponential_distribution<double> extra_ms(0.5);
  for (int i = 0; i < 1'000; ++i) {
    Touchpad pad;
    static_cast<void>(pad.ack());
    const double period_ms = 0.4 + 0.02 * static_cast<double>(random() % 1'000);
    for (std::uint64_t n = 2 + random() % 200; n > 0; --n) {
      pad.now += fromSeconds(1e-3 * (period_ms + extra_ms(random)));
      static_cast<void>(pad.take(encodeState({})));
    }
    const Duration limit = pad.end.lostLimit();
    ASSERT_GE(toMilliseconds(limit), std::max(20.0, 3.0 * pad.end.periodMs()) - 1e-6);
    ASSERT_LE(toMilliseconds(limit), 100.0);
    pad.wait(toMilliseconds(limit) - 0.01);
    ASSERT_EQ(pad.end.phase(), LinkPhase::running);
    pad.wait(0.02);
    ASSERT_EQ(pad.end.phase(), LinkPhase::lost);
    pad.wait(5'000);
    ASSERT_EQ(pad.end.phase(), LinkPhase::lost);  // stays so until the robot speaks again
  }
}

TEST(ClassicTouchpad, NegotiatedPauseIsNoLoss) {
  Touchpad pad;
  pad.connect();
  static_cast<void>(pad.state(RobotCommand::send_info_and_pause));
  pad.wait(600'000);
  EXPECT_EQ(pad.end.phase(), LinkPhase::paused);
  EXPECT_EQ(pad.state(RobotCommand::resume).replies.size(), 1U);
  EXPECT_EQ(pad.end.phase(), LinkPhase::running);
  EXPECT_EQ(pad.end.counters().lost, 0U);
}

TEST(ClassicTouchpad, LossBetweenTwoStatesIsToldEvenIfNobodyAskedInBetween) {
  Touchpad pad;
  pad.connect();
  pad.now += std::chrono::milliseconds(50);
  const auto& late = pad.take(encodeState({}));
  EXPECT_TRUE(late.was_lost);
  EXPECT_EQ(late.replies.size(), 1U);
  EXPECT_EQ(pad.end.phase(), LinkPhase::running);
  EXPECT_FALSE(pad.state().was_lost);
}

TEST(ClassicTouchpad, TimeThatStandsStillOrGoesBackIsHarmless) {
  Touchpad pad;
  pad.connect();
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(pad.take(encodeState({})).replies.size(), 1U);
    pad.now -= std::chrono::seconds(i % 3);
  }
  EXPECT_EQ(pad.end.phase(), LinkPhase::running);
  EXPECT_TRUE(std::isfinite(pad.end.periodMs()));
  EXPECT_LE(pad.end.lostLimit(), std::chrono::milliseconds(100));
}

TEST(ClassicTouchpad, StiffnessThatACutTookKeepsItsLastValue) {
  Touchpad pad;
  pad.connect();
  const auto& cut = pad.take(bytesOf("?2,0'06553:0'00000:0'00000:1,1'-25536:1'-25536:1'-32768:0'06000.\n").first(62));
  ASSERT_TRUE(cut.state);
  EXPECT_NEAR(cut.state->stiffness_N_per_mm, 0.6, 1e-12);
  EXPECT_EQ(pad.end.counters().states_cut, 1U);
}

TEST(ClassicTouchpad, EveryDatagramIsCountedOnceAndNothingAllocates) {
  Touchpad pad;
  std::mt19937_64 random(3);
  std::vector<std::uint8_t> garbage(300);
  const auto state = encodeState({});
  const auto ack = encodeAck();
  const bench::AllocationCount counted;
  constexpr std::uint64_t kCount = 100'000;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    for (auto& byte : garbage) byte = static_cast<std::uint8_t>(random());
    Bytes packet = Bytes(garbage).first(random() % garbage.size());
    if (random() % 4 == 0) packet = state;
    if (random() % 64 == 0) packet = ack;
    pad.now += std::chrono::microseconds(random() % 2'000);
    static_cast<void>(pad.take(packet, random() % 2 == 0 ? kRobot : kOther));
  }
  EXPECT_EQ(counted.count(), 0U);
  const auto& c = pad.end.counters();
  EXPECT_EQ(c.acks + c.states + c.farewell_states + c.motor_references + c.wrong_peer + c.second_robot +
                c.before_handshake + c.out_of_turn + c.unrecognised,
            kCount);
  EXPECT_EQ(c.touches, c.states + c.farewell_states);
}

// ---- both ends together ----

// Carries datagrams between the ends at once, or drops them.
class Pair {
 public:
  explicit Pair(const ClassicRobotSettings& settings = {}, const LinkParameters& parameters = {})
      : pad(parameters), robot(settings, kTouchpad) {}

  void cycle() {
    pad.wait(1);
    for (const Datagram& datagram : robot.tick(pad.now, report)) {
      if (robot_deaf) continue;
      const auto& reception = pad.take(datagram.bytes, kRobot);
      if (reception.motor_reference) motor_reference = reception.motor_reference;
      if (reception.command != RobotCommand::none) commands.push_back(reception.command);
      for (const Datagram& reply : reception.replies) {
        if (drop_next > 0) {
          --drop_next;
          continue;
        }
        const auto got = robot.handle(reply.bytes, kTouchpad);
        if (got.touch) touch = *got.touch;
      }
    }
  }
  void cycles(int n) {
    for (int i = 0; i < n; ++i) cycle();
  }

  Touchpad pad;
  ClassicRobotEnd robot;
  RobotReport report{.acceleration_g = {0.25, 0, 0},
                     .robot = {.stiffness_N_per_mm = 0.6},
                     .motor_reference = {.first_ticks = 933, .second_ticks = -933}};
  pipeline::TouchMessage touch;
  std::optional<pipeline::RobotMotorReference> motor_reference;
  std::vector<RobotCommand> commands;
  bool robot_deaf = false;
  int drop_next = 0;
};

TEST(ClassicSession, RunsInStepThroughAllTwelveCommands) {
  LinkParameters parameters;
  parameters.classic_images = true;
  Pair pair({}, parameters);
  const std::string picture(20'000, 'p');
  pair.pad.answer.image = bytesOf(picture);
  pair.cycles(10);
  EXPECT_EQ(pair.robot.phase(), RobotPhase::running);
  EXPECT_EQ(pair.robot.boardText(), "board");
  EXPECT_EQ(pair.robot.info().reference_ticks[1], -4200.0);
  EXPECT_EQ(pair.touch.position_mm, (Vec3{10, -5, -2}));

  const std::vector<RobotCommand> order = {RobotCommand::vibration_down,
                                           RobotCommand::vibration_up,
                                           RobotCommand::use_dft321,
                                           RobotCommand::use_soc,
                                           RobotCommand::images_on,
                                           RobotCommand::send_info_and_pause,
                                           RobotCommand::resume,
                                           RobotCommand::images_off,
                                           RobotCommand::motor_reference_on,
                                           RobotCommand::motor_reference_off,
                                           RobotCommand::disconnect};
  for (const RobotCommand command : order) {
    ASSERT_TRUE(pair.robot.command(command));
    pair.cycles(20);
    EXPECT_FALSE(pair.robot.replyDue());
    EXPECT_EQ(pair.pad.end.phase() == LinkPhase::paused, command == RobotCommand::send_info_and_pause);
  }
  EXPECT_EQ(pair.commands, order);
  EXPECT_EQ(text(pair.robot.image()), picture);
  ASSERT_TRUE(pair.motor_reference);
  EXPECT_EQ(pair.motor_reference->second_ticks, -933.0);
  EXPECT_EQ(pair.robot.phase(), RobotPhase::closing);
  pair.cycles(3'100);
  EXPECT_EQ(pair.robot.phase(), RobotPhase::closed);
  EXPECT_EQ(pair.pad.end.phase(), LinkPhase::closed);

  const RobotCounters& r = pair.robot.counters();
  EXPECT_EQ(r.touches, r.states);
  EXPECT_EQ(r.missed_replies + r.extra_touches + r.refused + r.cycles_cut_short + r.waited_cycles, 0U);
  EXPECT_EQ(pair.pad.end.counters().refused(), 0U);
  EXPECT_EQ(r.infos, 2U);
  EXPECT_EQ(r.images, 60U);  // three commands' cycles
}

TEST(ClassicSession, StaysInStepWhileStatesAreDamagedOnTheWay) {
  Pair pair;
  pair.cycles(5);
  std::mt19937_64 random(11);
  for (int i = 0; i < 5'000; ++i) {
    pair.pad.wait(1);
    for (const Datagram& datagram : pair.robot.tick(pair.pad.now, pair.report)) {
      std::string damaged = text(datagram.bytes);
      if (i % 2 == 0) damaged[random() % damaged.size()] ^= static_cast<char>(1 << (random() % 8));
      for (const Datagram& reply : pair.pad.take(bytesOf(damaged)).replies) {
        if (reply.bytes.size() == kClassicTouchSize) static_cast<void>(pair.robot.handle(reply.bytes, kTouchpad));
      }
    }
  }
  EXPECT_EQ(pair.robot.counters().missed_replies, 0U);
  EXPECT_EQ(pair.robot.counters().extra_touches, 0U);
  EXPECT_GT(pair.pad.end.counters().states_damaged, 1'000U);
}

TEST(ClassicSession, MissedReplyIsCountedAndTheNextCycleGoesOn) {
  Pair pair;
  pair.cycles(5);
  pair.drop_next = 1;
  pair.cycles(200);
  EXPECT_EQ(pair.robot.counters().missed_replies, 1U);
  EXPECT_EQ(pair.robot.counters().waited_cycles, 99U);
  EXPECT_EQ(pair.robot.counters().extra_touches, 0U);
  EXPECT_EQ(pair.robot.phase(), RobotPhase::running);
}

TEST(ClassicSession, LateTouchIsCountedAndUsed) {
  Pair pair;
  pair.cycles(5);
  const auto got = pair.robot.handle(bytesOf("?0'00007:0'00008:1'00009:0'00000.\n"), kTouchpad);
  ASSERT_TRUE(got.touch);
  EXPECT_EQ(got.touch->position_mm, (Vec3{7, 8, -9}));
  EXPECT_EQ(pair.robot.counters().extra_touches, 1U);
}

TEST(ClassicSession, TouchpadThatWentAwayIsCalledAgainUntilItReturns) {
  Pair pair;
  pair.cycles(5);
  pair.robot_deaf = true;
  pair.cycles(1'200);
  EXPECT_EQ(pair.robot.counters().lost, 1U);
  EXPECT_EQ(pair.robot.phase(), RobotPhase::handshake);
  EXPECT_EQ(pair.pad.end.phase(), LinkPhase::lost);
  pair.robot_deaf = false;
  pair.pad.end = ClassicTouchpadEnd({});  // restarted: knows nobody
  pair.cycles(600);
  EXPECT_EQ(pair.robot.phase(), RobotPhase::running);
  EXPECT_EQ(pair.pad.end.phase(), LinkPhase::running);
}

TEST(ClassicSession, SurvivesAHundredRestartsOfEitherEnd) {
  Pair pair;
  for (int i = 0; i < 100; ++i) {
    if (i % 2 == 0) {
      pair.robot = ClassicRobotEnd({}, kTouchpad);
    } else {
      pair.pad.end = ClassicTouchpadEnd({});
    }
    pair.cycles(1'700);
    ASSERT_EQ(pair.robot.phase(), RobotPhase::running) << i;
    ASSERT_EQ(pair.pad.end.phase(), LinkPhase::running) << i;
  }
}

TEST(ClassicSession, WiredWaitsForEverAndWirelessOneSecondTwice) {
  Pair wired(ClassicRobotSettings::wired());
  wired.cycles(5);
  wired.drop_next = 1;
  wired.cycles(100'000);
  EXPECT_EQ(wired.robot.counters().states, 5U);  // the fifth's touch never came
  EXPECT_EQ(wired.robot.counters().missed_replies, 0U);
  EXPECT_EQ(wired.robot.counters().acks, 1U);

  Pair wireless(ClassicRobotSettings::wireless());
  wireless.cycles(5);
  wireless.robot_deaf = true;
  wireless.cycles(1'990);
  EXPECT_EQ(wireless.robot.counters().lost, 0U);
  wireless.cycles(20);
  EXPECT_EQ(wireless.robot.counters().missed_replies, 2U);
  EXPECT_EQ(wireless.robot.counters().lost, 1U);
}

TEST(ClassicSession, TouchpadWithoutPicturesDoesNotHoldTheRobotUp) {
  Pair pair;
  pair.cycles(5);
  ASSERT_TRUE(pair.robot.command(RobotCommand::images_on));
  pair.cycles(400);
  EXPECT_EQ(pair.robot.counters().cycles_cut_short, 3U);
  EXPECT_EQ(pair.robot.phase(), RobotPhase::running);
  EXPECT_FALSE(pair.robot.replyDue());
}

// ---- the robot's side alone ----

TEST(ClassicRobot, EveryMessageInEveryPhaseIsHandledOrRefused) {
  std::vector<std::string> messages = {text(encodeTouch({})),
                                       text(encodeInfoLength(5)),
                                       text(encodeInfoValues({})),
                                       text(encodeImageLength(100)),
                                       text(encodeAck()),
                                       text(encodeState({})),
                                       "",
                                       "board"};
  messages.emplace_back(57'600, 'x');
  for (const RobotCommand command :
       {RobotCommand::none, RobotCommand::send_info_and_pause, RobotCommand::images_on, RobotCommand::disconnect}) {
    for (int progress = 0; progress < 12; ++progress) {  // handshake untouched … closing
      for (const std::string& first : messages) {
        for (const std::string& second : messages) {
          Pair pair;
          if (progress > 0) pair.cycles(progress);
          pair.robot.command(command);
          pair.pad.wait(1);
          static_cast<void>(pair.robot.tick(pair.pad.now, pair.report));
          for (const std::string& message : {first, second}) {
            const auto got = pair.robot.handle(bytesOf(message), kTouchpad);
            EXPECT_TRUE(!got.touch || message == messages[0]);
            EXPECT_FALSE(got.image && message.size() != 100);
          }
          EXPECT_LE(pair.robot.image().size(), kClassicMaximumImage);
        }
      }
    }
  }
}

TEST(ClassicRobot, StrangersAreIgnored) {
  Pair pair;
  pair.cycles(5);
  EXPECT_FALSE(pair.robot.handle(bytesOf(kTouch), kOther).touch);
  EXPECT_EQ(pair.robot.counters().wrong_peer, 1U);
}

TEST(ClassicRobot, TakesTheAddressThatAnswersItsHandshake) {
  ClassicRobotEnd robot({}, kTouchpad);
  static_cast<void>(robot.tick(instantAt(1.0), {}));
  const Endpoint second_address = address(101);
  static_cast<void>(robot.handle(bytesOf("x"), kOther));
  static_cast<void>(robot.handle(bytesOf("00005"), address(5, 4000)));  // another port: a stranger
  static_cast<void>(robot.handle(bytesOf("00005"), second_address));
  static_cast<void>(robot.handle(bytesOf("board"), second_address));
  EXPECT_TRUE(robot.handle(bytesOf("^010^0'04200^1'04200"), second_address).connected);
  EXPECT_EQ(robot.tick(instantAt(1.001), {})[0].to, second_address);
  EXPECT_EQ(robot.counters().wrong_peer, 2U);
}

// ---- mapping ----

TEST(TouchMapping, FollowsTheFormula) {
  TouchMapping mapping;
  mapping.reset({10.0, 0.0, 0.0});
  const Vec3 target = mapping.apply({.position_mm = {20.0, -10.0, -2.0}, .in_contact = true});
  EXPECT_NEAR(target.x, 0.8 * 10.0 + 0.2 * 20.0, 1e-12);
  EXPECT_NEAR(target.y, 0.2 * -10.0, 1e-12);
  EXPECT_NEAR(target.z, 0.1 * 3.0 * -2.0, 1e-12);
}

TEST(TouchMapping, ArrivesWhereTheIntegersOfTheAuthorsStick) {
  TouchMapping mapping;
  for (int i = 0; i < 500; ++i) mapping.apply({.position_mm = {17.0, -23.0, -3.0}, .in_contact = true});
  EXPECT_NEAR(mapping.target().x, 17.0, 1e-9);
  EXPECT_NEAR(mapping.target().y, -23.0, 1e-9);
  EXPECT_NEAR(mapping.target().z, -9.0, 1e-9);
}

TEST(TouchMapping, ZeroZeroHoldsXAndYAndPositiveZIsIgnored) {
  TouchMapping mapping;
  mapping.reset({5.0, 6.0, -7.0});
  const Vec3 lifted = mapping.apply({.position_mm = {0.0, 0.0, 0.0}});
  EXPECT_EQ(lifted.x, 5.0);
  EXPECT_EQ(lifted.y, 6.0);
  EXPECT_NEAR(lifted.z, -6.3, 1e-12);
  const Vec3 before = mapping.target();
  EXPECT_EQ(mapping.apply({.position_mm = {1.0, 1.0, 1.0}, .in_contact = true}), before);
  EXPECT_EQ(mapping.apply({.position_mm = {std::numeric_limits<double>::quiet_NaN(), 1.0, 0.0}}), before);
  EXPECT_NE(mapping.apply({.position_mm = {0.0, 1.0, 1.0}, .in_contact = true}), before);
}

TEST(TouchMapping, OutOfContactXAndYAreHeld) {
  TouchMapping mapping;
  mapping.reset({5.0, 6.0, -7.0});
  const Vec3 target = mapping.apply({.position_mm = {20.0, 10.0, -2.0}, .in_contact = false});
  EXPECT_EQ(target.x, 5.0);
  EXPECT_EQ(target.y, 6.0);
}

TEST(TouchMapping, AfterAnInterruptionNothingMovesUntilAFingerLeadsOrTheTouchMovesFromAbove) {
  const auto touch = [](const Vec3& place, bool contact = false) {
    return pipeline::TouchMessage{.position_mm = place, .in_contact = contact};
  };
  // A touchpad that started anew, an arm that kept its place: it neither rises nor goes sideways.
  TouchMapping mapping;
  mapping.resume({20.0, 5.0, -33.0});
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(mapping.apply(touch({0, 0, 0})), (Vec3{20.0, 5.0, -33.0}));
  EXPECT_GT(mapping.apply(touch({0, 0, -1}, true)).z, -33.0);  // the finger leads

  // A touchpad that is held with the finger pressed, an arm that started anew: it does not go down to it.
  mapping.resume({0.0, 0.0, 0.0});
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(mapping.apply(touch({5, 3, -11})), Vec3{});
  for (int i = 0; i < 11; ++i) EXPECT_EQ(mapping.apply(touch({5, 3, -11.0 + i})), Vec3{});  // lifted in the session
  EXPECT_EQ(mapping.apply(touch({5, 3, 0})), Vec3{});
  EXPECT_LT(mapping.apply(touch({5, 3, -1})).z, 0.0);  // and pressed again

  // The same pair again: what was last asked for is where the arm stands, and the finger lifts it.
  mapping.resume({5.0, 3.0, -33.0});
  EXPECT_EQ(mapping.apply(touch({5, 3, -11})), (Vec3{5.0, 3.0, -33.0}));
  EXPECT_GT(mapping.apply(touch({5, 3, -10})).z, -33.0);
}

// --- what is counted, and what the operator is told of it

TEST(ClassicTouchpad, FiguresNameEachRefusalWithItsCount) {
  Touchpad pad;
  EXPECT_EQ(pad.end.name(), "classic, not secured");
  EXPECT_TRUE(std::isnan(pad.end.figures(pad.now).silence_ms)) << "unknown without a robot";
  static_cast<void>(pad.state());
  pad.connect();
  EXPECT_TRUE(std::isnan(pad.end.figures(pad.now).period_ms)) << "one state has no period";
  static_cast<void>(pad.state());
  static_cast<void>(pad.ack(kOther));
  static_cast<void>(pad.state(RobotCommand::none, kOther));
  static_cast<void>(pad.take(bytesOf("0'04200:0'04200.\n")));
  // One of each kind that the page lists, in a packet that is as long as a state.
  const std::string good = text(encodeState({}));
  const auto damaged = [&](std::size_t at, char c) {
    std::string packet = good;
    packet[at] = c;
    static_cast<void>(pad.take(bytesOf(packet)));
  };
  damaged(1, '<');                                           // command
  damaged(2, ';');                                           // separator
  damaged(3, '2');                                           // sign
  damaged(5, 'x');                                           // digit
  damaged(0, '!');                                           // start mark
  damaged(27, '2');                                          // button, behind the three accelerations
  damaged(5, '9');                                           // above 65535
  static_cast<void>(pad.take(bytesOf(good.substr(0, 40))));  // size
  pad.wait(3);
  const LinkFigures figures = pad.end.figures(pad.now);
  std::map<std::string, std::uint64_t> told;
  for (const RefusalCount& each : figures.refusals) told[std::string(each.reason)] = each.count;
  const std::map<std::string, std::uint64_t> expected{
      {"other address", 1},   {"a second robot", 1},          {"before a handshake", 1}, {"out of turn", 1},
      {"wrong size", 1},      {"wrong start or end mark", 1}, {"wrong sign", 1},         {"not a digit", 1},
      {"wrong separator", 1}, {"unknown command", 1},         {"wrong button", 1},       {"number out of range", 1}};
  EXPECT_EQ(told, expected);
  EXPECT_EQ(figures.refused, 12U);
  EXPECT_NEAR(figures.silence_ms, 4.0, 1e-9);  // since the last one that was sound
  EXPECT_GT(figures.period_ms, 0.0);
  EXPECT_EQ(toString(ClassicRefusal::none), "taken");
  EXPECT_EQ(toString(static_cast<ClassicRefusal>(99)), "unknown");
}

TEST(ClassicTouchpad, OnlyStatesOfAFarewellAreAnswered) {
  Touchpad pad;
  pad.connect();
  static_cast<void>(pad.state(RobotCommand::disconnect));
  static_cast<void>(pad.ack(kOther));
  std::string damaged = text(encodeState({}));
  damaged[5] = 'x';
  EXPECT_EQ(pad.take(bytesOf(damaged)).replies.size(), 1U) << "a state, though damaged";
  EXPECT_EQ(pad.take(bytesOf(std::string_view(damaged).substr(0, 61))).replies.size(), 0U)
      << "neither its size nor whole";
  const std::string whole = text(encodeState({}));
  EXPECT_EQ(pad.take(bytesOf(std::string_view(whole).substr(0, 60))).replies.size(), 1U)
      << "whole but for its end marks";
  static_cast<void>(pad.ack(kRobot));
  EXPECT_EQ(pad.end.peer(), kOther) << "the other runs";
  pad.wait(1001);
  EXPECT_TRUE(pad.ack(kRobot).session_started) << "it comes back and is no longer leaving";
  EXPECT_EQ(pad.end.peer(), kRobot);
  static_cast<void>(pad.state());
  static_cast<void>(pad.state(RobotCommand::disconnect));
  EXPECT_TRUE(pad.ack(kRobot).session_started) << "said goodbye and began anew";
}

TEST(ClassicTouchpad, APictureThatIsTooLongIsSentAsNone) {
  LinkParameters parameters;
  parameters.classic_images = true;
  Touchpad pad(parameters);
  const std::vector<std::uint8_t> large(kClassicMaximumImage + 1, 7);
  pad.answer.image = large;
  pad.connect();
  EXPECT_FALSE(pad.end.imagesOn());
  EXPECT_THAT(sent(pad.state(RobotCommand::images_on)), ElementsAre(kTouch, "000000"));
  EXPECT_TRUE(pad.end.imagesOn());
  EXPECT_EQ(pad.end.counters().images, 0U);
  EXPECT_TRUE(pad.end.advance(pad.now, pad.answer).empty()) << "the classic touchpad only answers";
  EXPECT_TRUE(pad.end.farewell(pad.now).empty()) << "and has no goodbye";
}

/// A robot's end that is answered by hand.
class AnsweredRobot {
 public:
  RobotReception take(std::string_view packet, const Endpoint& from = kTouchpad) {
    return end.handle(bytesOf(packet), from, now);
  }
  std::span<const Datagram> tick(double ms = 1.0) {
    now += fromSeconds(ms * 1e-3);
    return end.tick(now, {});
  }
  void connect() {
    static_cast<void>(tick());
    static_cast<void>(take("00005"));
    static_cast<void>(take("board"));
    ASSERT_TRUE(take("^010^0'04200^1'04200").connected);
  }
  Instant now = instantAt(100.0);
  ClassicRobotEnd end{ClassicRobotSettings{}, kTouchpad};
};

TEST(ClassicRobot, OfALateTouchTheArrivalIsItsTimeAndOfADueOneHalfTheCycleBefore) {
  AnsweredRobot robot;
  EXPECT_EQ(robot.end.problem(), "no touchpad answered");
  robot.connect();
  EXPECT_EQ(robot.end.problem(), "");
  ASSERT_EQ(robot.tick().size(), 1U);
  const Instant sent = robot.now;
  robot.now += std::chrono::milliseconds(4);
  EXPECT_EQ(robot.take(kTouch).touch_seen, sent + std::chrono::milliseconds(2));
  EXPECT_EQ(robot.take(kTouch).touch_seen, robot.now) << "nothing was due";
  EXPECT_EQ(robot.end.counters().extra_touches, 1U);
}

TEST(ClassicRobot, BeforeTheHandshakeAndAfterTheGoodbyeNothingIsTaken) {
  AnsweredRobot robot;
  EXPECT_FALSE(robot.take("00005").info);
  EXPECT_EQ(robot.end.counters().refused, 1U) << "no ACK was sent yet";
  robot.connect();
  EXPECT_TRUE(robot.end.command(RobotCommand::disconnect));
  for (int i = 0; i < 10'000 && robot.end.phase() != RobotPhase::closed; ++i) {
    static_cast<void>(robot.tick());
    if (robot.end.replyDue()) static_cast<void>(robot.take(kTouch));
    if (i == 20) {
      EXPECT_EQ(robot.end.phase(), RobotPhase::closing);
      EXPECT_TRUE(robot.end.command(RobotCommand::use_soc)) << "kept, and never sent";
    }
  }
  EXPECT_EQ(robot.end.phase(), RobotPhase::closed);
  const auto refused = robot.end.counters().refused;
  EXPECT_FALSE(robot.take(kTouch).touch);
  EXPECT_EQ(robot.end.counters().refused, refused + 1);
  EXPECT_TRUE(robot.tick().empty());
}

TEST(ClassicRobot, ATouchpadThatGoesWhileItClosesIsNotCalledAgain) {
  AnsweredRobot robot;
  robot.connect();
  EXPECT_TRUE(robot.end.command(RobotCommand::disconnect));
  for (int i = 0; i < 10'000 && robot.end.phase() != RobotPhase::closed; ++i) static_cast<void>(robot.tick());
  EXPECT_EQ(robot.end.phase(), RobotPhase::closed);
  EXPECT_EQ(robot.end.counters().acks, 1U);
}

TEST(ClassicRobot, APictureOfNoBytesEndsTheCycleAndOneThatIsTooLongIsRefused) {
  AnsweredRobot robot;
  robot.connect();
  EXPECT_TRUE(robot.end.command(RobotCommand::images_on));
  static_cast<void>(robot.tick());
  EXPECT_TRUE(robot.take(kTouch).touch);
  EXPECT_TRUE(robot.end.replyDue()) << "the picture's length";
  static_cast<void>(robot.take("057601"));
  EXPECT_EQ(robot.end.counters().refused, 1U) << "above its limit";
  static_cast<void>(robot.take("000000"));
  EXPECT_FALSE(robot.end.replyDue());
  static_cast<void>(robot.tick());
  EXPECT_TRUE(robot.take(kTouch).touch);
  static_cast<void>(robot.take("000004"));
  EXPECT_FALSE(robot.take("12345").image);
  EXPECT_EQ(robot.end.counters().refused, 2U) << "more than was announced";
  EXPECT_FALSE(robot.take(kTouch.substr(0, 2)).image);
  EXPECT_TRUE(robot.take("34").image);
  EXPECT_EQ(robot.end.counters().images, 1U);
}

TEST(TouchMapping, AboveTheClothATouchIsIgnoredOnlyWithBothXAndY) {
  TouchMapping mapping;
  const auto depth = [&](const Vec3& at) { return mapping.goal({.position_mm = at, .in_contact = true}).depth; };
  EXPECT_FALSE(depth({1, 1, 1})) << "z above 0 together with x and y both other than 0 is ignored";
  EXPECT_TRUE(depth({1, 0, 1}));
  EXPECT_TRUE(depth({0, 1, 1}));
  EXPECT_FALSE(depth({1e308, 0, 1e308})) << "no number once scaled";
}

}  // namespace
}  // namespace fyd::protocol
