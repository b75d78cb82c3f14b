// What a peer that holds the key may still send wrongly, at each end of FYD Link: refused for the reason that the page
// gives (manual/protocol.md), counted, and nothing of it used. The other end is played by hand.
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>

#include "core/protocol/link/image_transfer.h"
#include "core/protocol/link/link_key_file.h"
#include "tests/files_of_at_most.h"
#include "tests/temporary_folder.h"
#include "tests/unit/protocol/link_pair.h"

namespace fyd::protocol {
namespace {

using std::chrono::milliseconds;

/// Type, flags and time as the page writes them, and a body.
Packet byHand(unsigned type, unsigned flags, LinkTime sent_us, const Packet& body) {
  Packet out{static_cast<std::uint8_t>(type | (flags << 5U))};
  for (unsigned i = 0; i < 6; ++i) out.push_back(static_cast<std::uint8_t>(sent_us >> (8 * i)));
  out.insert(out.end(), body.begin(), body.end());
  return out;
}

Packet sealedBy(Sealer& sealer, const Packet& message) {
  Packet out(message.size() + kSealOverhead);
  std::ranges::copy(message, Sealer::messagePart(out).begin());
  EXPECT_EQ(sealer.seal(out, message.size()), out.size());
  return out;
}

template <class Write>
Packet written(Write&& write) {
  Packet out(kMaximumLinkMessage);
  out.resize(write(std::span<std::uint8_t>(out)));
  return out;
}

Packet cutBy(Packet bytes, std::size_t count) {
  bytes.resize(bytes.size() - count);
  return bytes;
}

Packet longer(Packet bytes) {
  bytes.push_back(0);
  return bytes;
}

struct Wrong {
  std::string what;
  Packet message;
  LinkRefusal why;
};

// --- the touchpad's end, and robots played by hand

class TouchpadAgainstHands : public testing::Test {
 protected:
  class Robot {
   public:
    Robot(TouchpadAgainstHands& at, int host) : at_(at), address_(linkAddress(host)) {}

    Packet give(const Packet& datagram) {
      const auto& got = at_.touchpad.handle(datagram, address_, at_.now, at_.answer);
      at_.told = got.state;
      return got.replies.empty() ? Packet{} : Packet(got.replies[0].bytes.begin(), got.replies[0].bytes.end());
    }
    Cookie cookie() {
      HelloNonce nonce{};
      seededRandom(nonce);
      const HelloBytes hello = makeHello(testKey(), nonce);
      Cookie out{};
      EXPECT_EQ(readChallenge(testKey(), give({hello.begin(), hello.end()}), nonce, out), LinkRefusal::none);
      return out;
    }
    /// @return the answer to a call with this self-description
    Packet call(const Packet& description, const LinkKey& key = testKey()) {
      caller_.emplace(key, cookie(), seededRandom);
      called.resize(kMaximumLinkDatagram);
      called.resize(caller_->write(description, called));
      return give(called);
    }
    /// Up to the heartbeat that would make the session.
    void prepare() {
      std::array<std::uint8_t, kMaximumLinkDatagram> plain{};
      const Packet answered = call(description);
      const auto payload = caller_->read(answered, plain);
      ASSERT_TRUE(payload);
      const auto hello = decodeTouchpadHello(*payload);
      ASSERT_TRUE(hello.ok());
      status = hello.value.status;
      told_us_ = hello.value.sent_us;
      sealer_ = Sealer(caller_->keys().from_initiator, sessionOf(caller_->keys()));
    }
    void connect() {
      prepare();
      seal(heartbeat());
      at_.wait(6);  // a new session is "waiting" for 5 ms at least
      seal(state());
      ASSERT_EQ(at_.touchpad.phase(), pipeline::LinkPhase::running);
      ASSERT_EQ(at_.touchpad.peer(), address_);
    }
    Packet seal(const Packet& message) { return give(sealedBy(sealer_, message)); }
    [[nodiscard]] LinkTime time() const {
      return LinkTime{50'000'000} +
             static_cast<LinkTime>(
                 std::chrono::microseconds(std::chrono::duration_cast<std::chrono::microseconds>(at_.now - at_.begin))
                     .count());
    }
    [[nodiscard]] Packet heartbeat() const {
      return written([&](auto out) { return encodeLink(LinkHeartbeat{.echo_us = told_us_}, time(), out); });
    }
    Packet state(std::size_t accelerations = 0) {
      LinkState out{.sequence = ++sequence_, .robot = {.force_N = force_N}};
      for (std::size_t i = 0; i < accelerations; ++i) EXPECT_TRUE(out.accelerations.push({.age_s = 0.001}));
      return written([&](auto to) { return encodeLink(out, code_, time(), to); });
    }
    [[nodiscard]] Packet command(std::uint16_t id, unsigned number) const {
      return byHand(
          3, 0, time(),
          {static_cast<std::uint8_t>(id), static_cast<std::uint8_t>(id >> 8U), static_cast<std::uint8_t>(number)});
    }
    CallStatus status = CallStatus::accepted;
    Packet called;  ///< the last call's datagram
    Packet description = vectorBytes("robot_hello");
    double force_N = pipeline::RobotState{}.force_N;  ///< of its states

