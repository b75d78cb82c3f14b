// What the motors are told while Held, when their board goes away and comes back.
#include "core/station/motor_release.h"

#include <gtest/gtest.h>

namespace fyd::station {
namespace {

using pipeline::SafetyState;
using std::chrono::milliseconds;

TEST(MotorRelease, AShortDisturbanceKeepsTheMotorsAndALongOneGivesThemUpUntilTheNextArm) {
  MotorRelease release(milliseconds(100));
  EXPECT_FALSE(release.step(SafetyState::active, milliseconds(500))) << "rendering ends first";
  EXPECT_FALSE(release.step(SafetyState::held, milliseconds(60)));
  EXPECT_FALSE(release.step(SafetyState::held, milliseconds(4)))
      << "held for another reason, the motors keep their place";
  EXPECT_TRUE(release.step(SafetyState::held, milliseconds(101)));
  EXPECT_TRUE(release.step(SafetyState::held, milliseconds(4))) << "its return alone switches nothing on";
  EXPECT_FALSE(release.step(SafetyState::active, milliseconds(4))) << "the operator's arm does";
  EXPECT_FALSE(release.step(SafetyState::held, milliseconds(4)));
}

}  // namespace
}  // namespace fyd::station
