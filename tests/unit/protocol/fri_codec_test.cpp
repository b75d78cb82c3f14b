// FRI's layout against offsets and byte patterns worked out by hand from [KUKA FRI], not by the code under test.
#include "core/protocol/fri_codec.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <vector>

#include "app/bench/parts/allocation_count.h"

namespace fyd::protocol {
namespace {

using MeasurementBytes = std::array<std::uint8_t, 916>;
using CommandBytes = std::array<std::uint8_t, 376>;

template <class Bytes>
std::uint32_t little(const Bytes& bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = count - 1; i >= 0; --i) value = value << 8 | bytes[at + static_cast<std::size_t>(i)];
  return value;
}
template <class Bytes>
float real(const Bytes& bytes, std::size_t at) {
  const std::uint32_t bits = little(bytes, at, 4);
  float value = 0;
  std::memcpy(&value, &bits, 4);
  return value;
}
template <class Bytes>
void putReal(Bytes& bytes, std::size_t at, float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, 4);
  for (std::size_t i = 0; i < 4; ++i) bytes[at + i] = static_cast<std::uint8_t>(bits >> (8 * i));
}

// Every number its own: reals count up from `first`.
template <class Array>
void count(Array& values, float& next) {
  for (auto& value : values) value = static_cast<typename Array::value_type>(next++);
}

FriMeasurement measurement() {
  FriMeasurement m;
  m.header = {.sequence = 0x1234, .reflected = 0xFEDC};
  float next = 1000;
  count(m.krl.reals, next);
  for (std::size_t i = 0; i < 16; ++i) m.krl.integers[i] = -static_cast<std::int32_t>(i) - 1;
  m.krl.booleans = 0x8001;
  m.time_s = 12.5F;
  m.state = FriState::command;
  m.quality = FriQuality::perfect;
  m.measurement_period_s = 0.001F;
  m.command_period_s = 0.002F;
  m.safety_limits = 3.0F;
  m.answer_rate = 0.5F;
  m.latency_s = 0.25F;
  m.jitter_s = 0.125F;
  m.miss_rate = 0.75F;
  m.misses = 0x01020304;
  m.power = 0x7F;
  m.control = FriControl::cartesian_impedance;
  m.error = 0x0A0B;
  m.warning = 0x0C0D;
  count(m.temperatures_C, next);  // from 1016
  next = 1;
  count(m.joints, next);
  count(m.frame, next);
  count(m.commanded_joints, next);
  count(m.joint_offsets, next);
  count(m.commanded_frame, next);
  count(m.frame_offset, next);
  count(m.torques, next);
  count(m.external_torques, next);
  count(m.force_torque, next);
  count(m.jacobian, next);
  count(m.mass, next);
  count(m.gravity, next);
  EXPECT_EQ(next, 176);  // 175 of them
  return m;
}

TEST(FriCodec, MeasurementLiesAtTheFactSheetsOffsets) {
  const MeasurementBytes b = encodeFriMeasurement(measurement());
  EXPECT_EQ(b[0], 0x34);  // little-endian
  EXPECT_EQ(b[1], 0x12);
  EXPECT_EQ(little(b, 2, 2), 0xFEDCU);
  EXPECT_EQ(little(b, 4, 2), 916U);
  EXPECT_EQ(little(b, 6, 2), 0x2006U);
  EXPECT_EQ(real(b, 8), 1000.0F);
  EXPECT_EQ(real(b, 68), 1015.0F);
  EXPECT_EQ(little(b, 72, 4), 0xFFFFFFFFU);
  EXPECT_EQ(little(b, 132, 4), 0xFFFFFFF0U);
  EXPECT_EQ(little(b, 136, 2), 0x8001U);
  EXPECT_EQ(little(b, 138, 2), 0U);
  EXPECT_EQ(real(b, 140), 12.5F);
  EXPECT_EQ(little(b, 144, 2), 2U);
  EXPECT_EQ(little(b, 146, 2), 3U);
  EXPECT_EQ(real(b, 160), 0.5F);
  EXPECT_EQ(little(b, 176, 4), 0x01020304U);
  EXPECT_EQ(little(b, 180, 2), 0x7FU);
  EXPECT_EQ(little(b, 182, 2), 2U);
  EXPECT_EQ(little(b, 184, 2), 0x0A0BU);
  EXPECT_EQ(little(b, 186, 2), 0x0C0DU);
  EXPECT_EQ(real(b, 188), 1016.0F);
  for (int i = 0; i < 175; ++i) EXPECT_EQ(real(b, 216 + 4 * static_cast<std::size_t>(i)), static_cast<float>(i + 1));
}

