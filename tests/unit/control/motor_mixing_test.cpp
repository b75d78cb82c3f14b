// Mixing of stretch and translation into motor references, and roller angles from encoder counts.
#include "core/control/motor_mixing.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/not_a_number.h"
#include "tests/sweep.h"

namespace fyd::control {
namespace {

TEST(MotorMixing, OppositeSensesStretchEqualSensesTranslate) {
  MotorMixing mixing;
  MotorCommand command;
  mixing.mix(90, 0, command);
  EXPECT_EQ(command.reference_ticks[0], 4200);
  EXPECT_EQ(command.reference_ticks[1], -4200);
  mixing.mix(45, 9, command);  // 54·46.667 = 2520, −36·46.667 = −1680
  EXPECT_EQ(command.reference_ticks[0], 2520);
  EXPECT_EQ(command.reference_ticks[1], -1680);
}

TEST(MotorMixing, TranslationGivesWayToTheStretch) {
  MotorMixing mixing;  // 120° at most
  MotorCommand command;
  mixing.mix(90, 1e6, command);
  EXPECT_EQ(command.reference_ticks[0], 5600);   // 120°
  EXPECT_EQ(command.reference_ticks[1], -2800);  // 30 − 90
  mixing.mix(1e300, 10, command);
  EXPECT_EQ(command.reference_ticks[0], 5600);
  EXPECT_EQ(command.reference_ticks[1], -5600);
}

TEST(MotorMixing, NotANumberHoldsTheLast) {
  MotorMixing mixing;
  MotorCommand command;
  mixing.mix(30, 3, command);
  const MotorCommand before = command;
  mixing.mix(kNaN, std::numeric_limits<double>::infinity(), command);
  EXPECT_EQ(command, before);
  mixing.mix(kNaN, 0, command);
  EXPECT_EQ(command.reference_ticks[0], 1400);
}

TEST(MotorMixing, TicksSaturate) {
  EXPECT_EQ(ticksFromDegrees(1e9), 32767);
  EXPECT_EQ(ticksFromDegrees(-1e9), -32768);
  EXPECT_EQ(ticksFromDegrees(std::numeric_limits<double>::infinity()), 32767);
  EXPECT_EQ(ticksFromDegrees(kNaN), 0);
  EXPECT_EQ(ticksFromDegrees(1.0), 47);  // 46.667
}

TEST(RollerAngles, CountsToDegreesAcrossTheWrap) {
  ControlParameters parameters;
  // 1024 counts are 90°; the second motor stands at −90°: 3072 on the circle
  RollerAngles angles = rollerAngles({.encoder_counts = {1024, 3072}}, parameters);
  EXPECT_TRUE(angles.valid);
  EXPECT_NEAR(angles.stretch_deg, 90, 1e-12);
  EXPECT_NEAR(angles.translation_deg, 0, 1e-12);
  parameters.encoder_zero_first_counts = 4000;  // 4000 → 96 crosses the wrap: 192 counts, 16.875°
  angles = rollerAngles({.encoder_counts = {96, 0}}, parameters);
  EXPECT_NEAR(angles.stretch_deg, 16.875 / 2, 1e-12);
  EXPECT_NEAR(angles.translation_deg, 16.875 / 2, 1e-12);
}

TEST(RollerAngles, SignIsAProfilesMatter) {
  ControlParameters parameters;
  parameters.encoder_first_inverted = parameters.encoder_second_inverted = true;
  EXPECT_NEAR(rollerAngles({.encoder_counts = {3072, 1024}}, parameters).stretch_deg, 90, 1e-12);
}

TEST(RollerAngles, CountsBeyondTwelveBitsAreNoAngle) {
  EXPECT_FALSE(rollerAngles({.encoder_counts = {4096, 0}}, {}).valid);
  EXPECT_FALSE(rollerAngles({.encoder_counts = {0, 65535}}, {}).valid);
  EXPECT_EQ(rollerAngles({.encoder_counts = {0, 65535}}, {}).stretch_deg, 0.0);
}

TEST(RollerAngles, EveryCommandedStretchReadsBackWithinACount) {
  MotorMixing mixing;
  for (const double stretch : stepsTo(-110, 110, 0.7)) {
    MotorCommand command;
    mixing.mix(stretch, 5, command);
    MotorFeedback feedback;
    for (std::size_t i = 0; i < kMotorCount; ++i) {
      const double counts = command.reference_ticks[i] / kTicksPerDegree * kEncoderCountsPerDegree;
      feedback.encoder_counts[i] = static_cast<std::uint16_t>(static_cast<int>(std::lround(counts) + 4096) % 4096);
    }
    EXPECT_NEAR(rollerAngles(feedback, {}).stretch_deg, stretch, 0.1);
  }
}

}  // namespace
}  // namespace fyd::control
