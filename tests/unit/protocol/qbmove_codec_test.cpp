// The motor board's frames against those recorded from its maker's own program.
#include "core/protocol/qbmove_codec.h"

#include <random>

#include <gtest/gtest.h>

namespace fyd::protocol {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytesOf(const QbmoveFrame& frame) {
  const QbmoveBytes out = encode(frame);
  return {out.begin(), out.end()};
}

std::vector<QbmoveFrame> parse(const Bytes& bytes, QbmoveParser& parser) {
  std::vector<QbmoveFrame> out;
  for (const std::uint8_t byte : bytes) {
    if (const auto frame = parser.push(byte)) out.push_back(*frame);
  }
  return out;
}

const Bytes kMeasurements = {0x3a, 0x3a, 0x01, 0x08, 0x84, 0x00, 0x64, 0xff, 0x38, 0x01, 0x2c, 0x0a};

TEST(QbmoveCodec, WritesTheMakersFrames) {
  EXPECT_EQ(bytesOf(qbmoveFrame(qbmove::kPing)), (Bytes{0x3a, 0x3a, 0x01, 0x02, 0x00, 0x00}));
  const std::array<std::int16_t, 2> inputs = {1234, -1234};
  EXPECT_EQ(bytesOf(qbmoveFrame(qbmove::kSetInputs, inputs)),
            (Bytes{0x3a, 0x3a, 0x01, 0x06, 0x82, 0x04, 0xd2, 0xfb, 0x2e, 0x81}));
  EXPECT_EQ(bytesOf(qbmoveFrame(qbmove::kGetMeasurements)), (Bytes{0x3a, 0x3a, 0x01, 0x02, 0x84, 0x84}));
  EXPECT_EQ(bytesOf(qbmoveFrame(qbmove::kGetCurrents)), (Bytes{0x3a, 0x3a, 0x01, 0x02, 0x85, 0x85}));
  const std::array<std::int16_t, 2> currents = {11, -22};
  EXPECT_EQ(bytesOf(qbmoveFrame(qbmove::kGetCurrents, currents)),
            (Bytes{0x3a, 0x3a, 0x01, 0x06, 0x85, 0x00, 0x0b, 0xff, 0xea, 0x9b}));
}

TEST(QbmoveCodec, ReadsTheMakersReply) {
  QbmoveParser parser;
  const auto frames = parse(kMeasurements, parser);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0].command, qbmove::kGetMeasurements);
  EXPECT_EQ(frames[0].at(0), 100);
  EXPECT_EQ(frames[0].at(1), -200);
  EXPECT_EQ(frames[0].at(2), 300);
  EXPECT_EQ(frames[0].at(3), std::nullopt);
}

TEST(QbmoveCodec, FindsAFrameAmongNoise) {
  Bytes noisy = {0x00, 0x3a, 0x3a, 0x3a, 0x01, 0xff, 0x3a};  // a false start with an impossible length
  noisy.insert(noisy.end(), kMeasurements.begin(), kMeasurements.end());
  QbmoveParser parser;
  EXPECT_EQ(parse(noisy, parser).size(), 1U);
  EXPECT_GT(parser.skipped(), 0U);
}

TEST(QbmoveCodec, AWrongCheckIsSkippedAndTheNextFrameFound) {
  for (std::size_t broken = 4; broken < kMeasurements.size(); ++broken) {
    Bytes bytes = kMeasurements;
    bytes[broken] ^= 0x10;
    bytes.insert(bytes.end(), kMeasurements.begin(), kMeasurements.end());
    QbmoveParser parser;
    EXPECT_EQ(parse(bytes, parser).size(), 1U) << broken;
  }
}

TEST(QbmoveCodec, RandomBytesNeverHideAFrameForLongerThanOneCouldLast) {
  std::mt19937 random(1);
  for (int round = 0; round < 300; ++round) {
    Bytes bytes(random() % 300);
    for (std::uint8_t& byte : bytes) byte = random() % 3 == 0 ? 0x3a : static_cast<std::uint8_t>(random());
    for (int i = 0; i < 7; ++i) bytes.insert(bytes.end(), kMeasurements.begin(), kMeasurements.end());
    QbmoveParser parser;
    EXPECT_GE(parse(bytes, parser).size(), 1U);
  }
}

TEST(QbmoveCodec, AFrameTakesNoMoreThanItCanHold) {
  QbmoveFrame frame;
  std::size_t taken = 0;
  while (frame.add(static_cast<std::int16_t>(taken)) && taken < 1'000) ++taken;
  EXPECT_EQ(2 * taken + frame.payload.size() % 2, frame.payload.size());
  EXPECT_LT(QbmovePayload::capacity() - frame.payload.size(), 2U);
  EXPECT_FALSE(frame.add(1));
  EXPECT_EQ(frame.at(taken - 1), static_cast<std::int16_t>(taken - 1));
  EXPECT_FALSE(frame.at(taken));
  const QbmoveFrame one = qbmoveByteFrame(128, 3);
  ASSERT_EQ(one.payload.size(), 1U);
  EXPECT_EQ(one.payload[0], 3);
}

}  // namespace
}  // namespace fyd::protocol