   private:
    TouchpadAgainstHands& at_;
    Endpoint address_;
    std::optional<Caller> caller_;
    Sealer sealer_;
    LinkTime told_us_ = 0;
    std::uint16_t sequence_ = 0;
    PositionCode code_ = *PositionCode::make(asOnTheWire(RobotHello{}.workspace));
  };

  void wait(int ms) {
    now += milliseconds(ms);
    static_cast<void>(touchpad.advance(now, answer));
  }
  [[nodiscard]] std::uint64_t refused(LinkRefusal why) const {
    return touchpad.refusals()[static_cast<std::size_t>(why)];
  }
  /// Gives it, and expects that it is counted for this reason, answered by nothing, and changes nothing.
  void expectRefused(const std::function<Packet()>& give, LinkRefusal why, std::string_view what) {
    const auto before = touchpad.refusals();
    const auto phase = touchpad.phase();
    const auto states = touchpad.counters().states;
    EXPECT_TRUE(give().empty()) << what;
    auto expected = before;
    ++expected[static_cast<std::size_t>(why)];
    EXPECT_EQ(touchpad.refusals(), expected) << what << ": expected \"" << toString(why) << '"';
    EXPECT_EQ(touchpad.phase(), phase) << what;
    EXPECT_EQ(touchpad.counters().states, states) << what;
  }

