// Couplings of two devices: passivity, peers that send wrong values, the surface estimator.
#include "core/teleop/coupling/coupling.h"
#include "core/teleop/coupling/coupling_choice.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/teleop/coupling/model_coupling.h"
#include "core/teleop/coupling/spring_coupling.h"
#include "core/teleop/coupling/surface_estimator.h"
#include "tests/not_a_number.h"

namespace fyd::teleop {
namespace {

constexpr double kStep_s = 0.001;

CouplingMessage wallAt(double date_s, double surface_m, double stiffness_N_per_m) {
  return {.date_s = date_s,
          .position_m = surface_m,
          .energy_J = 0.0,
          .touching = true,
          .knows_surface = true,
          .surface_m = surface_m,
          .stiffness_N_per_m = stiffness_N_per_m};
}

/// A hand led along a path, its energy kept by the test itself.
struct Led {
  ModelHandEnd end{CouplingSettings{}};
  double t = 0.0, x = 0.0, energy_J = 0.0, least_J = 0.0, force_N = 0.0;

  void moveTo(double to_m, double seconds) {
    const int steps = static_cast<int>(std::lround(seconds / kStep_s));
    const double v = (to_m - x) / seconds;
    for (int i = 0; i < steps; ++i) {
      force_N = end.step({.time_s = t, .position_m = x, .velocity_m_per_s = v});
      energy_J += force_N * v * kStep_s;
      least_J = std::min(least_J, energy_J);
      x += v * kStep_s;
      t += kStep_s;
    }
  }
  void rest(double seconds) { moveTo(x, seconds); }
};

TEST(Coupling, NamesAreKnownAndOthersRefused) {
  EXPECT_EQ(couplingNamed("model").value(), CouplingChoice::model);
  EXPECT_THAT(couplingNamed("rope").error().text(),
              testing::AllOf(testing::HasSubstr("rope"), testing::HasSubstr("tdpa")));
}

TEST(ModelCoupling, ASurfaceAppearsNoHigherThanTheHandAndRisesOnlyAsItWithdraws) {
  Led hand;
  hand.moveTo(0.030, 0.5);
  hand.end.receive(wallAt(0.3, 0.010, 2000.0));  // the hand is 20 mm inside already
  hand.rest(0.2);
  EXPECT_NEAR(hand.force_N, 0.0, 1e-9);
  hand.moveTo(0.032, 0.1);
  hand.rest(0.1);
  EXPECT_NEAR(hand.force_N, 4.0, 0.1);  // 2 mm on the surface that appeared at the hand
  hand.moveTo(0.005, 0.5);
  EXPECT_NEAR(hand.force_N, 0.0, 1e-9);
  hand.moveTo(0.012, 0.3);
  hand.rest(0.1);
  EXPECT_NEAR(hand.force_N, 4.0, 0.1);  // now it is where it is
  EXPECT_GE(hand.least_J, -1e-3);
}

TEST(ModelCoupling, StiffensOnlyOutOfContactAndSoftensAtAnyTime) {
  Led hand;
  hand.end.receive(wallAt(0.1, 0.010, 500.0));
  hand.moveTo(0.014, 0.5);
  hand.rest(0.1);
  EXPECT_NEAR(hand.force_N, 2.0, 0.05);
  hand.end.receive(wallAt(0.2, 0.010, 4000.0));
  hand.rest(0.3);
  EXPECT_NEAR(hand.force_N, 2.0, 0.05);
  hand.end.receive(wallAt(0.3, 0.010, 250.0));
  hand.rest(0.8);
  EXPECT_NEAR(hand.force_N, 1.0, 0.05);
  hand.end.receive(wallAt(0.4, 0.010, 4000.0));
  hand.moveTo(0.005, 0.3);
  hand.moveTo(0.011, 0.3);
  hand.rest(0.1);
  EXPECT_NEAR(hand.force_N, 4.0, 0.2);
  EXPECT_GE(hand.least_J, -1e-3);
}

TEST(ModelCoupling, AWallThatVanishesOrMovesAwayLetsGo) {
  Led hand;
  hand.end.receive(wallAt(0.1, 0.010, 1000.0));
  hand.moveTo(0.015, 0.5);
  EXPECT_GT(hand.force_N, 4.0);
  hand.end.receive(wallAt(0.2, 0.013, 1000.0));
  hand.rest(0.3);
  EXPECT_NEAR(hand.force_N, 2.0, 0.1);
  hand.end.receive({.date_s = 0.3, .position_m = 0.015});
  hand.rest(0.3);
  EXPECT_EQ(hand.force_N, 0.0);
  EXPECT_GE(hand.least_J, -1e-3);
}

TEST(ModelCoupling, WhateverAPeerClaimsTheHandGetsNoEnergy) {
  // Surfaces that jump under a hand that goes in and out, with every stiffness, and lies in between.
  Led hand;
  unsigned state = 1;
  const auto any = [&] {
    state = state * 1664525U + 1013904223U;
    return static_cast<double>(state >> 8) / static_cast<double>(1U << 24);
  };
  for (int i = 0; i < 2000; ++i) {
    CouplingMessage message = wallAt(i, 0.03 * any(), 20.0 + 19'000.0 * any());
    if (i % 7 == 0) message.surface_m = kNaN;
    if (i % 11 == 0) message.stiffness_N_per_m = -500.0;
    if (i % 13 == 0) message.stiffness_N_per_m = 1e300;
    if (i % 5 == 0) message.knows_surface = false;
    hand.end.receive(message);
    hand.moveTo(0.03 * any(), 0.02 + 0.1 * any());
    ASSERT_TRUE(std::isfinite(hand.force_N));
    ASSERT_LE(std::abs(hand.force_N), CouplingSettings{}.most_force_N);
  }
  EXPECT_GE(hand.least_J, -1e-3);
  EXPECT_NEAR(hand.end.telemetry().energy_J, hand.energy_J, 1e-6 + 0.01 * hand.energy_J);
}

TEST(SpringCoupling, APeerThatLiesAboutItsEnergyIsBelievedOnlyWhatAHandCanDo) {
  // The far end claims a gigawatt and pulls the hand with 150 W for three seconds.
  SpringEnd end(SpringEnd::Side::hand, true, {});
  double x = 0.0, energy_J = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const double t = i * kStep_s;
    end.receive({.date_s = t, .position_m = x - 0.015, .energy_J = i % 10 == 5 ? kNaN : 1e9 * t});
    energy_J += end.step({.time_s = t, .position_m = x, .velocity_m_per_s = -10.0}) * -10.0 * kStep_s;
    x += -10.0 * kStep_s;
  }
  EXPECT_GE(energy_J, -SpringEnd::kMostPower_W * 3.0 - 0.2);  // and a step's
  EXPECT_LE(energy_J, -0.8 * SpringEnd::kMostPower_W * 3.0);
  x = 0.0;
  constexpr double v = -0.1;
  // And one that claims nothing gives nothing.
  SpringEnd honest(SpringEnd::Side::hand, true, {});
  energy_J = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const double t = i * kStep_s;
    if (i % 10 == 0) honest.receive({.date_s = t, .position_m = x - 0.015, .energy_J = 0.0});
    energy_J += honest.step({.time_s = t, .position_m = x, .velocity_m_per_s = v}) * v * kStep_s;
    x += v * kStep_s;
  }
  EXPECT_GE(energy_J, -1e-3);
}

// Only what is put in from there on may come out.
TEST(SpringCoupling, AnAccountThatTheOtherEndBeginsAnewGoesOnHere) {
  for (const bool here : {false, true}) {  // which end linked anew: this one, which is told of much, or the other
    SpringEnd end(SpringEnd::Side::far, true, {});
    double t = 0.0, x = 0.0, told_J = here ? 5.0 : 0.0;
    const auto pull = [&](double seconds, double power_W) {  // energy given to the device
      double given_J = 0.0;
      for (int i = 0; i < static_cast<int>(std::lround(seconds / kStep_s)); ++i, t += kStep_s) {
        told_J += power_W * kStep_s;
        end.receive({.date_s = t, .position_m = x + 0.010, .energy_J = told_J});
        const double force_N = end.step({.time_s = t, .position_m = x, .velocity_m_per_s = 0.1});
        given_J += (force_N + CouplingSettings{}.damping_N_s_per_m * 0.1) * 0.1 * kStep_s;
        x += 0.1 * kStep_s;
      }
      return given_J;
    };
    EXPECT_NEAR(pull(2.0, 0.5), 1.0, 0.01) << here;  // it would give 2 J
    told_J = 0.0;
    EXPECT_NEAR(pull(2.0, 0.5), 1.0, 0.01) << here;
  }
}

// No force is exerted while nothing is measured, so none works, however far the device is when it measures again.
TEST(Coupling, AMeasurementThatFailsForAWhileCostsNoEnergy) {
  for (const CouplingChoice choice : {CouplingChoice::spring, CouplingChoice::tdpa, CouplingChoice::model}) {
    for (const double moved_m : {0.05, -0.05}) {
      const auto end = makeHandEnd(choice, {});
      double t = 0.0, force_N = 0.0;
      const auto step = [&](double at_m) {
        end->receive(wallAt(t, 0.010, 1000.0));
        force_N = end->step({.time_s = t, .position_m = at_m, .velocity_m_per_s = 0.0});
        t += kStep_s;
      };
      for (int i = 0; i < 1000; ++i) step(1.5e-5 * i);
      for (int i = 0; i < 100; ++i) step(0.015);
      ASSERT_GT(force_N, 3.0);
      const double before_J = end->telemetry().energy_J;
      for (int i = 0; i < 100; ++i) {
        step(kNaN);
        ASSERT_EQ(force_N, 0.0);
      }
      step(0.015 + moved_m);
      EXPECT_EQ(end->telemetry().energy_J, before_J) << kCouplingNames[static_cast<std::size_t>(choice)];
    }
  }
}

TEST(Coupling, NothingMakesAForceThatIsNotFinite) {
  for (const CouplingChoice choice : {CouplingChoice::spring, CouplingChoice::tdpa, CouplingChoice::model}) {
    for (const bool far : {false, true}) {
      const auto end = far ? makeFarEnd(choice, {}) : makeHandEnd(choice, {});
      const std::array<double, 7> hostile = {kNaN, 1.0 / 0.0, -1.0 / 0.0, 1e300, -1e300, 0.0, 0.01};
      unsigned state = 3;
      const auto any = [&] {
        state = state * 1664525U + 1013904223U;
        return hostile[(state >> 16) % hostile.size()];
      };
      for (int i = 0; i < 5000; ++i) {
        end->receive({.date_s = any(),
                      .position_m = any(),
                      .energy_J = any(),
                      .touching = true,
                      .knows_surface = i % 2 == 0,
                      .surface_m = any(),
                      .stiffness_N_per_m = any()});
        const double force =
            end->step({.time_s = any(), .position_m = any(), .velocity_m_per_s = any(), .measured_N = any()});
        ASSERT_TRUE(std::isfinite(force)) << i;
        ASSERT_LE(std::abs(force), 20.0) << i;
      }
    }
  }
}

TEST(SurfaceEstimator, FindsStiffnessAndPlaceOfAPressWithNoise) {
  for (const double stiffness : {50.0, 500.0, 5000.0}) {
    SurfaceEstimator estimator;
    unsigned state = 5;
    const auto noise = [&] {
      state = state * 1664525U + 1013904223U;
      return static_cast<double>(state >> 8) / static_cast<double>(1U << 24) - 0.5;
    };
    const double deep = std::min(0.02, 8.0 / stiffness);
    for (int i = 0; i < 3000; ++i) {
      const double part = std::min(1.0, i / 1500.0), v = i < 1500 ? (deep + 0.005) / 1.5 : 0.0;
      const double x = 0.095 + (deep + 0.005) * part;
      estimator.step(x + 1e-5 * noise(), v, (x > 0.1 ? stiffness * (x - 0.1) + 2.0 * v : 0.0) + 0.05 * noise());
    }
    ASSERT_TRUE(estimator.known()) << stiffness;
    EXPECT_NEAR(estimator.stiffness_N_per_m(), stiffness, 0.05 * stiffness);
    EXPECT_NEAR(estimator.surface_m(), 0.1, 0.04 * deep) << stiffness;
  }
}

TEST(SurfaceEstimator, InTheAirThereIsNoSurfaceAndOneThatIsGoneIsForgotten) {
  SurfaceEstimator estimator;
  for (int i = 0; i < 2000; ++i) estimator.step(1e-5 * i, 0.01, 0.0);
  EXPECT_FALSE(estimator.known());
  for (int i = 0; i < 1000; ++i) estimator.step(0.02 + 1e-5 * i, 0.01, 500.0 * 1e-5 * i);
  EXPECT_TRUE(estimator.known());
  for (int i = 0; i < 200; ++i) estimator.step(0.03, 0.0, 0.0);  // where it was pressed, nothing is felt
  EXPECT_FALSE(estimator.known());
}

TEST(OverspeedForce, RisesSteeplyBeyondTheLimitAgainstTheMotion) {
  EXPECT_EQ(overspeedForce(0.2, 0.2), 0.0);
  EXPECT_NEAR(overspeedForce(0.22, 0.2), -1.0, 1e-9);
  EXPECT_NEAR(overspeedForce(-0.24, 0.2), 4.0, 1e-9);
  EXPECT_EQ(overspeedForce(kNaN, 0.2), 0.0);
  EXPECT_EQ(overspeedForce(1.0, 0.0), 0.0);
}

}  // namespace
}  // namespace fyd::teleop
