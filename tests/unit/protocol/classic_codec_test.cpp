// Expected bytes are written by hand from the layouts, never by the code under test.
#include "core/protocol/classic/classic_codec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <string_view>

#include "tests/not_a_number.h"
#include "tests/unit/protocol/classic_text.h"

namespace fyd::protocol {
namespace {

using namespace std::string_view_literals;
using pipeline::RobotCommand;
using pipeline::TouchMessage;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::string padded(std::string_view text, std::size_t size) {
  std::string out(text);
  out.resize(size, '\0');
  return out;
}

// ---- exact bytes ----

TEST(ClassicState, IsWrittenByteForByte) {
  const ClassicState state{.command = RobotCommand::use_dft321,
                           .acceleration_g = {1.0, -2.0, 0.0001},
                           .robot = {.stiffness_N_per_mm = 0.6123, .position_mm = {12.9, -7.9, -0.6}, .button = true}};
  EXPECT_EQ(text(encodeState(state)), "?3,0'06553:1'13106:0'00001:1,0'00012:1'00007:0'00000:0'06123.\n");
}

TEST(ClassicState, IsReadBack) {
  const auto decoded = decodeState(bytesOf("?4,1'00655:0'32767:1'32768:0,1'00070:0'00035:0'00000:0'05500.\n"));
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded.value.command, RobotCommand::use_soc);
  EXPECT_NEAR(decoded.value.acceleration_g.x, -655.0 / 6553.0, 1e-12);
  EXPECT_NEAR(decoded.value.acceleration_g.y, 32767.0 / 6553.0, 1e-12);
  EXPECT_NEAR(decoded.value.acceleration_g.z, -32768.0 / 6553.0, 1e-12);
  EXPECT_FALSE(decoded.value.robot.button);
  EXPECT_EQ(decoded.value.robot.position_mm, (Vec3{-70.0, 35.0, 0.0}));
  EXPECT_NEAR(decoded.value.robot.stiffness_N_per_mm, 0.55, 1e-12);
  EXPECT_TRUE(decoded.value.stiffness_known);
}

TEST(ClassicState, PublishedRobotsPacketIsRead) {
  const auto decoded = decodeState(bytesOf("?0,0'00000:0'00000:0'00000:1,0'00000:0'00000:0'00000:0'06000.\n"));
  ASSERT_TRUE(decoded.ok());
  EXPECT_TRUE(decoded.value.robot.button);
  EXPECT_NEAR(decoded.value.robot.stiffness_N_per_mm, 0.6, 1e-12);
}

TEST(ClassicState, EveryCommandHasItsCharacter) {
  constexpr std::string_view kCharacters = "0123456789:;";
  for (std::size_t i = 0; i < kCharacters.size(); ++i) {
    const auto packet = encodeState({.command = static_cast<RobotCommand>(i)});
    EXPECT_EQ(packet[1], static_cast<std::uint8_t>(kCharacters[i]));
    EXPECT_EQ(static_cast<std::size_t>(decodeState(packet).value.command), i);
  }
}

TEST(ClassicState, ValuesBeyondTheLayoutSaturateAndNeverWrap) {
  const ClassicState state{
      .acceleration_g = {1e9, -1e9, kNaN},
      .robot = {.stiffness_N_per_mm = kInfinity, .position_mm = {40000.0, -40000.0, 32767.9}, .button = false}};
  EXPECT_EQ(text(encodeState(state)), "?0,0'32767:1'32767:0'00000:0,0'32767:1'32767:0'32767:0'32767.\n");
  EXPECT_EQ(text(encodeState({.robot = {.stiffness_N_per_mm = -0.3}})).substr(53, 7), "0'00000");
  EXPECT_EQ(text(encodeState({.robot = {.stiffness_N_per_mm = kNaN}})).substr(53, 7), "0'00000");
}

TEST(ClassicTouch, IsWrittenByteForByte) {
  EXPECT_EQ(text(encodeTouch({.position_mm = {-12.7, 8.2, -3.99}, .in_contact = true, .force_N = 1.23456})),
            "?1'00012:0'00008:1'00003:0'12346.\n");
}

TEST(ClassicTouch, ForceSaturatesAtItsLargestValue) {
  EXPECT_EQ(text(encodeTouch({.force_N = 3.2767})), "?0'00000:0'00000:0'00000:0'32767.\n");
  for (const double force : {3.2768, 6.5536, 7.65, 1e300, kInfinity}) {
    EXPECT_EQ(text(encodeTouch({.force_N = force})).substr(25, 7), "0'32767") << force;
  }
  for (const double force : {-1e-9, -5.0, -kInfinity, kNaN}) {
    EXPECT_EQ(text(encodeTouch({.force_N = force})).substr(25, 7), "0'00000") << force;
  }
}

TEST(ClassicTouch, LiftedFingerHoldsXAndY) {
  EXPECT_EQ(text(encodeTouch({.position_mm = {20.0, 10.0, -1.5}, .in_contact = false, .force_N = 0.0})),
            "?0'00000:0'00000:1'00001:0'00000.\n");
}

TEST(ClassicTouch, PositionThatIsNoNumberHoldsAndLifts) {
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    for (const Vec3 position : {Vec3{bad, 5.0, -4.0}, Vec3{5.0, bad, -4.0}, Vec3{5.0, 5.0, bad}}) {
      EXPECT_EQ(text(encodeTouch({.position_mm = position, .in_contact = true, .force_N = 0.5})),
                "?0'00000:0'00000:0'00000:0'05000.\n");
    }
  }
}

