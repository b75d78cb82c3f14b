// What an end of FYD Link says of itself, and a state, with one field out of the range that manual/protocol.md gives it:
// the bytes of the second implementation's vectors with that field replaced.
#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/protocol/link/link_codec.h"
#include "core/protocol/link/link_handshake.h"
#include "core/protocol/link/link_keys.h"
#include "tests/unit/protocol/link_pair.h"

namespace fyd::protocol {
namespace {

constexpr float kNoFloat = std::numeric_limits<float>::quiet_NaN();

/// With a 32-bit number in place of the one that begins at the byte `at`.
Packet withNumber(Packet bytes, std::size_t at, float value) {
  std::memcpy(bytes.data() + at, &value, sizeof value);
  return bytes;
}

TEST(LinkDescribed, AWorkspaceBeyondItsRangeIsRefused) {
  const Packet good = vectorBytes("robot_hello");
  ASSERT_TRUE(decodeRobotHello(good).ok());
  // Behind time and rates: minimum, maximum, precision.
  for (const std::size_t at : {10U, 14U, 18U, 22U, 26U, 30U}) {
    for (const float value : {2e5F, -2e5F, kNoFloat}) {
      EXPECT_EQ(decodeRobotHello(withNumber(good, at, value)).refusal, LinkRefusal::field) << at << ' ' << value;
    }
  }
  for (const float value : {2e5F, -0.02F, kNoFloat}) {
    EXPECT_EQ(decodeRobotHello(withNumber(good, 34, value)).refusal, LinkRefusal::field) << value;
  }
}

TEST(LinkDescribed, ATouchpadWithAnUnknownCapabilityOrGainIsRefused) {
  const Packet good = vectorBytes("touchpad_hello");
  ASSERT_TRUE(decodeTouchpadHello(good).ok());
  Packet unknown = good;
  unknown[49] |= 16U;  // behind status, three times, rates and workspace
  EXPECT_EQ(decodeTouchpadHello(unknown).refusal, LinkRefusal::field);
  for (const float gain : {101.0F, -1.0F, kNoFloat}) {
    EXPECT_EQ(decodeTouchpadHello(withNumber(good, 53, gain)).refusal, LinkRefusal::field) << gain;
  }
}

TEST(LinkDescribed, AStateIsRefusedForItsStiffnessThoughItsMotorReferencesAreGood) {
  const PositionCode code = *PositionCode::make(asOnTheWire(RobotHello{}.workspace));
  Packet good = vectorBytes("state");
  good[0] |= 1U << 5U;  // with motor references, before the count of accelerations
  const Packet references{0, 0, 0x80, 0x3F, 0, 0, 0, 0x40};
  good.insert(good.begin() + 21, references.begin(), references.end());
  const auto taken = decodeState(decodeEnvelope(good).value, code);
  ASSERT_TRUE(taken.ok());
  EXPECT_EQ(taken.value.motor_reference->first_ticks, 1.0);
  EXPECT_EQ(taken.value.motor_reference->second_ticks, 2.0);
  const Packet bad = withNumber(good, 9, -1.0F);
  EXPECT_EQ(decodeState(decodeEnvelope(bad).value, code).refusal, LinkRefusal::field);
}

TEST(LinkDescribed, AMessageIsWrittenWholeOrNotAtAll) {
  const Packet whole = vectorBytes("heartbeat");
  Packet out(whole.size());
  const auto write = [&](std::size_t room) {
    return encodeLink(LinkHeartbeat{.echo_us = 5'000'000, .held_us = 1'234}, 1'009'744, std::span(out).first(room));
  };
  for (std::size_t room = 0; room < whole.size(); ++room) EXPECT_EQ(write(room), 0U) << room;
  EXPECT_EQ(write(whole.size()), whole.size());
}

TEST(LinkDescribed, ACookieIsOfOneFamilyOfAddresses) {
  const CookieJar jar(seededRandom);
  Endpoint from = *parseEndpoint("[::1]:4490");
  const Cookie cookie = jar.make(from, 0);
  EXPECT_TRUE(jar.good(cookie, from, 0));
  from.v6 = false;
  EXPECT_FALSE(jar.good(cookie, from, 0));
}

TEST(LinkDescribed, PairingWordsMayStandInAColumnOfATableAndADigitIsNoLetter) {
  std::string words = vectors().at("words");
  std::ranges::replace(words, ' ', '\t');
  const auto key = LinkKey::parseWords(words);
  ASSERT_TRUE(key) << key.error().text();
  EXPECT_EQ(key->fingerprint(), vectors().at("fingerprint"));
  words[1] = '4';
  EXPECT_FALSE(LinkKey::parseWords(words));
}

TEST(LinkDescribed, ARobotsCommandsWaitInAQueueOfSixteen) {
  LinkRobotEnd robot({}, testKey(), linkAddress(100), seededRandom);
  for (int i = 0; i < 16; ++i) EXPECT_TRUE(robot.command(pipeline::RobotCommand::resume)) << i;
  EXPECT_FALSE(robot.command(pipeline::RobotCommand::resume));
  EXPECT_TRUE(robot.command(pipeline::RobotCommand::none)) << "nothing to wait for";
}

}  // namespace
}  // namespace fyd::protocol