TEST(FriCodec, MeasurementReadsBackFromBytesMadeByHand) {
  MeasurementBytes b{};
  b[0] = 7;
  b[4] = 0x94;  // 916 = 0x394
  b[5] = 0x03;
  b[6] = 0x06;
  b[7] = 0x20;
  b[144] = 1;
  b[146] = 2;
  b[182] = 3;
  putReal(b, 244 + 4 * 11, 0.25F);  // frame, translation z
  putReal(b, 292, -1.5F);           // first commanded joint
  putReal(b, 320 + 24, 0.5F);       // last joint offset
  putReal(b, 348 + 12, 2.0F);       // commanded frame, translation x
  putReal(b, 500 + 8, -9.0F);       // Fz
  putReal(b, 912, 42.0F);           // last of gravity
  FriMeasurement m;
  ASSERT_EQ(decodeFriMeasurement(b, m), FriRefusal::none);
  EXPECT_EQ(m.header.sequence, 7);
  EXPECT_EQ(m.state, FriState::monitor);
  EXPECT_EQ(m.quality, FriQuality::good);
  EXPECT_EQ(m.control, FriControl::joint_impedance);
  EXPECT_EQ(m.frame[11], 0.25F);
  EXPECT_EQ(m.commanded_joints[0], -1.5F);
  EXPECT_EQ(m.joint_offsets[6], 0.5F);
  EXPECT_EQ(m.commanded_frame[3], 2.0F);
  EXPECT_EQ(m.force_torque[2], -9.0F);
  EXPECT_EQ(m.gravity[6], 42.0F);
  EXPECT_EQ(encodeFriMeasurement(m), b);
}

TEST(FriCodec, CommandLiesAtTheFactSheetsOffsets) {
  FriCommand c;
  c.header = {.sequence = 1, .reflected = 0x1234};
  c.flags = fri_flag::kFrame | fri_flag::kCartesianStiffness | fri_flag::kCartesianDamping;
  float next = 1;
  count(c.joints, next);
  count(c.frame, next);
  count(c.torques, next);
  count(c.force_torque, next);
  count(c.joint_stiffness, next);
  count(c.joint_damping, next);
  count(c.cartesian_stiffness, next);
  count(c.cartesian_damping, next);
  const CommandBytes b = encodeFriCommand(c);
  EXPECT_EQ(little(b, 2, 2), 0x1234U);
  EXPECT_EQ(little(b, 4, 2), 376U);
  EXPECT_EQ(little(b, 6, 2), 0x1005U);
  EXPECT_EQ(little(b, 140, 4), 0x3100U);
  for (int i = 0; i < 58; ++i) EXPECT_EQ(real(b, 144 + 4 * static_cast<std::size_t>(i)), static_cast<float>(i + 1));
  EXPECT_EQ(real(b, 172), 8.0F);   // frame behind 7 joints
  EXPECT_EQ(real(b, 328), 47.0F);  // Cartesian stiffness behind 7 + 12 + 7 + 6 + 7 + 7 reals
  EXPECT_EQ(real(b, 352), 53.0F);  // Cartesian damping
  FriCommand back;
  ASSERT_EQ(decodeFriCommand(b, back), FriRefusal::none);
  EXPECT_EQ(encodeFriCommand(back), b);
  EXPECT_EQ(back.cartesian_stiffness[5], 52.0F);
}

