// What two linked devices tell each other: values beyond a field's range, and datagrams that are no such message.
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/protocol/link/device_message.h"
#include "tests/not_a_number.h"

namespace fyd::protocol {
namespace {

using DeviceBytes = std::vector<std::uint8_t>;

constexpr std::size_t kPositionAt = 11;   // behind mark, flags, session and date
constexpr std::size_t kEarlierSize = 20;  // age, position, velocity, force

PositionCode deviceCode() {
  return *PositionCode::make(
      {.minimum_mm = {-50, -50, -50}, .maximum_mm = {50, 50, 50}, .precision_mm = 0.02});  // 13 bits an axis
}

DeviceBytes told(const DeviceMessage& message) {
  DeviceBytes out(kMostDeviceMessage);
  out.resize(encode(message, deviceCode(), out));
  return out;
}

std::optional<DeviceMessage> heard(const DeviceBytes& bytes) { return decodeDeviceMessage(bytes, deviceCode()); }

DeviceMessage numbered(std::uint32_t number, std::size_t earlier) {
  DeviceMessage out{.date_s = 10.0, .position_mm = {1, 2, 3}, .number = number, .velocity_mm_per_s = {4, 5, 6}};
  for (std::size_t i = 0; i < earlier; ++i) {
    const double age = 0.001 * static_cast<double>(earlier - i);
    EXPECT_TRUE(out.earlier.push({.date_s = out.date_s - age, .position_mm = {7, 8, 9}, .force_N = {0.5, 0, -0.5}}));
  }
  return out;
}

TEST(DeviceMessage, ArrivesWithTheTwoBeforeItAndTheSurfacesThatAreKnown) {
  DeviceMessage sent = numbered(3, 2);
  sent.axes[1] = {.touching = true, .knows_surface = true, .surface_m = 0.25, .stiffness_N_per_m = 512.0};
  const auto got = heard(told(sent));
  ASSERT_TRUE(got);
  EXPECT_EQ(got->number, 3U);
  EXPECT_NEAR(got->position_mm.z, 3.0, 0.02);
  EXPECT_NEAR(got->velocity_mm_per_s.y, 5.0, 0.05);
  ASSERT_EQ(got->earlier.size(), 2U);
  EXPECT_NEAR(got->earlier[0].date_s, 9.998, 1e-6) << "the oldest first";
  EXPECT_NEAR(got->earlier[1].date_s, 9.999, 1e-6);
  EXPECT_NEAR(got->earlier[1].position_mm.x, 7.0, 0.02);
  EXPECT_NEAR(got->earlier[1].force_N.z, -0.5, 0.001);
  EXPECT_FALSE(got->axes[0].knows_surface);
  EXPECT_TRUE(got->axes[1].touching);
  EXPECT_EQ(got->axes[1].surface_m, 0.25);
  EXPECT_EQ(got->axes[1].stiffness_N_per_m, 512.0);
}

TEST(DeviceMessage, SaysWhetherItsSenderRunsAndWhichEnergiesFlowed) {
  DeviceMessage sent = numbered(0, 0);
  sent.axes[2].energy_J = 0.5;
  const DeviceBytes without = told(sent);
  EXPECT_TRUE(heard(without)->running);
  EXPECT_FALSE(heard(without)->tells_energy);
  EXPECT_EQ(heard(without)->axes[2].energy_J, 0.0) << "not sent";
  sent.running = false;
  sent.tells_energy = true;
  const DeviceBytes with = told(sent);
  EXPECT_EQ(with.size(), without.size() + 3 * sizeof(float));
  EXPECT_FALSE(heard(with)->running);
  EXPECT_TRUE(heard(with)->tells_energy);
  EXPECT_EQ(heard(with)->axes[2].energy_J, 0.5);
}

TEST(DeviceMessage, WhatIsNotFiniteIsToldAsZero) {
  DeviceMessage sent = numbered(2, 1);
  sent.force_N = {kNaN, 1.0, std::numeric_limits<double>::infinity()};
  sent.velocity_mm_per_s.x = kNaN;
  sent.earlier[0].date_s = kNaN;
  const auto got = heard(told(sent));
  ASSERT_TRUE(got);
  EXPECT_EQ(got->force_N.x, 0.0);
  EXPECT_NEAR(got->force_N.y, 1.0, 0.001) << "the others are as they were";
  EXPECT_EQ(got->force_N.z, 0.0);
  EXPECT_EQ(got->velocity_mm_per_s.x, 0.0);
  EXPECT_EQ(got->earlier[0].date_s, got->date_s) << "an age of zero";
  sent = numbered(0, 0);
  sent.date_s = kNaN;
  EXPECT_EQ(heard(told(sent))->date_s, 0.0);
}

TEST(DeviceMessage, WithAPositionOutsideTheWorkspaceIsNone) {
  const DeviceBytes good = told(numbered(0, 0));
  ASSERT_TRUE(heard(good));
  DeviceBytes bad = good;
  bad[kPositionAt] = 0xFF;  // x is the lowest 13 bits: cell 8191 of 5000
  bad[kPositionAt + 1] |= 0x1FU;
  EXPECT_FALSE(heard(bad));
  bad = told(numbered(2, 1));
  ASSERT_TRUE(heard(bad));
  bad[bad.size() - kEarlierSize + 3] = 0xFF;  // behind its age
  bad[bad.size() - kEarlierSize + 4] |= 0x1FU;
  EXPECT_FALSE(heard(bad)) << "of the message before";
}

TEST(DeviceMessage, OfAnotherLengthIsNone) {
  for (const DeviceMessage& message : {numbered(0, 0), numbered(1, 0), numbered(9, 2)}) {
    DeviceBytes bytes = told(message);
    bytes.push_back(0);
    EXPECT_FALSE(heard(bytes)) << message.number << ": a byte more";
    bytes.resize(bytes.size() - 2);
    EXPECT_FALSE(heard(bytes)) << message.number << ": a byte less";
  }
}

TEST(DeviceMessage, RepeatsNoMoreThanWereBeforeItAndTwoAtMost) {
  EXPECT_TRUE(heard(told(numbered(2, 1))));
  EXPECT_FALSE(heard(told(numbered(1, 1)))) << "before the first there was none";
  EXPECT_FALSE(heard(told(numbered(2, 2))));
  DeviceBytes three = told(numbered(9, 2));
  const DeviceBytes last(three.end() - kEarlierSize, three.end());
  three.insert(three.end(), last.begin(), last.end());
  EXPECT_FALSE(heard(three));
  DeviceBytes zero = told(numbered(1, 0));
  zero[zero.size() - 10] = 0;  // the number, before the velocity
  EXPECT_FALSE(heard(zero)) << "numbers begin at 1";
}

TEST(DeviceMessage, WithAnotherMarkIsNone) {
  DeviceBytes bytes = told(numbered(0, 0));
  bytes[0] ^= 1U;
  EXPECT_FALSE(heard(bytes));
}

}  // namespace
}  // namespace fyd::protocol
