// The simulated way to the finger against what can be worked out by hand.
#include "core/sim/touchpad/finger_vibration.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/not_a_number.h"

namespace fyd::sim {
namespace {

FingerVibrationParameters frictionless() {
  FingerVibrationParameters p;
  p.resonance_Hz_per_deg = 0.0;
  p.breakaway_percent = 0.0;
  p.second_strength = 1.0;
  p.second_friction = 1.0;
  p.position_gain = 0.0;
  p.tension_percent = 0.0;
  p.backlash_deg = 0.0;
  return p;
}

/// RMS of the finger for a sine of duty, once it has settled.
double response_g(const FingerVibrationParameters& p, double frequency_Hz, double duty_percent) {
  FingerVibration plant(p, 0.0);
  double sum = 0.0;
  int counted = 0;
  for (int n = 0; n < 4000; ++n) {
    const double duty = duty_percent * std::sin(2.0 * M_PI * frequency_Hz * n * 1e-3);
    const double finger_g = plant.step({duty, duty});
    if (n < 2000) continue;
    sum += finger_g * finger_g;
    ++counted;
  }
  return std::sqrt(sum / counted);
}

TEST(FingerVibration, AFrictionlessMotorGivesTheAccelerationOfItsTransferFunction) {
  const FingerVibrationParameters p = frictionless();
  for (const double f : {20.0, 60.0, 110.0, 180.0}) {
    const double w = 2.0 * M_PI * f;
    const double tau = p.time_constant_ms * 1e-3;
    const double roller_g = 0.9 * p.free_speed_deg_s * M_PI / 180.0 * p.roller_radius_mm * 1e-3 * w /
                            std::sqrt(1.0 + w * w * tau * tau) / 9.80665;
    const double r = f / p.resonance_Hz;
    const double cloth = std::sqrt((1.0 + std::pow(2.0 * p.damping * r, 2)) /
                                   (std::pow(1.0 - r * r, 2) + std::pow(2.0 * p.damping * r, 2)));
    const double held = std::sin(M_PI * f / 1000.0) / (M_PI * f / 1000.0);  // a duty stands for 1 ms, so does the mean
    EXPECT_NEAR(response_g(p, f, 90.0) / (roller_g * cloth * held * held / std::sqrt(2.0)), 1.0, 0.03) << f;
  }
}

TEST(FingerVibration, BelowTheBreakawayNothingMovesAndAboveItSomethingDoes) {
  FingerVibrationParameters p = frictionless();
  p.breakaway_percent = 20.0;
  EXPECT_EQ(response_g(p, 100.0, 19.9), 0.0);
  EXPECT_GT(response_g(p, 100.0, 40.0), 1e-3);
}

TEST(FingerVibration, ASlackClothLeavesThePlayOpenAndATightOneClosesIt) {
  FingerVibrationParameters p;
  std::vector<double> felt;
  for (const double tension : {0.0, 4.0}) {
    p.tension_percent = tension;
    FingerVibration plant(p, 45.0);
    double sum = 0.0;
    for (int n = 0; n < 2000; ++n) {
      const double duty = 60.0 * std::sin(2.0 * M_PI * 100.0 * n * 1e-3);
      sum += std::abs(plant.step({duty, duty}));
    }
    felt.push_back(sum / 2000.0);
  }
  EXPECT_EQ(felt[0], 0.0);
  EXPECT_GT(felt[1], 0.01);
}

TEST(FingerVibration, AtRestNothingMoves) {
  for (const double presliding : {0.0, 0.01}) {
    FingerVibrationParameters p;
    p.presliding_deg = presliding;
    FingerVibration plant(p, 45.0);
    for (int n = 0; n < 1000; ++n) ASSERT_NEAR(plant.step({0.0, 0.0}), 0.0, 1e-9);
    EXPECT_NEAR(plant.stretch_deg(), 45.0, 1e-6);
  }
}

TEST(FingerVibration, PreslidingIsASpringUntilItSlides) {
  FingerVibrationParameters p = frictionless();
  p.breakaway_percent = 20.0;
  p.presliding_deg = 0.05;
  FingerVibration plant(p, 0.0);
  for (int n = 0; n < 3000; ++n) (void)plant.step({10.0, 10.0});
  EXPECT_NEAR(plant.motor_deg()[0], 0.025, 0.003);  // half the breakaway bends it half as far
  for (int n = 0; n < 3000; ++n) (void)plant.step({0.0, 0.0});
  EXPECT_NEAR(plant.motor_deg()[0], 0.0, 0.003);
}

// A light touch raises the resonance of a cloth that is loaded by its finger without a bound.
TEST(FingerVibration, AtTheCornersOfItsResonanceALightTouchStaysFinite) {
  for (int corner = 0; corner < 64; ++corner) {
    const auto pick = [&](int bit, double low, double high) { return (corner >> bit) % 2 == 0 ? low : high; };
    FingerVibrationParameters p;
    p.resonance_Hz = pick(0, 5.0, 400.0);
    p.damping = pick(1, 0.02, 2.0);
    p.resonance_Hz_per_deg = pick(2, -5.0, 5.0);
    p.finger_loading = pick(3, 0.0, 1.0);
    p.presliding_deg = pick(4, 0.0, 0.5);
    FingerVibration plant(p, pick(5, 0.0, 90.0));
    unsigned state = 1;
    double most_g = 0.0;
    for (int n = 0; n < 500; ++n) {
      state = state * 1664525U + 1013904223U;
      const double duty = 200.0 * static_cast<double>(state >> 8) / static_cast<double>(1U << 24) - 100.0;
      const double force_N = 1e-3 * std::min(n, 50) / 50.0;
      const double finger_g = plant.step({duty, duty}, force_N);
      ASSERT_TRUE(std::isfinite(finger_g)) << corner << ", after " << n << " ms";
      most_g = std::max(most_g, std::abs(finger_g));
    }
    EXPECT_LT(most_g, 1000.0) << corner;
  }
}

TEST(FingerVibration, DutiesThatAreNoNumbersCountAsNothing) {
  FingerVibration plant({}, 45.0);
  for (int n = 0; n < 100; ++n) ASSERT_NEAR(plant.step({kNaN, -kNaN}), 0.0, 1e-9);
}

}  // namespace
}  // namespace fyd::sim