  Instant begin = instantAt(1000.0);
  Instant now = begin;
  LinkTouchpadEnd touchpad{LinkParameters{}, testKey(), seededRandom};
  TouchpadAnswer answer;
  std::optional<pipeline::RobotState> told;  ///< by the last datagram
};

TEST_F(TouchpadAgainstHands, MessagesThatAreNotAsThePageHasThemAreRefused) {
  Robot robot(*this, 1);
  robot.connect();
  wait(1);
  const LinkTime time = robot.time();
  Packet too_many = robot.state(kMaximumBatch);  // one more than the count may say, all of them there
  too_many[too_many.size() - kMaximumBatch * 8 - 1] = kMaximumBatch + 1;
  too_many.resize(too_many.size() + 8);
  Packet unknown_flag = robot.state();
  unknown_flag[0] |= 2U << 5U;
  const std::vector<Wrong> wrongs{
      {"shorter than a message's head", {2, 0, 0, 0, 0, 0}, LinkRefusal::size},
      {"type 0", byHand(0, 0, time, {}), LinkRefusal::message},
      {"type 9", byHand(9, 0, time, {}), LinkRefusal::message},
      {"a touch, which is the touchpad's", byHand(1, 0, time, {0, 0}), LinkRefusal::message},
      {"a heartbeat with a flag", byHand(5, 1, time, Packet(10, 0)), LinkRefusal::field},
      {"a heartbeat cut short", byHand(5, 0, time, Packet(9, 0)), LinkRefusal::size},
      {"a state cut short", cutBy(robot.state(), 1), LinkRefusal::size},
      {"a state that is longer", longer(robot.state()), LinkRefusal::size},
      {"a state with an unknown flag", unknown_flag, LinkRefusal::field},
      {"a state with 33 accelerations", too_many, LinkRefusal::field},
      {"command 0", robot.command(1, 0), LinkRefusal::field},
      {"command 12", robot.command(1, 12), LinkRefusal::field},
      {"a command that is longer", longer(robot.command(1, 1)), LinkRefusal::size},
      {"command id 0 before any", robot.command(0, 1), LinkRefusal::late},
      {"command id 2 before 1", robot.command(2, 1), LinkRefusal::late},
      {"goodbye for reason 2", byHand(7, 0, time, {2}), LinkRefusal::field},
      {"goodbye cut short", byHand(7, 0, time, {}), LinkRefusal::size},
  };
  for (const Wrong& wrong : wrongs) expectRefused([&] { return robot.seal(wrong.message); }, wrong.why, wrong.what);
  EXPECT_FALSE(robot.seal(robot.command(1, 1)).empty()) << "acknowledged: the session goes on";
}

TEST_F(TouchpadAgainstHands, DatagramsThatAreNotAsThePageHasThemAreRefused) {
  Robot robot(*this, 1);
  expectRefused([&] { return robot.give(Packet(40, 0)); }, LinkRefusal::magic, "zeros");
  expectRefused([&] { return robot.give({0xFD, 0x25}); }, LinkRefusal::version, "version 2");
  expectRefused([&] { return robot.give({0xFD, 0x16}); }, LinkRefusal::kind, "kind 6");
  expectRefused([&] { return robot.give({0xFD, 0x12}); }, LinkRefusal::kind, "a challenge, which is the touchpad's");
  expectRefused([&] { return robot.give({0xFD, 0x11}); }, LinkRefusal::size, "a hello cut short");
  expectRefused([&] { return robot.give({0xFD, 0x13}); }, LinkRefusal::size, "a call cut short");
  Packet call(kMaximumLinkDatagram + 1, 0);
  call[0] = 0xFD;
  call[1] = 0x13;
  expectRefused([&] { return robot.give(call); }, LinkRefusal::size, "a call that is too long");
  Packet sealed(kSealOverhead, 0);
  sealed[0] = 0xFD;
  sealed[1] = 0x15;
  expectRefused([&] { return robot.give(sealed); }, LinkRefusal::size, "sealed, with nothing in it");
  sealed.resize(kMaximumLinkDatagram + 1);
  expectRefused([&] { return robot.give(sealed); }, LinkRefusal::size, "sealed, and too long");
  sealed.resize(60);
  expectRefused([&] { return robot.give(sealed); }, LinkRefusal::phase, "sealed, before a session");
}

TEST_F(TouchpadAgainstHands, ACallWithAWrongKeyOrSelfDescriptionOpensNothing) {
  Robot robot(*this, 1);
  const Packet good = vectorBytes("robot_hello");
  Packet no_rate = good;
  no_rate[6] = no_rate[7] = 0;  // wished states/s, behind the time
  Packet unprintable = good;
  unprintable.back() = 7;
  Packet unknown_capability = good;
  unknown_capability[6 + 4 + 28] |= 16U;
  const auto call = [&](const Packet& description) { return [&, description] { return robot.call(description); }; };
  expectRefused(call(cutBy(good, 1)), LinkRefusal::size, "a text that is shorter than its length");
  expectRefused(call(longer(good)), LinkRefusal::size, "a longer one");
  expectRefused(call(no_rate), LinkRefusal::field, "no states");
  expectRefused(call(unprintable), LinkRefusal::field, "a bell in the text");
  expectRefused(call(unknown_capability), LinkRefusal::field, "capability 16");
  expectRefused([&] { return robot.call(good, testKey(1)); }, LinkRefusal::key, "another key, with a good cookie");
  // Public keys for which every shared secret is zero (the points 0 and 1), sealed by one who has the key.
  for (std::uint8_t point = 0; point <= 1; ++point) {
    expectRefused(
        [&] {
          Packet out(kMaximumLinkDatagram);
          out[0] = 0xFD;
          out[1] = 0x13;
          const Cookie cookie = robot.cookie();
          std::ranges::copy(cookie, out.begin() + 2);
          EphemeralKey unsound;
          unsound.open[0] = point;
          NoiseHandshake noise(testKey().handshakeKey(), Bytes(out).first(kCallHeader));
          out.resize(kCallHeader + noise.writeFirst(unsound, good, std::span(out).subspan(kCallHeader)));
          return robot.give(out);
        },
        LinkRefusal::key, "an unsound public key");
  }
  EXPECT_EQ(touchpad.phase(), pipeline::LinkPhase::waiting) << "no session";
  EXPECT_FALSE(touchpad.peer());
}

TEST_F(TouchpadAgainstHands, ARobotThatComesBackKeepsItsPlaceAgainstOneThatIsNotYetConfirmed) {
  Robot first(*this, 1);
  Robot second(*this, 2);
  first.connect();
  wait(1001);  // longer than link.takeover_silence_s
  second.prepare();
  ASSERT_EQ(second.status, CallStatus::accepted);
  EXPECT_TRUE(first.seal(first.state()).empty());
  EXPECT_EQ(touchpad.phase(), pipeline::LinkPhase::running) << "the first speaks again";
  expectRefused([&] { return second.seal(second.heartbeat()); }, LinkRefusal::second_robot, "its confirmation");
  EXPECT_EQ(touchpad.peer(), linkAddress(1));
  // And a third, who asks now, is told so.
  Robot third(*this, 3);
  third.prepare();
  EXPECT_EQ(third.status, CallStatus::second_robot);
  EXPECT_EQ(touchpad.peer(), linkAddress(1));
}

TEST_F(TouchpadAgainstHands, AStateConfirmsACallWhoseHeartbeatCameTooEarly) {
  Robot first(*this, 1);
  Robot second(*this, 2);
  first.connect();
  wait(1001);
  second.prepare();
  EXPECT_TRUE(first.seal(first.state()).empty());
  expectRefused([&] { return second.seal(second.heartbeat()); }, LinkRefusal::second_robot, "the first spoke again");
  const auto heartbeats = touchpad.counters().heartbeats;
  wait(990);
  expectRefused([&] { return second.seal(second.state()); }, LinkRefusal::second_robot, "it is not silent long enough");
  wait(10);
  second.seal(second.state());
  EXPECT_EQ(touchpad.peer(), linkAddress(2)) << "its clock is known from the heartbeat";
  EXPECT_EQ(touchpad.counters().sessions, 2U);
  EXPECT_EQ(touchpad.counters().heartbeats, heartbeats) << "none was taken in";
}

TEST_F(TouchpadAgainstHands, TheForceOfARobotThatTellsNoneIsNotUsed) {
  Robot silent(*this, 1);
  silent.description[38] &= static_cast<std::uint8_t>(~8U);  // capabilities, behind time, rates and workspace
  silent.force_N = 2.5;
  silent.connect();
  ASSERT_TRUE(told);
  EXPECT_TRUE(std::isnan(told->force_N));
  silent.seal(byHand(7, 0, silent.time(), {0}));
  Robot telling(*this, 2);
  telling.force_N = 2.5;
  telling.connect();
  ASSERT_TRUE(told);
  EXPECT_NEAR(told->force_N, 2.5, 0.001);
}

TEST_F(TouchpadAgainstHands, AHeartbeatThatEchoesWhatIsLongAgoMeasuresNothing) {
  Robot robot(*this, 1);
  robot.connect();
  const auto heartbeats = touchpad.counters().heartbeats;
  const auto refusals = touchpad.refusals();
  robot.seal(robot.heartbeat());
  EXPECT_EQ(touchpad.counters().heartbeats, heartbeats + 1);
  wait(700);  // a round trip of twice link.freshness_ms may be measured
  robot.seal(robot.heartbeat());
  EXPECT_EQ(touchpad.counters().heartbeats, heartbeats + 1);
  EXPECT_EQ(touchpad.refusals(), refusals) << "it is fresh by its own time";
}

TEST_F(TouchpadAgainstHands, AfterAGoodbyeAnotherRobotNeedNotWaitForSilence) {
  Robot first(*this, 1);
  Robot second(*this, 2);
  first.connect();
  first.seal(byHand(7, 0, first.time(), {0}));
  ASSERT_EQ(touchpad.phase(), pipeline::LinkPhase::closed);
  second.connect();
  EXPECT_EQ(second.status, CallStatus::accepted);
}

TEST_F(TouchpadAgainstHands, ACallIsAnsweredAgainOnlyWhileItIsTheLastOfItsCaller) {
  Robot robot(*this, 1);
  const Packet answer = robot.call(vectorBytes("robot_hello"));
  ASSERT_FALSE(answer.empty());
  const Packet call = robot.called;
  EXPECT_EQ(robot.give(call), answer) << "the answer was lost on the way";

  // The caller's key under the cookie of another address, as one who has the key may write it.
  Robot other(*this, 2);
  Packet elsewhere = call;
  std::ranges::copy(other.cookie(), elsewhere.begin() + 2);
  expectRefused([&] { return other.give(elsewhere); }, LinkRefusal::repeated, "from another address");

  ASSERT_FALSE(robot.call(vectorBytes("robot_hello")).empty());
  expectRefused([&] { return robot.give(call); }, LinkRefusal::repeated, "it has called anew");
}

TEST_F(TouchpadAgainstHands, AConfirmationThatIsDamagedConfirmsNothing) {
  Robot robot(*this, 1);
  robot.prepare();
  expectRefused([&] { return robot.seal(byHand(5, 1, robot.time(), Packet(10, 0))); }, LinkRefusal::field, "a flag");
  EXPECT_FALSE(touchpad.peer());
  robot.seal(robot.heartbeat());
  EXPECT_TRUE(touchpad.peer());
}

TEST_F(TouchpadAgainstHands, CommandNineIsTheGoodbye) {
  Robot robot(*this, 1);
  robot.connect();
  EXPECT_FALSE(robot.seal(robot.command(1, 9)).empty());
  EXPECT_EQ(touchpad.phase(), pipeline::LinkPhase::closed);
  expectRefused([&] { return robot.seal(robot.state()); }, LinkRefusal::phase, "a state after it");
  EXPECT_TRUE(touchpad.farewell(now).empty()) << "said already";
}

TEST_F(TouchpadAgainstHands, FiguresNameEachRefusalWithItsCount) {
  const LinkFigures before = touchpad.figures(now);
  EXPECT_TRUE(before.refusals.empty());
  EXPECT_TRUE(std::isnan(before.period_ms)) << "unknown without a session";
  Robot robot(*this, 1);
  robot.give(Packet(40, 0));
  robot.connect();
  robot.seal(byHand(0, 0, robot.time(), {}));
  robot.seal(byHand(9, 0, robot.time(), {}));
  wait(7);
  const LinkFigures after = touchpad.figures(now);
  EXPECT_EQ(after.states, 1U);
  EXPECT_EQ(after.refused, 3U);
  ASSERT_EQ(after.refusals.size(), 2U);
  EXPECT_EQ(after.refusals[0].reason, "not FYD Link");
  EXPECT_EQ(after.refusals[0].count, 1U);
  EXPECT_EQ(after.refusals[1].reason, "message");
  EXPECT_EQ(after.refusals[1].count, 2U);
  EXPECT_NEAR(after.silence_ms, 7.0, 1e-9);
  EXPECT_EQ(after.lost, 0U);
  EXPECT_EQ(touchpad.name(), "FYD Link, sealed");
  EXPECT_EQ(touchpad.peerText(), "robot");
}

TEST(LinkFiguresOfALine, TellWhatTheLineLosesAndHowLongItTakes) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  pair.weather = {.delay_ms = 4.0, .loss = 0.3};
  pair.run(10.0);
  const LinkFigures figures = pair.touchpad.figures(pair.now);
  EXPECT_NEAR(figures.loss_percent, 30.0, 15.0) << "of 200 datagrams of the last second: ±3.2 is one deviation";
  EXPECT_NEAR(figures.round_trip_ms, 8.0, 2.0) << "two ways of 4 ms, in steps of 1 ms";
  EXPECT_EQ(pair.robot.counters().wrong_peer, 0U);
}

// --- the robot's end, and a touchpad played by hand

class RobotAgainstHands : public testing::Test {
 protected:
  RobotAgainstHands() { hello.board_text = "board"; }

