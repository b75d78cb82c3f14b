// Implausible FRI values are refused with name, value and bound; those of normal operation are accepted.
#include "core/device/robot/fri_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/device/robot/fri_tick.h"

namespace fyd::device {
namespace {

using protocol::FriMeasurement;
using ::testing::HasSubstr;

FriMeasurement sound() {
  FriMeasurement m;
  m.joints = {0.0F, 0.52F, 0.0F, -1.57F, 0.0F, 1.05F, 0.0F};
  m.commanded_joints = m.joints;
  m.joint_offsets = {0.01F, 0.0F, 0.0F, -0.01F, 0.0F, 0.0F, 0.02F};
  m.frame = {1, 0, 0, 0.5F, 0, -1, 0, 0.1F, 0, 0, -1, 0.3F};
  m.commanded_frame = m.frame;
  m.force_torque = {1.0F, -2.0F, 6.0F, 0.1F, 0.2F, -0.3F};
  m.krl.reals[2] = 1.0F;
  return m;
}

std::string verdict(const std::function<void(FriMeasurement&)>& spoil) {
  FriMeasurement m = sound();
  spoil(m);
  const auto good = checkMeasurement(m);
  return good ? "possible" : good.error().text();
}

TEST(FriCheck, EachImpossibleQuantityIsNamedWithItsValueAndBound) {
  EXPECT_EQ(verdict([](auto&) {}), "possible");
  EXPECT_EQ(verdict([](auto& m) { m.joints[3] = 1e30F; }),
            "KRC: measured joint 4 is 1e+30 rad; expected within ±6.28319 rad");
  EXPECT_THAT(verdict([](auto& m) { m.commanded_joints[0] = -7.0F; }), HasSubstr("commanded joint 1 is -7 rad"));
  EXPECT_THAT(verdict([](auto& m) { m.joint_offsets[6] = 6.5F; }), HasSubstr("commanded joint plus its offset 7"));
  EXPECT_THAT(verdict([](auto& m) { m.frame = {}; }), HasSubstr("rotation of the measured frame is off by 1"));
  EXPECT_THAT(verdict([](auto& m) { m.commanded_frame = {}; }), HasSubstr("rotation of the commanded frame"));
  EXPECT_THAT(verdict([](auto& m) { m.frame.fill(1e30F); }), HasSubstr("rotation of the measured frame"));
  EXPECT_THAT(verdict([](auto& m) { m.frame[0] = 1.02F; }), HasSubstr("rows of length 1 at right angles"));
  EXPECT_THAT(verdict([](auto& m) { m.frame[1] = 0.02F; }), HasSubstr("rows of length 1 at right angles"));
  EXPECT_THAT(verdict([](auto& m) { m.frame[10] = 1.0F; }), HasSubstr("measured frame is a mirror"));
  EXPECT_EQ(verdict([](auto& m) { m.commanded_frame[3] = 1e30F; }),
            "KRC: the commanded frame is at (1e+30, 0.1, 0.3) m; expected within 3 m of the base");
  EXPECT_THAT(verdict([](auto& m) { m.frame_offset[7] = 1e30F; }),
              HasSubstr("offset of the commanded frame is at (0, 1e+30, 0) m"));
  EXPECT_THAT(verdict([](auto& m) { m.frame[11] = 0.7F; }), HasSubstr("are 0.4 m apart; expected at most 0.3 m"));
  EXPECT_THAT(verdict([](auto& m) { m.force_torque[2] = 1e30F; }), HasSubstr("tool force 3 is 1e+30 N"));
  EXPECT_THAT(verdict([](auto& m) { m.force_torque[4] = -600.0F; }), HasSubstr("tool torque 2 is -600 Nm"));
  EXPECT_THAT(verdict([](auto& m) { m.krl.reals[1] = 500.0F; }), HasSubstr("KRL real 2 is 500 g (acceleration)"));
}

// A frame of floats turned about an axis that is none of the base's: what the rounding leaves is no skew.
TEST(FriCheck, AnyRotationAndWhatIsNotUsedPasses) {
  for (int i = 0; i < 628; ++i) {
    const double a = 0.01 * i;
    const auto c = static_cast<float>(std::cos(a));
    const auto s = static_cast<float>(std::sin(a));
    EXPECT_EQ(verdict([&](auto& m) {
                m.frame = {c, -s, 0, 0.5F, s * 0.6F, c * 0.6F, -0.8F, 0.1F, s * 0.8F, c * 0.8F, 0.6F, 0.3F};
                m.commanded_frame = m.frame;
                m.jacobian.fill(1e30F);
                m.mass.fill(1e30F);
                m.krl.reals[3] = 1e30F;
              }),
              "possible");
  }
}

TEST(FriCheck, AToolThatLeapsIsNamed) {
  FriMeasurement before = sound();
  FriMeasurement now = sound();
  now.frame[3] += 0.29F;
  EXPECT_TRUE(checkStep(before, now, 1));
  now.frame[3] += 0.2F;
  EXPECT_FALSE(checkStep(before, now, 1));
  EXPECT_TRUE(checkStep(before, now, 2));
  now.frame[3] = 1.5F;
  EXPECT_EQ(checkStep(before, now, 2).error().text(),
            "KRC: the measured frame moved 1 m in 2 cycles; expected at most 0.6 m");
}

// Ticks by hand: the shorter of what is stated and what the stamps say.
TEST(FriTick, IsTheShorterOfWhatIsStatedAndStamped) {
  const auto after = [](float stated, double stamped_s, double from_s, int count) {
    FriTick tick;
    FriMeasurement m;
    m.measurement_period_s = m.command_period_s = stated;
    for (int i = 0; i < count; ++i) {
      m.header.sequence = static_cast<std::uint16_t>(65'500 + i);
      m.time_s = static_cast<float>(from_s + stamped_s * i);
      tick.take(m);
    }
    return tick.seconds();
  };
  EXPECT_EQ(FriTick().seconds(), 0.001);
  EXPECT_NEAR(after(0.005F, 0.0, 0.0, 1), 0.005, 1e-9);
  EXPECT_NEAR(after(0.005F, 0.005, 10.0, 200), 0.005, 1e-6);
  EXPECT_NEAR(after(0.01F, 0.002, 10.0, 200), 0.002, 1e-6);
  EXPECT_NEAR(after(0.01F, 0.002, 10.0, 2), 0.002, 1e-5);  // known from the second measurement on
  EXPECT_NEAR(after(0.005F, 0.01, 10.0, 200), 0.005, 1e-6);
  EXPECT_NEAR(after(0.0F, 0.005, 10.0, 200), 0.005, 1e-6);
  EXPECT_EQ(after(0.0F, 0.0, 0.0, 200), 0.001);
  EXPECT_NEAR(after(0.005F, -1.0, 0.0, 200), 0.005, 1e-9);
  EXPECT_NEAR(after(1e30F, 1e20, 0.0, 200), 0.001, 1e-9);
  EXPECT_NEAR(after(-1.0F, 0.005, 0.0, 200), 0.005, 1e-6);
  EXPECT_EQ(after(1e-9F, 1e-9, 0.0, 200), 0.001);
  // After a day the stamps resolve 8 ms only: never longer than what is stated, and not wildly shorter.
  const double day = after(0.005F, 0.005, 86'400.0, 200);
  EXPECT_LE(day, 0.005 + 1e-9);
  EXPECT_GE(day, 0.0045);
}

}  // namespace
}  // namespace fyd::device