TEST(ClassicTouch, IsReadBack) {
  const auto decoded = decodeTouch(bytesOf("?1'00012:0'00008:1'00003:0'12346.\n"));
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded.value.position_mm, (Vec3{-12.0, 8.0, -3.0}));
  EXPECT_TRUE(decoded.value.in_contact);
  EXPECT_NEAR(decoded.value.force_N, 1.2346, 1e-12);
  EXPECT_FALSE(decodeTouch(bytesOf("?0'00000:0'00000:1'00003:0'12346.\n")).value.in_contact);
  EXPECT_TRUE(decodeTouch(bytesOf("?0'00000:0'00001:1'00003:0'12346.\n")).value.in_contact);
  EXPECT_EQ(decodeTouch(bytesOf("?0'00000:0'00001:1'00003:1'12346.\n")).value.force_N, 0.0);
}

TEST(ClassicAck, IsThreeLettersAndNuls) {
  const auto ack = encodeAck();
  EXPECT_EQ(text(ack), padded("ACK", 62));
  EXPECT_TRUE(isAck(ack));
  EXPECT_TRUE(isAck(bytesOf("ACK")));
  EXPECT_FALSE(isAck(bytesOf("AC")));
  EXPECT_FALSE(isAck(bytesOf("ACKN")));
  EXPECT_FALSE(isAck(bytesOf("")));
  EXPECT_FALSE(isAck(bytesOf("\0ACK"sv)));
  EXPECT_FALSE(isAck(bytesOf(padded("ACK", 63))));
}

TEST(TouchpadInfo, IsWrittenByteForByte) {
  EXPECT_EQ(text(encodeInfoLength(87)), "00087");
  EXPECT_EQ(text(encodeInfoLength(99999)), "01209");
  EXPECT_EQ(text(encodeInfoValues({.k_vib = 1.3, .reference_ticks = {4200.0, -4199.6}})), "^013^0'04200^1'04200");
  EXPECT_EQ(text(encodeInfoValues({.k_vib = 1e9, .reference_ticks = {1e9, kNaN}})), "^999^0'32767^0'00000");
  EXPECT_EQ(text(encodeInfoValues({.k_vib = -1.0})), "^000^0'00000^0'00000");
  const auto decoded = decodeInfoValues(bytesOf("^025^0'00933^1'00933"));
  ASSERT_TRUE(decoded.ok());
  EXPECT_NEAR(decoded.value.k_vib, 2.5, 1e-12);
  EXPECT_EQ(decoded.value.reference_ticks[1], -933.0);
  EXPECT_EQ(decodeInfoLength(bytesOf("01209")).value, 1209U);
  EXPECT_EQ(decodeInfoLength(bytesOf("01210")).refusal, ClassicRefusal::range);
}

