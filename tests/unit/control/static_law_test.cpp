// The static law from stretch to stiffness: interpolation, inverse, domain, the forms of the thesis.
#include "core/control/static_law.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/base/profile_text.h"
#include "tests/not_a_number.h"
#include "tests/sweep.h"

namespace fyd::control {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

StaticLaw lawOf(StaticLawKind kind) {
  ControlParameters parameters;
  parameters.law = kind;
  return StaticLaw(parameters);
}

TEST(StaticLaw, InterpolatedPassesThroughTheFourMeasuredPoints) {
  const StaticLaw law;
  const double angles[] = {20, 45, 60, 90}, stiffness[] = {0.501, 0.550, 0.673, 0.715};
  for (int i = 0; i < 4; ++i) {
    EXPECT_NEAR(law.stiffness_N_per_mm(angles[i]).value, stiffness[i], 1e-12);
    EXPECT_NEAR(law.angle_deg(stiffness[i]).value, angles[i], 1e-5);
    EXPECT_FALSE(law.angle_deg(stiffness[i]).clamped);
  }
}

TEST(StaticLaw, InterpolatedBetweenPointsByHand) {
  // Between 45° and 60°: tangents are the weighted harmonic means of the chords 0.049/25, 0.123/15, 0.042/30.
  // at 45°: w = 2·15 + 25 = 55 on 0.00196, 15 + 2·25 = 65 on 0.0082: 120/(55/0.00196 + 65/0.0082) = 0.003334440
  // at 60°: w = 2·30 + 15 = 75 on 0.0082, 30 + 2·15 = 60 on 0.0014: 135/(75/0.0082 + 60/0.0014) = 0.002595980
  // Halfway: (0.550 + 0.673)/2 + 15/8·(0.003334440 − 0.002595980) = 0.61288461
  const StaticLaw law;
  EXPECT_NEAR(law.stiffness_N_per_mm(52.5).value, 0.61288461, 1e-8);
  EXPECT_NEAR(law.angle_deg(0.61288461).value, 52.5, 1e-4);
}

TEST(StaticLaw, InterpolatedRisesEverywhereAndTheInverseAgrees) {
  const StaticLaw law;
  double last = 0.0;
  for (const double angle : stepsTo(20, 90, 0.25)) {
    const double k = law.stiffness_N_per_mm(angle).value;
    EXPECT_GT(k, last) << angle;
    EXPECT_NEAR(law.stiffness_N_per_mm(law.angle_deg(k).value).value, k, 1e-12) << angle;
    const double h = 1e-4;
    if (angle > 20 && angle < 90) {
      const double numeric =
          (law.stiffness_N_per_mm(angle + h).value - law.stiffness_N_per_mm(angle - h).value) / (2 * h);
      EXPECT_NEAR(law.slope_N_per_mm_deg(angle), numeric, 1e-6) << angle;
    }
    last = k;
  }
}

TEST(StaticLaw, OutsideTheDomainIsTheNearestEndWithAFlag) {
  const StaticLaw law;
  for (const double low : {0.5009, 0.3, 0.0, -1.0, -kInfinity, kNaN}) {
    EXPECT_TRUE(law.angle_deg(low).clamped) << low;
    EXPECT_EQ(law.angle_deg(low).value, 20.0) << low;
  }
  for (const double high : {0.7151, 0.9, 1e300, kInfinity}) {
    EXPECT_TRUE(law.angle_deg(high).clamped) << high;
    EXPECT_EQ(law.angle_deg(high).value, 90.0) << high;
  }
  EXPECT_TRUE(law.stiffness_N_per_mm(19.9).clamped);
  EXPECT_EQ(law.stiffness_N_per_mm(-kInfinity).value, 0.501);
  EXPECT_EQ(law.stiffness_N_per_mm(kNaN).value, 0.501);
  EXPECT_EQ(law.stiffness_N_per_mm(1e9).value, 0.715);
}

TEST(StaticLaw, ThesisQuadraticAsPrinted) {
  // 314.5·0.25 − 107·0.5 − 0.3552 = 24.7698; at 0.3: 28.305 − 32.1 − 0.3552 = −4.1502; at 0.9: 158.0898
  const StaticLaw law = lawOf(StaticLawKind::thesis);
  EXPECT_NEAR(law.angle_deg(0.5).value, 24.7698, 1e-9);
  EXPECT_NEAR(law.angle_deg(0.3).value, -4.1502, 1e-9);
  EXPECT_NEAR(law.angle_deg(0.9).value, 158.0898, 1e-9);
  EXPECT_TRUE(law.angle_deg(0.29).clamped);
  EXPECT_TRUE(law.angle_deg(0.91).clamped);
  EXPECT_NEAR(law.stiffness_N_per_mm(-4.1502).value, 0.3, 1e-9);
  EXPECT_NEAR(law.stiffness_N_per_mm(158.0898).value, 0.9, 1e-9);
  EXPECT_NEAR(law.stiffness_N_per_mm(24.7698).value, 0.5, 1e-9);
  EXPECT_NEAR(law.slope_N_per_mm_deg(24.7698), 1.0 / (629 * 0.5 - 107), 1e-12);
}

TEST(StaticLaw, ThesisQuadraticMissesItsOwnPointsAsFactsSay) {
  const StaticLaw law = lawOf(StaticLawKind::thesis);
  EXPECT_NEAR(law.angle_deg(0.501).value - 20, 5.0, 0.05);
  EXPECT_NEAR(law.angle_deg(0.550).value - 45, -9.1, 0.05);
  EXPECT_NEAR(law.angle_deg(0.673).value - 60, 10.1, 0.05);
  EXPECT_NEAR(law.angle_deg(0.715).value - 90, -6.1, 0.05);
}

TEST(StaticLaw, ThesisLinearAsInTheLaterCode) {
  const StaticLaw law = lawOf(StaticLawKind::thesis_linear);
  EXPECT_NEAR(law.angle_deg(0.5).value, 78.7, 1e-9);
  EXPECT_NEAR(law.stiffness_N_per_mm(78.7).value, 0.5, 1e-12);
}

TEST(StaticLaw, TravelNarrowsTheDomainAndWidensItAgain) {
  StaticLaw law = lawOf(StaticLawKind::thesis);
  law.limitTravel(20, 90);
  EXPECT_EQ(law.angle_deg(0.9).value, 90.0);
  EXPECT_EQ(law.angle_deg(0.3).value, 20.0);
  // k at 20°: (107 + √(107² + 4·314.5·20.3552))/629 = 0.4761509
  EXPECT_NEAR(law.minimumStiffness_N_per_mm(), 0.4761509, 1e-6);
  law.limitTravel(-30, 180);
  EXPECT_NEAR(law.angle_deg(0.9).value, 158.0898, 1e-9);
  law.limitTravel(90, 20);
  EXPECT_NEAR(law.angle_deg(0.9).value, 158.0898, 1e-9) << "an empty travel is ignored";
}

TEST(StaticLaw, ATravelBesideTheLawIsOnePointOfTheTravel) {
  struct Case {
    double from_deg, to_deg, angle_deg, law_deg;
  };
  for (const auto kind : {StaticLawKind::interpolated, StaticLawKind::thesis, StaticLawKind::thesis_linear}) {
    const StaticLaw whole = lawOf(kind);
    for (const Case& c : {Case{-180, -60, -60, whole.minimumAngle_deg()}, {170, 180, 170, whole.maximumAngle_deg()}}) {
      StaticLaw law = lawOf(kind);
      law.limitTravel(c.from_deg, c.to_deg);
      const double k = whole.stiffness_N_per_mm(c.law_deg).value;
      for (const double asked : {0.01, k, 5.0, kNaN}) EXPECT_EQ(law.angle_deg(asked).value, c.angle_deg) << asked;
      for (const double asked : {-200.0, c.angle_deg, c.law_deg, 200.0, kNaN}) {
        EXPECT_NEAR(law.stiffness_N_per_mm(asked).value, k, 1e-12) << asked;
        EXPECT_EQ(law.slope_N_per_mm_deg(asked), whole.slope_N_per_mm_deg(c.law_deg)) << asked;
      }
    }
  }
}

TEST(StaticLaw, TwoPointsAreAStraightLine) {
  StaticLaw law;
  ASSERT_TRUE(law.configure(StaticLawKind::interpolated, {{10, 30}, 2}, {{0.4, 0.8}, 2}));
  EXPECT_NEAR(law.angle_deg(0.5).value, 15, 1e-9);
}

TEST(StaticLaw, PointsThatMakeNoLawAreRefusedAndChangeNothing) {
  StaticLaw law;
  const auto refuse = [&](const ParameterList& angle, const ParameterList& stiffness) {
    EXPECT_FALSE(law.configure(StaticLawKind::interpolated, angle, stiffness));
  };
  refuse({{20}, 1}, {{0.5}, 1});
  refuse({{20, 30}, 2}, {{0.5, 0.6, 0.7}, 3});
  refuse({{20, 20}, 2}, {{0.5, 0.6}, 2});
  refuse({{20, 30}, 2}, {{0.6, 0.5}, 2});
  refuse({{20, kNaN}, 2}, {{0.5, 0.6}, 2});
  refuse({{20, 30}, 2}, {{0.0, 0.6}, 2});
  EXPECT_EQ(law.maximumAngle_deg(), 90.0);
}

TEST(ControlParameters, NamesWhatIsWrongWithTheLawsPoints) {
  const auto problem = [](std::string_view profile) {
    ControlParameters parameters;
    EXPECT_TRUE(parseProfile(profile, "p.toml", bindParameters(parameters)));
    const auto checked = checkControlParameters(parameters);
    return checked ? std::string("none") : checked.error().text();
  };
  EXPECT_EQ(problem(""), "none");
  EXPECT_THAT(problem("[control]\nlaw_angle_deg = [20, 45, 45, 90]"), testing::HasSubstr("control.law_angle_deg: 45"));
  EXPECT_THAT(problem("[control]\nlaw_angle_deg = [20, 45]"), testing::HasSubstr("4 values for 2 angles"));
  EXPECT_THAT(problem("[control]\nlaw_angle_deg = [20]"), testing::HasSubstr("at least 2"));
  EXPECT_THAT(problem("[control]\ntravel_minimum_deg = 90"), testing::HasSubstr("travel_maximum_deg = 90"));
}

TEST(ControlParameters, GainsOutsideTheirRangeAreRefusedWithNameValueAndRange) {
  for (const std::string id : {"kp", "ki", "kd", "thesis_kp", "thesis_ki", "thesis_kd"}) {
    ControlParameters parameters;
    const auto bound = bindParameters(parameters);
    EXPECT_FALSE(parseProfile("[control]\n" + id + " = -0.1\n", "p.toml", bound)) << id;
    EXPECT_TRUE(parseProfile("[control]\n" + id + " = 0\n", "p.toml", bound)) << id;
    const auto refused = parseProfile("[control]\n" + id + " = 99999\n", "p.toml", bound);
    ASSERT_FALSE(refused) << id;
    EXPECT_THAT(refused.error().text(), testing::HasSubstr("p.toml:2: control." + id + " = 99999: expected a number"));
  }
}

}  // namespace
}  // namespace fyd::control
