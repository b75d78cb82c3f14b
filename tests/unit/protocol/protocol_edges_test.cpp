// Values at the edge of what a message holds, of what a position can be coded to and of what a clock can say.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/protocol/classic/classic_codec.h"
#include "core/protocol/link/link_clock.h"
#include "core/protocol/link/link_codec.h"
#include "core/protocol/registers/register_codec.h"
#include "core/protocol/touch_mapping.h"
#include "tests/not_a_number.h"
#include "tests/unit/protocol/link_pair.h"

namespace fyd::protocol {
namespace {

using EdgeBytes = std::vector<std::uint8_t>;

EdgeBytes edgeBytes(std::string_view text) { return {text.begin(), text.end()}; }

TEST(ClassicTouch, OfALiftedFingerWhosePositionIsNoNumberIsZero) {
  const auto packet = encodeTouch({.position_mm = {kNaN, 1, 1}, .in_contact = false});
  EXPECT_EQ(std::string(packet.begin(), packet.end()), "?0'00000:0'00000:0'00000:0'00000.\n");
}

TEST(ClassicAck, OneWrongLetterMakesItNone) {
  for (const char* wrong : {"BCK", "ABK", "ACC", "AC", "ACKK"}) EXPECT_FALSE(isAck(edgeBytes(wrong))) << wrong;
  EXPECT_TRUE(isAck(edgeBytes("ACK")));
}

TEST(Endpoint, ABracketOnOneSideOnlyIsNoIpv6Address) {
  EXPECT_FALSE(parseEndpoint("[::1:3490"));
  EXPECT_FALSE(parseEndpoint("[10.0.0.1:3490"));
  EXPECT_TRUE(parseEndpoint("[::1]:3490"));
}

TEST(Endpoint, DiffersInAddressScopePortAndFamily) {
  const Endpoint one = *parseEndpoint("[fe80::1]:3490");
  Endpoint other = one;
  EXPECT_EQ(one, other);
  other.scope = one.scope + 1;
  EXPECT_NE(one, other) << "the same address on another interface";
  other = one;
  other.port = 3491;
  EXPECT_NE(one, other);
  other = one;
  other.v6 = false;
  EXPECT_NE(one, other);
  other = one;
  other.address[15] = 2;
  EXPECT_NE(one, other);
}

TEST(PeerClock, ASampleThatContradictsTheBestOneMeansThatAClockJumpedAndTakesItsPlace) {
  PeerClock clock;
  constexpr LinkTime kAt = 20'000'000;
  // Theirs is 5 s ahead; round trip 2 ms.
  EXPECT_EQ(clock.sample(kAt, kAt + 5'000'000 - 1'000, kAt - 2'000, 0), 2'000);
  EXPECT_EQ(clock.offset_us(), 5'000'000);
  // A worse round trip that agrees is not taken.
  EXPECT_EQ(clock.sample(kAt + 1'000, kAt + 5'000'000, kAt + 1'000 - 9'000, 0), 9'000);
  EXPECT_EQ(clock.offset_us(), 5'000'000);
  // One that says 60 s, by far more than both round trips explain, is.
  EXPECT_EQ(clock.sample(kAt + 2'000, kAt + 60'000'000, kAt + 2'000 - 9'000, 0), 9'000);
  EXPECT_NEAR(static_cast<double>(clock.offset_us()), 60e6, 10e3);
  EXPECT_LT(clock.sample(kAt, kAt, kAt + 1'000'000, 0), 0) << "an echo from the future is impossible";
}

EdgeBytes coded(const LinkState& state, const PositionCode& code) {
  EdgeBytes out(kMaximumLinkMessage);
  out.resize(encodeLink(state, code, 1, out));
  return out;
}

TEST(LinkCodec, EachMotorReferenceIsHeldToItsRange) {
  const PositionCode code = *PositionCode::make(asOnTheWire(RobotHello{}.workspace));
  const EdgeBytes good = coded({.motor_reference = pipeline::RobotMotorReference{1, 2}}, code);
  const float two_million = 2e6F;
  for (const std::size_t from_end : {9U, 5U}) {  // both f32, then the count of accelerations
    for (const float value : {two_million, -two_million, std::numeric_limits<float>::quiet_NaN()}) {
      EdgeBytes bad = good;
      std::memcpy(bad.data() + bad.size() - from_end, &value, sizeof value);
      EXPECT_EQ(decodeState(decodeEnvelope(bad).value, code).refusal, LinkRefusal::field) << from_end << ' ' << value;
    }
  }
  EXPECT_TRUE(decodeState(decodeEnvelope(good).value, code).ok());
}

TEST(LinkCodec, AStiffnessThatIsNoNumberIsSentAsZero) {
  const PositionCode code = *PositionCode::make(asOnTheWire(RobotHello{}.workspace));
  const EdgeBytes bytes = coded({.robot = {.stiffness_N_per_mm = kNaN}}, code);
  EXPECT_EQ(decodeState(decodeEnvelope(bytes).value, code).value.robot.stiffness_N_per_mm, 0.0);
}

TEST(LinkCodec, NoMessageIsLongerThanTheLongest) {
  EdgeBytes longest(kMaximumLinkMessage, 0);
  longest[0] = 8;
  EXPECT_TRUE(decodeEnvelope(longest).ok());
  longest.push_back(0);
  EXPECT_EQ(decodeEnvelope(longest).refusal, LinkRefusal::size);
}

TEST(LinkCodec, WhatDoesNotFitIsNotWritten) {
  const EdgeBytes picture(4, 7);
  EdgeBytes out(32);
  EXPECT_EQ(encodeLink(LinkImageFragment{.size = 4, .bytes = picture}, 1, std::span(out).first(18)), 0U);
  EXPECT_EQ(encodeLink(LinkImageFragment{.size = 4, .bytes = picture}, 1, std::span(out).first(19)), 19U);
  EXPECT_EQ(encodeLink(LinkImageFragment{.size = 4}, 1, out), 15U) << "no bytes are nothing to write";
}

TEST(LinkCodec, ADeleteCharacterIsNotPrintable) {
  EdgeBytes out(kMaximumLinkMessage);
  out.resize(encodeLink(LinkInfo{.board_text = "a\x7f"
                                               "b"},
                        1, out));
  EXPECT_EQ(out[out.size() - 2], '?');
  out[out.size() - 2] = 0x7F;
  EXPECT_EQ(decodeInfo(decodeEnvelope(out).value).refusal, LinkRefusal::field);
  DeviceIdentity identity;
  identity.setSerial(
      "FYD\x7f"
      "1");
  EXPECT_EQ(identity.serialText(), "FYD");
}

TEST(PositionCode, RefusesWorkspacesSoSmallThatTheirCellsAreNone) {
  const double least = std::numeric_limits<double>::denorm_min();
  const auto make = [](double extent, double precision) {
    return PositionCode::make({.minimum_mm = {}, .maximum_mm = {extent, extent, extent}, .precision_mm = precision});
  };
  EXPECT_TRUE(make(1e-300, 1e-300));
  EXPECT_FALSE(make(1e-300, 1e300)) << "less than one cell";
  EXPECT_FALSE(make(least, least)) << "more cells in a millimetre than a number can say";
}

TEST(TouchMapping, APlaceThatIsNoNumberKeepsTheLast) {
  TouchMapping mapping;
  mapping.reset({1, 2, 3});
  mapping.reset({kNaN, 2, 3});
  EXPECT_EQ(mapping.apply({.position_mm = {kNaN, 0, 0}}), (Vec3{1, 2, 3}));
}

TEST(TouchMapping, AWeightThatIsNoNumberMovesNothing) {
  TouchMapping mapping({.keep_z = kNaN});
  mapping.reset({1, 2, 3});
  EXPECT_EQ(mapping.apply({.position_mm = {4, 5, -6}, .in_contact = true}), (Vec3{1, 2, 3}));
}

TEST(LinkEnds, ATouchSaysWhereThePictureShowedTheFingerAndWhen) {
  LinkPair pair;
  ASSERT_TRUE(pair.connect());
  pair.on_step = [&] {
    pair.answer.touch.seen =
        pipeline::SeenFinger{.x_mm = -7.0, .y_mm = 4.0, .taken = pair.now - std::chrono::milliseconds(20)};
  };
  pair.run(0.1);
  ASSERT_TRUE(pair.robot.touch());
  EXPECT_NEAR(pair.robot.touch()->position_mm.x, -7.0, 0.02) << "not the position sent";
  EXPECT_NEAR(pair.robot.touch()->position_mm.y, 4.0, 0.02);
  EXPECT_NEAR(pair.robot.touch()->position_mm.z, -2.5, 0.02);
  EXPECT_NEAR(pair.robot.touch()->age_s, 0.021, 0.0015);
}

TEST(LinkEnds, AnEndWithoutASessionHasNothingToSay) {
  LinkPair pair;
  EXPECT_TRUE(pair.touchpad.farewell(pair.now).empty());
  EXPECT_TRUE(pair.touchpad.advance(pair.now, pair.answer).empty());
}

}  // namespace
}  // namespace fyd::protocol