TEST(FriCodec, EveryOtherSizeIsRefused) {
  const MeasurementBytes b = encodeFriMeasurement(measurement());
  std::vector<std::uint8_t> longer(b.begin(), b.end());
  longer.push_back(0);
  FriMeasurement m;
  FriCommand c;
  for (std::size_t size = 0; size < b.size(); ++size) {
    EXPECT_EQ(decodeFriMeasurement(Bytes(b).first(size), m), FriRefusal::wrong_size);
  }
  EXPECT_EQ(decodeFriMeasurement(longer, m), FriRefusal::wrong_size);
  EXPECT_EQ(decodeFriCommand(b, c), FriRefusal::wrong_size);
}

TEST(FriCodec, WrongHeadIsRefusedWithItsReason) {
  FriMeasurement m;
  MeasurementBytes b = encodeFriMeasurement(measurement());
  b[4] ^= 1;
  EXPECT_EQ(decodeFriMeasurement(b, m), FriRefusal::wrong_size_field);
  b[7] ^= 1;
  EXPECT_EQ(decodeFriMeasurement(b, m), FriRefusal::wrong_id);
  for (const auto& [at, value] : {std::pair{144, 3}, {146, 4}, {182, 4}, {145, 1}, {147, 1}, {183, 1}}) {
    b = encodeFriMeasurement(measurement());
    b[static_cast<std::size_t>(at)] = static_cast<std::uint8_t>(value);
    EXPECT_EQ(decodeFriMeasurement(b, m), FriRefusal::unknown_value) << at;
  }
  FriCommand c;
  CommandBytes command = encodeFriCommand({});
  command[4] ^= 1;
  EXPECT_EQ(decodeFriCommand(command, c), FriRefusal::wrong_size_field);
  command[7] ^= 1;
  EXPECT_EQ(decodeFriCommand(command, c), FriRefusal::wrong_id);
}

TEST(FriCodec, NumbersThatAreNoneAreRefusedWhereverTheyStand) {
  FriMeasurement m;
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                          -std::numeric_limits<float>::infinity()}) {
    for (const std::size_t at :
         {8U, 68U, 140U, 148U, 152U, 156U, 160U, 164U, 168U, 172U, 188U, 216U, 503U - 3U, 912U}) {
      MeasurementBytes b = encodeFriMeasurement(measurement());
      putReal(b, at, bad);
      EXPECT_EQ(decodeFriMeasurement(b, m), FriRefusal::not_finite) << at;
    }
    FriCommand c;
    for (std::size_t at = 144; at < 376; at += 4) {
      CommandBytes b = encodeFriCommand(c);
      putReal(b, at, bad);
      EXPECT_EQ(decodeFriCommand(b, c), FriRefusal::not_finite) << at;
      c = {};
    }
  }
}

TEST(FriCodec, NothingAllocates) {
  const FriMeasurement m = measurement();
  const bench::AllocationCount counted;
  FriMeasurement back;
  FriCommand command;
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(decodeFriMeasurement(encodeFriMeasurement(m), back), FriRefusal::none);
    EXPECT_EQ(decodeFriCommand(encodeFriCommand(command), command), FriRefusal::none);
  }
  EXPECT_EQ(counted.count(), 0U);
}

TEST(FriCodec, EachStateAndReasonHasItsWord) {
  std::set<std::string_view> words;
  for (int i = 0; i < 3; ++i) words.insert(toString(static_cast<FriState>(i)));
  for (int i = 0; i < 4; ++i) words.insert(toString(static_cast<FriQuality>(i)));
  for (int i = 0; i < 4; ++i) words.insert(toString(static_cast<FriControl>(i)));
  for (std::size_t i = 0; i < kFriRefusalCount; ++i) words.insert(toString(static_cast<FriRefusal>(i)));
  EXPECT_EQ(words.size(), 3U + 4U + 4U + kFriRefusalCount) << "none twice";
  EXPECT_FALSE(words.contains("unknown"));
  EXPECT_EQ(toString(static_cast<FriState>(9)), "unknown");
  EXPECT_EQ(toString(static_cast<FriQuality>(9)), "unknown");
  EXPECT_EQ(toString(static_cast<FriControl>(9)), "unknown");
  EXPECT_EQ(toString(static_cast<FriRefusal>(9)), "unknown");
}

}  // namespace
}  // namespace fyd::protocol