TEST(ClassicMotorReference, IsWrittenByteForByte) {
  EXPECT_EQ(text(encodeMotorReference({.first_ticks = 4200.4, .second_ticks = -1234.6})), "0'04200:1'01235.\n");
  const auto decoded = decodeMotorReference(bytesOf("1'00100:0'04200.\n"));
  ASSERT_TRUE(decoded.ok());
  EXPECT_EQ(decoded.value.first_ticks, -100.0);
  EXPECT_EQ(decoded.value.second_ticks, 4200.0);
}

TEST(ClassicImage, LengthIsSixDigitsBelow57600) {
  EXPECT_EQ(text(encodeImageLength(57'599)), "057599");
  EXPECT_EQ(decodeImageLength(bytesOf("057599")).value, 57'599U);
  EXPECT_EQ(decodeImageLength(bytesOf("057600")).refusal, ClassicRefusal::range);
  EXPECT_EQ(decodeImageLength(bytesOf("000000")).value, 0U);
}

// ---- sloppy senders ----

TEST(ClassicState, SixCharacterMagnitudesAreReadAsTheOverflowTheyAre) {
  // Position y of −40000 prints "-25536" and costs the packet its last byte.
  const auto one = decodeState(bytesOf("?0,0'00000:0'00000:0'00000:1,0'00001:1'-25536:0'00003:0'06000."));
  ASSERT_TRUE(one.ok());
  EXPECT_EQ(one.value.robot.position_mm, (Vec3{1.0, -40000.0, 3.0}));
  EXPECT_NEAR(one.value.robot.stiffness_N_per_mm, 0.6, 1e-12);
  // −32768 in the stiffness itself: no stiffness can be negative.
  const auto stiffness = decodeState(bytesOf("?0,0'00000:0'00000:0'00000:1,0'00001:0'00002:0'00003:1'-32768."));
  ASSERT_TRUE(stiffness.ok());
  EXPECT_TRUE(stiffness.value.stiffness_known);
  EXPECT_EQ(stiffness.value.robot.stiffness_N_per_mm, 0.0);
}

TEST(ClassicState, StiffnessThatTheCutTookIsUnknownAndTheRestIsRead) {
  const std::string full = "?2,0'06553:0'00000:0'00000:1,1'-25536:1'-25536:1'-32768:0'06000.\n";
  ASSERT_EQ(full.size(), 65U);
  const auto decoded = decodeState(bytesOf(std::string_view(full).substr(0, 62)));
  ASSERT_TRUE(decoded.ok());
  EXPECT_FALSE(decoded.value.stiffness_known);
  EXPECT_EQ(decoded.value.command, RobotCommand::vibration_up);
  EXPECT_EQ(decoded.value.robot.position_mm, (Vec3{-40000.0, -40000.0, -32768.0}));
  EXPECT_NEAR(decoded.value.acceleration_g.x, 1.0, 1e-12);
}

TEST(ClassicState, PaddingAndMissingEndMarksAreTolerated) {
  const std::string packet = "?0,0'00000:0'00000:0'00000:0,0'00000:0'00000:0'00000:0'05500.\n";
  EXPECT_TRUE(decodeState(bytesOf(padded(packet, 102))).ok());
  EXPECT_TRUE(decodeState(bytesOf(packet.substr(0, 61))).ok());
  EXPECT_TRUE(decodeState(bytesOf(packet.substr(0, 60))).ok());
  EXPECT_EQ(decodeState(bytesOf(packet.substr(0, 59))).refusal, ClassicRefusal::size);
  EXPECT_EQ(decodeState(bytesOf(packet + "x")).refusal, ClassicRefusal::size);
}

TEST(ClassicState, EachKindOfDamageHasItsReason) {
  const std::string good = "?0,0'00000:0'00000:0'00000:0,0'00000:0'00000:0'00000:0'05500.\n";
  const auto refusal = [&](std::size_t at, char c) {
    std::string packet = good;
    packet[at] = c;
    return decodeState(bytesOf(packet)).refusal;
  };
  EXPECT_EQ(refusal(0, '!'), ClassicRefusal::mark);
  EXPECT_EQ(refusal(1, '<'), ClassicRefusal::command);
  EXPECT_EQ(refusal(2, ';'), ClassicRefusal::separator);
  EXPECT_EQ(refusal(3, '2'), ClassicRefusal::sign);
  EXPECT_EQ(refusal(4, '"'), ClassicRefusal::separator);
  EXPECT_EQ(refusal(6, 'a'), ClassicRefusal::digit);
  EXPECT_EQ(refusal(10, ','), ClassicRefusal::separator);
  EXPECT_EQ(refusal(27, '2'), ClassicRefusal::button);
  EXPECT_EQ(refusal(60, ','), ClassicRefusal::mark);
  EXPECT_EQ(refusal(61, '\r'), ClassicRefusal::mark);
  EXPECT_EQ(refusal(31, '9'), ClassicRefusal::range);  // 90000: no 16-bit sender can mean it
  EXPECT_EQ(refusal(30, '\0'), ClassicRefusal::separator);
}

TEST(ClassicState, OverflowedMagnitudesOutsideSixteenBitsAreRefused) {
  for (const std::string_view field : {"1'-00000", "1'-32769", "1'-99999"}) {
    const std::string packet = fmt::format("?0,0'00000:0'00000:0'00000:0,{}:0'00000:0'00000:0'05500.", field);
    EXPECT_EQ(decodeState(bytesOf(packet)).refusal, ClassicRefusal::range) << field;
  }
}

TEST(ClassicState, IsRecognisedByItsSizeAndOneMark) {
  std::string packet = "?0,0'00000:0'00000:0'00000:0,0'00000:0'00000:0'00000:0'05500.\n";
  EXPECT_TRUE(looksLikeState(bytesOf(packet)));
  packet[0] = 'x';
  EXPECT_TRUE(looksLikeState(bytesOf(packet)));
  packet[61] = 'x';
  EXPECT_FALSE(looksLikeState(bytesOf(packet)));
  EXPECT_FALSE(looksLikeState(bytesOf("?0,")));
  EXPECT_FALSE(looksLikeState(encodeAck()));
}

// ---- whatever arrives: refused with a reason, or well-formed ----

void expectWellFormed(Bytes packet) {
  if (const auto state = decodeState(packet); state.ok()) {
    EXPECT_TRUE(state.value.acceleration_g.finite());
    EXPECT_TRUE(state.value.robot.position_mm.finite());
    EXPECT_GE(state.value.robot.stiffness_N_per_mm, 0.0);
    EXPECT_LE(state.value.robot.stiffness_N_per_mm, 6.5535);
    EXPECT_LE(static_cast<int>(state.value.command), 11);
    EXPECT_LE(state.value.acceleration_g.norm(), 17.4);
  }
  if (const auto touch = decodeTouch(packet); touch.ok()) {
    EXPECT_TRUE(touch.value.position_mm.finite());
    EXPECT_GE(touch.value.force_N, 0.0);
    EXPECT_LE(touch.value.force_N, 6.5535);
  }
  if (const auto info = decodeInfoValues(packet); info.ok()) {
    EXPECT_GE(info.value.k_vib, 0.0);
    EXPECT_LE(info.value.k_vib, 99.9);
  }
  if (const auto reference = decodeMotorReference(packet); reference.ok()) {
    EXPECT_LE(std::abs(reference.value.first_ticks), 65'535.0);
    EXPECT_LE(std::abs(reference.value.second_ticks), 65'535.0);
  }
  if (const auto length = decodeInfoLength(packet); length.ok()) {
    EXPECT_LE(length.value, kClassicMaximumBoardText);
  }
  if (const auto length = decodeImageLength(packet); length.ok()) {
    EXPECT_LE(length.value, kClassicMaximumImage);
  }
}

std::vector<std::string> validPackets() {
  return {"?9,1'32768:0'32767:1'00655:1,1'00070:0'00035:1'00001:0'07150.\n",
          "?0,0'00000:0'00000:0'00000:1,1'-25536:1'-25536:1'-32768:0'06",
          "?1'00012:0'00008:1'00003:0'12346.\n",
          padded("ACK", 62),
          "^013^0'04200^1'04200",
          "0'04200:1'01235.\n",
          "01209",
          "057599"};
}

TEST(ClassicCodec, EverySingleBitFlipIsRefusedOrWellFormed) {
  for (const std::string& packet : validPackets()) {
    for (std::size_t bit = 0; bit < 8 * packet.size(); ++bit) {
      std::string flipped = packet;
      flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ (1 << (bit % 8)));
      expectWellFormed(bytesOf(flipped));
    }
  }
}

TEST(ClassicCodec, TruncationAtEveryByteIsRefusedOrWellFormed) {
  for (const std::string& packet : validPackets()) {
    for (std::size_t size = 0; size < packet.size(); ++size) expectWellFormed(bytesOf(packet).first(size));
  }
}

TEST(ClassicCodec, TruncationThatTakesMoreThanTheClosingMarksIsRefused) {
  const auto all = validPackets();
  for (std::size_t size = 0; size < 60; ++size) {
    EXPECT_FALSE(decodeState(bytesOf(all[0]).first(size)).ok()) << size;
    EXPECT_FALSE(decodeState(bytesOf(all[1]).first(size)).ok()) << size;
  }
  for (std::size_t size = 0; size < 32; ++size) EXPECT_FALSE(decodeTouch(bytesOf(all[2]).first(size)).ok()) << size;
  for (std::size_t size = 0; size < 20; ++size)
    EXPECT_FALSE(decodeInfoValues(bytesOf(all[4]).first(size)).ok()) << size;
  for (std::size_t size = 0; size < 15; ++size) {
    EXPECT_FALSE(decodeMotorReference(bytesOf(all[5]).first(size)).ok()) << size;
  }
  for (std::size_t size = 0; size < 5; ++size) EXPECT_FALSE(decodeInfoLength(bytesOf(all[6]).first(size)).ok()) << size;
  for (std::size_t size = 0; size < 6; ++size)
    EXPECT_FALSE(decodeImageLength(bytesOf(all[7]).first(size)).ok()) << size;
}

TEST(ClassicCodec, RandomBytesAreRefusedOrWellFormed) {
  std::mt19937_64 random(1);
  constexpr std::string_view kAlphabet = "?0123456789',:.\n-^ACK";
  for (int i = 0; i < 200'000; ++i) {
    std::string packet(random() % 80, '\0');
    for (char& c : packet) {
      c = i % 2 == 0 ? static_cast<char>(random()) : kAlphabet[random() % kAlphabet.size()];
    }
    expectWellFormed(bytesOf(packet));
  }
}

TEST(ClassicCodec, EveryCountOfEveryFieldRoundTrips) {
  for (int count = -kClassicMaximumCount; count <= kClassicMaximumCount; ++count) {
    const double magnitude = std::abs(count);
    const auto state = decodeState(encodeState(
        {.acceleration_g = {count / 6553.0, 0, -count / 6553.0},
         .robot = {.stiffness_N_per_mm = magnitude / 1e4, .position_mm = {double(count), double(-count), 0}}}));
    ASSERT_TRUE(state.ok());
    ASSERT_EQ(std::lround(state.value.acceleration_g.x * 6553.0), count);
    ASSERT_EQ(std::lround(state.value.acceleration_g.z * 6553.0), -count);
    ASSERT_EQ(state.value.robot.position_mm.x, count);
    ASSERT_EQ(std::lround(state.value.robot.stiffness_N_per_mm * 1e4), std::abs(count));
    const auto touch = decodeTouch(encodeTouch(
        {.position_mm = {double(count), 1.0, double(count)}, .in_contact = true, .force_N = magnitude / 1e4}));
    ASSERT_TRUE(touch.ok());
    ASSERT_EQ(touch.value.position_mm.z, count);
    ASSERT_EQ(std::lround(touch.value.force_N * 1e4), std::abs(count));
  }
}

}  // namespace
}  // namespace fyd::protocol