  RobotReception give(const Packet& datagram, const Endpoint& from = LinkPair::kTouchpad) {
    return robot.handle(datagram, from, now);
  }
  /// What the robot sends in this tick.
  Packet tick(int ms = 1) {
    now += milliseconds(ms);
    const auto sent = robot.tick(now, {});
    return sent.empty() ? Packet{} : Packet(sent[0].bytes.begin(), sent[0].bytes.end());
  }
  /// Up to the call.
  void challenge() {
    HelloNonce nonce{};
    ASSERT_EQ(readHello(testKey(), tick(), nonce), LinkRefusal::none);
    const HelloBytes bytes = makeChallenge(testKey(), nonce, {});
    give({bytes.begin(), bytes.end()});
    call = tick();
  }
  Packet answerWith(const Packet& description) {
    Callee callee(testKey(), call);
    std::array<std::uint8_t, kMaximumLinkDatagram> plain{};
    const auto payload = callee.read(call, plain);
    EXPECT_TRUE(payload);
    Packet out(kMaximumLinkDatagram);
    out.resize(callee.write(description, seededRandom, out));
    sealer = Sealer(callee.keys().from_responder, sessionOf(callee.keys()));
    return out;
  }
  Packet description() {
    Callee callee(testKey(), call);
    std::array<std::uint8_t, kMaximumLinkDatagram> plain{};
    hello.sent_us = time();
    hello.echo_us = decodeRobotHello(*callee.read(call, plain)).value.sent_us;
    return written([&](auto out) { return encodeHello(hello, out); });
  }
  void connect() {
    challenge();
    EXPECT_TRUE(give(answerWith(description())).connected);
    ASSERT_EQ(robot.phase(), RobotPhase::running);
  }
  RobotReception seal(const Packet& message) { return give(sealedBy(sealer, message)); }
  [[nodiscard]] LinkTime time() const {
    return LinkTime{90'000'000} +
           static_cast<LinkTime>(std::chrono::duration_cast<std::chrono::microseconds>(now - begin).count());
  }
  void expectRefused(const std::function<void()>& what_is_given, LinkRefusal why, std::string_view what) {
    auto expected = robot.refusals();
    ++expected[static_cast<std::size_t>(why)];
    const RobotPhase phase = robot.phase();
    const auto touches = robot.counters().touches;
    what_is_given();
    EXPECT_EQ(robot.refusals(), expected) << what << ": expected \"" << toString(why) << '"';
    EXPECT_EQ(robot.phase(), phase) << what;
    EXPECT_EQ(robot.counters().touches, touches) << what;
  }

