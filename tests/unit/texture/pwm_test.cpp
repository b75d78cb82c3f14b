// Mapping of the texture signal to motor duty: rounding, gain, limits, dead zone.
#include "core/texture/pwm.h"

#include <limits>

#include <gtest/gtest.h>

#include "tests/not_a_number.h"

namespace fyd::texture {
namespace {

constexpr PwmSettings kPlain = {.k_vib = 1.0, .full_scale_g = 2.0, .maximum_percent = 100.0, .dead_zone_percent = 25.0};

TEST(Pwm, ThesisRoundsDownwardOnBothSidesOfZero) {
  EXPECT_EQ(thesisDuty(0.8123, kPlain).percent, 40.0);    // 40.615
  EXPECT_EQ(thesisDuty(-0.8123, kPlain).percent, -41.0);  // floor pulls down
  EXPECT_EQ(thesisDuty(0.5, kPlain).percent, 25.0);       // the edge itself passes
  EXPECT_EQ(thesisDuty(0.499, kPlain).percent, 0.0);      // 24.95 → 24
  EXPECT_EQ(thesisDuty(-0.499, kPlain).percent, -25.0);   // −24.95 → −25: passes, where its mirror does not
}

TEST(Pwm, ThesisMultipliesAfterTheLimitSoThatTheProductMayExceedIt) {
  PwmSettings s = kPlain;
  s.k_vib = 1.5;
  EXPECT_EQ(thesisDuty(1.6, s).percent, 120.0);
  EXPECT_EQ(thesisDuty(5.0, s).percent, 150.0);
  s.k_vib = 0.1;
  EXPECT_DOUBLE_EQ(thesisDuty(0.6, s).percent, 3.0);  // inside the dead zone after all
}

TEST(Pwm, SymmetricIsOddAndAppliesTheGainBeforeTheLimit) {
  for (const double s : {0.1, 0.49, 0.51, 0.8123, 1.234, 1.999, 7.0}) {
    EXPECT_EQ(symmetricDuty(s, kPlain).percent, -symmetricDuty(-s, kPlain).percent) << s;
  }
  EXPECT_EQ(symmetricDuty(0.8123, kPlain).percent, 41.0);
  PwmSettings s = kPlain;
  s.k_vib = 1.5;
  EXPECT_EQ(symmetricDuty(1.2, s).percent, 90.0);
  EXPECT_FALSE(symmetricDuty(1.2, s).clipped);
  EXPECT_EQ(symmetricDuty(1.6, s).percent, 100.0);
  EXPECT_TRUE(symmetricDuty(1.6, s).clipped);
  s.k_vib = 0.1;
  EXPECT_EQ(symmetricDuty(0.6, s).percent, 0.0);
  s = kPlain;
  s.maximum_percent = 60.0;
  EXPECT_EQ(symmetricDuty(-9.0, s).percent, -60.0);
}

TEST(Pwm, NothingThatIsNoNumberReachesTheMotors) {
  for (const double bad : {kNaN, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(symmetricDuty(bad, kPlain).percent, 0.0);
    EXPECT_EQ(thesisDuty(bad, kPlain).percent, 0.0);
    EXPECT_EQ(limitDuty({bad, false}, 100.0, 0.0).percent, 0.0);
  }
}

TEST(Pwm, ThePositionLoopsShareIsLeftToIt) {
  EXPECT_EQ(limitDuty({80.0, false}, 100.0, 30.0).percent, 70.0);    // the sum is 100
  EXPECT_EQ(limitDuty({-80.0, false}, 100.0, 30.0).percent, -80.0);  // the sum is −50
  EXPECT_EQ(limitDuty({-80.0, false}, 100.0, -45.0).percent, -55.0);
  EXPECT_TRUE(limitDuty({80.0, false}, 100.0, 30.0).clipped);
  EXPECT_FALSE(limitDuty({70.0, false}, 100.0, 30.0).clipped);
  EXPECT_EQ(limitDuty({80.0, false}, 100.0, kNaN).percent, 80.0);
  EXPECT_EQ(limitDuty({120.0, false}, 100.0, kNaN).percent, 100.0);
  EXPECT_EQ(limitDuty({50.0, false}, 100.0, 1e9).percent, 0.0);
}

}  // namespace
}  // namespace fyd::texture