  Instant begin = instantAt(1000.0);
  Instant now = begin;
  LinkRobotEnd robot{LinkRobotSettings{}, testKey(), LinkPair::kTouchpad, seededRandom};
  TouchpadHello hello;
  Packet call;
  Sealer sealer;
};

TEST_F(RobotAgainstHands, WhatIsNotTheTouchpadsIsNotRead) {
  static_cast<void>(tick());
  give(vectorBytes("challenge"), linkAddress(7));
  EXPECT_EQ(robot.counters().wrong_peer, 1U);
  expectRefused([&] { give(Packet(40, 0)); }, LinkRefusal::magic, "zeros");
  expectRefused([&] { give({0xFD, 0x11}); }, LinkRefusal::kind, "a hello, which is the robot's");
  expectRefused([&] { give({0xFD, 0x14}); }, LinkRefusal::phase, "an answer before a call");
  Packet sealed(60, 0);
  sealed[0] = 0xFD;
  sealed[1] = 0x15;
  expectRefused([&] { give(sealed); }, LinkRefusal::phase, "sealed, before a session");
}

TEST_F(RobotAgainstHands, AChallengeOfAnotherHelloOrKeyIsNotAnswered) {
  EXPECT_EQ(robot.problem(), "no touchpad with this key answered");
  HelloNonce nonce{};
  ASSERT_EQ(readHello(testKey(), tick(), nonce), LinkRefusal::none);
  const auto challengeOf = [&](const LinkKey& key, const HelloNonce& of) {
    const HelloBytes bytes = makeChallenge(key, of, {});
    return Packet(bytes.begin(), bytes.end());
  };
  expectRefused([&] { give({0xFD, 0x12}); }, LinkRefusal::size, "cut short");
  expectRefused([&] { give(challengeOf(testKey(1), nonce)); }, LinkRefusal::key, "another key");
  expectRefused([&] { give(challengeOf(testKey(), HelloNonce{})); }, LinkRefusal::cookie, "another hello's");
  give(challengeOf(testKey(), nonce));
  EXPECT_EQ(robot.linkCounters().calls, 1U);
  EXPECT_EQ(robot.problem(), "the touchpad does not answer the call");
  expectRefused([&] { give(challengeOf(testKey(), nonce)); }, LinkRefusal::phase, "a second one");
}

TEST_F(RobotAgainstHands, AnAnswerThatIsDamagedOrWrongConnectsNothing) {
  challenge();
  expectRefused([&] { give({0xFD, 0x14}); }, LinkRefusal::key, "cut short");
  Packet flipped = answerWith(description());
  flipped.back() ^= 1U;
  expectRefused([&] { give(flipped); }, LinkRefusal::key, "one bit");
  Packet status = description();
  status[0] = 2;
  expectRefused([&] { give(answerWith(status)); }, LinkRefusal::field, "status 2");
}

TEST_F(RobotAgainstHands, MessagesThatAreNotAsThePageHasThemAreRefused) {
  connect();
  EXPECT_EQ(robot.problem(), "");
  const LinkTime time_us = time();
  const Packet info = written([&](auto out) { return encodeLink(LinkInfo{.board_text = "b"}, time_us, out); });
  Packet gain = info;
  gain[7 + 3] = 0x43;                                                        // k_vib, f32: 128 and more
  Packet image = byHand(8, 0, time_us, {1, 0, 2, 0, 0, 0, 0, 0, 'a', 'b'});  // picture 1, 2 bytes, fragment 0
  Packet large = image;
  large[7 + 4] = 0xFF;  // the picture's size
  Packet behind = image;
  behind[7 + 6] = 1;  // fragment 1 of a picture that has one
  const std::vector<Wrong> wrongs{
      {"a state, which is the robot's", byHand(2, 0, time_us, {0, 0}), LinkRefusal::message},
      {"a touch cut short", byHand(1, 0, time_us, {0, 0}), LinkRefusal::size},
      {"an acknowledgement cut short", byHand(4, 0, time_us, {1}), LinkRefusal::size},
      {"an acknowledgement with a flag", byHand(4, 1, time_us, {1, 0}), LinkRefusal::field},
      {"an acknowledgement of nothing", byHand(4, 0, time_us, {1, 0}), LinkRefusal::late},
      {"info cut short", cutBy(info, 1), LinkRefusal::size},
      {"info that is longer", longer(info), LinkRefusal::size},
      {"info with a gain above 100", gain, LinkRefusal::field},
      {"a picture's fragment cut short", cutBy(image, 1), LinkRefusal::size},
      {"a picture's fragment without a head", byHand(8, 0, time_us, {1, 0, 2}), LinkRefusal::size},
      {"a picture that is too large", large, LinkRefusal::field},
      {"a fragment behind the end", behind, LinkRefusal::field},
      {"goodbye for reason 2", byHand(7, 0, time_us, {2}), LinkRefusal::field},
  };
  for (const Wrong& wrong : wrongs) expectRefused([&] { seal(wrong.message); }, wrong.why, wrong.what);
  EXPECT_TRUE(seal(image).image) << "the session goes on";
  EXPECT_EQ(robot.image().size(), 2U);
  EXPECT_TRUE(seal(info).info) << "info that was not asked for is taken";
  EXPECT_EQ(robot.phase(), RobotPhase::running) << "and pauses nothing";
  EXPECT_EQ(robot.boardText(), "b");
}

constexpr std::uint32_t kTwoFragments = 2 * kImageFragment;

TEST_F(RobotAgainstHands, EachFragmentOfAPictureIsTakenOnceAndAnOlderPictureNeverAgain) {
  connect();
  const auto completes = [&](std::uint8_t picture, std::uint8_t index, std::uint32_t size = kTwoFragments) {
    Packet body{picture, 0};
    for (unsigned i = 0; i < 4; ++i) body.push_back(static_cast<std::uint8_t>(size >> (8 * i)));
    body.insert(body.end(), {index, 0});
    body.resize(body.size() + std::min<std::size_t>(kImageFragment, size - index * kImageFragment), picture);
    return seal(byHand(8, 0, time(), body)).image;
  };
  EXPECT_FALSE(completes(5, 0));
  EXPECT_FALSE(completes(5, 0)) << "twice the same is not both";
  EXPECT_FALSE(completes(4, 1)) << "of the picture before";
  EXPECT_TRUE(completes(5, 1));
  EXPECT_FALSE(completes(5, 1)) << "it is whole already";
  EXPECT_EQ(Packet(robot.image().begin(), robot.image().end()), Packet(kTwoFragments, 5));
  EXPECT_FALSE(completes(5, 0, kTwoFragments - 1)) << "the same number, another length: begins anew";
  EXPECT_TRUE(completes(5, 1, kTwoFragments - 1));
  EXPECT_EQ(robot.image().size(), kTwoFragments - 1);

  seal(byHand(7, 0, time(), {0}));
  ASSERT_EQ(robot.phase(), RobotPhase::handshake);
  now += LinkRobotSettings{}.refused_pause;
  connect();
  EXPECT_FALSE(completes(1, 0)) << "in a new session, numbers begin anew";
  EXPECT_TRUE(completes(1, 1));
  EXPECT_EQ(robot.refusals(), LinkRefusalCounters{});
}

TEST_F(RobotAgainstHands, ItsOperatorMayLeaveBeforeATouchpadAnswers) {
  EXPECT_TRUE(robot.command(pipeline::RobotCommand::none)) << "nothing to be done";
  static_cast<void>(tick());
  EXPECT_TRUE(robot.command(pipeline::RobotCommand::disconnect));
  EXPECT_TRUE(tick().empty());
  EXPECT_EQ(robot.phase(), RobotPhase::closed);
  EXPECT_FALSE(robot.replyDue());
  EXPECT_TRUE(tick(300).empty()) << "for good";
}

TEST(LinkRobotSettings, AWorkspaceThatCannotBeCodedIsReplacedByTheDefault) {
  LinkRobotSettings settings;
  settings.workspace.precision_mm = 0.0;
  LinkPair pair({}, settings);
  ASSERT_TRUE(pair.connect());
  pair.run(0.1);
  EXPECT_NEAR(pair.state.position_mm.z, -3.0, 0.02) << "as sent";
}

// --- no room

TEST(LinkHandshake, WithoutRoomNothingIsWrittenOrRead) {
  const Packet payload = vectorBytes("robot_hello");
  Packet room(kMaximumLinkDatagram);
  const auto only = [&room](std::size_t size) { return std::span(room).first(size); };
  Caller caller(testKey(), Cookie{}, seededRandom);
  EXPECT_EQ(caller.write(payload, only(kCallHeader - 1)), 0U);
  EXPECT_EQ(caller.write(payload, only(kCallHeader + kNoiseOverhead + payload.size() - 1)), 0U);
  const Packet call(room.begin(), room.begin() + static_cast<std::ptrdiff_t>(caller.write(payload, room)));
  ASSERT_EQ(call.size(), kCallHeader + kNoiseOverhead + payload.size());
  EXPECT_FALSE(Callee(testKey(), call).read(call, only(payload.size() - 1)));
  EXPECT_FALSE(Callee(testKey(), call).read(Bytes(call).first(kCallHeader + kNoiseOverhead - 1), room));
  Callee callee(testKey(), call);
  ASSERT_TRUE(callee.read(call, room));
  EXPECT_EQ(callee.write(payload, seededRandom, only(kAnswerHeader - 1)), 0U);
  EXPECT_EQ(callee.write(payload, seededRandom, only(kAnswerHeader + kNoiseOverhead + payload.size() - 1)), 0U);
  const Packet answer(room.begin(),
                      room.begin() + static_cast<std::ptrdiff_t>(callee.write(payload, seededRandom, room)));
  EXPECT_FALSE(caller.read(Bytes(answer).first(kAnswerHeader - 1), room));
  EXPECT_TRUE(caller.read(answer, room));

  // An answer whose public key makes every shared secret zero, from one who has the key.
  Packet unsound(kAnswerHeader + kNoiseOverhead, 0);
  Caller other(testKey(), Cookie{}, seededRandom);
  ASSERT_GT(other.write(payload, room), 0U);
  EXPECT_FALSE(other.read(unsound, room));
}

TEST(SealedChannel, WithoutRoomNothingIsSealedOrOpened) {
  const SecretBytes<32> key = testKey().handshakeKey();
  Sealer sealer(key, 77);
  Packet packet(20 + kSealOverhead);
  EXPECT_EQ(sealer.seal(packet, 0), 0U);
  EXPECT_EQ(sealer.seal(packet, 21), 0U);
  ASSERT_EQ(sealer.seal(packet, 20), packet.size());
  EXPECT_EQ(sealer.counter(), 1U) << "what was not sealed used no number";
  Opener opener(key, 77);
  Packet plain(19);
  EXPECT_EQ(opener.open(packet, plain).refusal, LinkRefusal::size);
  plain.resize(20);
  EXPECT_TRUE(opener.open(packet, plain).ok());
}

// --- pictures and the key's file

TEST(ImageSender, RefusesWhatIsEmptyTooLongOrComesWhileItIsBusy) {
  ImageSender sender;
  EXPECT_FALSE(sender.begin({}));
  EXPECT_FALSE(sender.begin(Packet(kMaximumLinkImage + 1)));
  EXPECT_TRUE(sender.begin(Packet(kMaximumLinkImage)));
  EXPECT_FALSE(sender.begin(Packet(1)));
  sender.stop();
  EXPECT_TRUE(sender.begin(Packet(1)));
}

TEST(LinkKeyFile, OfAnotherSystemsEditorIsReadAndALongFileIsNone) {
  const Folder folder;
  const std::string path = folder.file("key");
  const auto put = [&](const std::string& text) {
    std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
    ASSERT_EQ(::chmod(path.c_str(), 0600), 0);
  };
  put("# a key\r\n\r\nfyd-link-key 1\r\n" + testKey().words() + "\r\n");
  EXPECT_EQ(readKeyFile(path)->fingerprint(), testKey().fingerprint());
  put(std::string(4095, '#'));
  EXPECT_THAT(readKeyFile(path).error().text(), testing::HasSubstr("no key"));
  put(std::string(4096, '#'));
  EXPECT_THAT(readKeyFile(path).error().text(), testing::HasSubstr("longer than 4095 bytes"));
}

TEST(LinkKeyFile, ThatCannotBeWrittenWholeIsNotLeftBehind) {
  const Folder folder;
  const auto done = [&] {
    const FilesOfAtMost small(20);
    return writeKeyFile(testKey(), folder.file("key"));
  }();
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().text(), testing::HasSubstr("File too large"));
  EXPECT_FALSE(std::ifstream(folder.file("key")).good());
}

}  // namespace
}  // namespace fyd::protocol
