// The probe on a soft abdomen: the force along the normal, and the damping of a hand that is too fast.
#include "core/scene/gesture/palpation.h"

#include <cmath>
#include <limits>
#include <random>
#include <type_traits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/not_a_number.h"
#include "tests/sweep.h"

namespace fyd::scene {
namespace {

static_assert(std::is_trivially_copyable_v<PalpationState>);

PalpationInputs onPlane(const PalpationParameters& parameters, const Vec3& probe) {
  return {.probe_mm = probe, .touch = touchPlane(parameters, {.normal_z = 0.5}, probe), .measured_N = {}};
}

/// At this speed across for a second, 5 mm deep.
PalpationForce moved(const PalpationParameters& parameters, double speed, double dt_s = 0.001) {
  PalpationState state;
  PalpationForce out;
  for (int i = 0; i * dt_s < 1.0; ++i) {
    out = stepPalpation(parameters, state, onPlane(parameters, {speed * dt_s * i, 3.0, -5.0}), dt_s);
  }
  return out;
}

TEST(Palpation, AlongTheNormalItIsStiffnessTimesDepth) {
  const PalpationParameters parameters;
  PalpationState state;
  for (const double z : {2.0, 0.0, -1.0, -5.0, -100.0}) {
    PalpationForce force;
    for (int i = 0; i < 2; ++i) force = stepPalpation(parameters, state, onPlane(parameters, {1.0, 2.0, z}), 0.001);
    EXPECT_EQ(force.touching, z < 0.0);
    EXPECT_NEAR(force.force_N.z, std::clamp(-0.5 * z, 0.0, 20.0), 1e-12);
    EXPECT_EQ(force.force_N.x, 0.0);
    EXPECT_EQ(force.segment.from_mm, (Vec3{1.0, 2.0, z}));
    EXPECT_EQ(force.segment.to_mm, force.segment.from_mm + 10.0 * force.force_N);
    EXPECT_DOUBLE_EQ(force.segment.value_N, force.force_N.z);
  }
}

TEST(Palpation, WhatTheRemoteSensorMeasuresTakesItsPlace) {
  const PalpationParameters parameters;
  PalpationState state;
  PalpationInputs inputs = onPlane(parameters, {0.0, 0.0, -5.0});
  for (const double measured : {3.7, 0.0, -2.0, 1e6}) {
    inputs.measured_N = measured;
    EXPECT_DOUBLE_EQ(stepPalpation(parameters, state, inputs, 0.001).force_N.z, std::clamp(measured, 0.0, 20.0));
  }
  inputs.measured_N = kNaN;
  EXPECT_EQ(stepPalpation(parameters, state, inputs, 0.001).refusal, Refusal::not_a_number);
}

TEST(Palpation, UpToTheLimitTheHandIsFreeAndBeyondItTheForceRisesSteeply) {
  const PalpationParameters parameters;
  for (const double dt_s : {0.0002, 0.001, 0.005}) {
    EXPECT_EQ(moved(parameters, 49.9, dt_s).tangential_N, Vec3{});
    EXPECT_EQ(moved(parameters, -49.9, dt_s).tangential_N, Vec3{});
    EXPECT_NEAR(moved(parameters, 51.0, dt_s).tangential_N.x, -0.05, 0.002);
    EXPECT_NEAR(moved(parameters, 150.0, dt_s).tangential_N.x, -2.5, 1e-9);  // half of the most where b·v is the most
    EXPECT_NEAR(moved(parameters, -150.0, dt_s).tangential_N.x, 2.5, 1e-9);
    EXPECT_GT(moved(parameters, 1e5, dt_s).tangential_N.x, -5.0);
    EXPECT_LT(moved(parameters, 1e5, dt_s).tangential_N.x, -4.9);
  }
  double before = 0.0;
  for (const double speed : stepsBefore(40.0, 300.0, 0.5)) {
    const double force = -moved(parameters, speed, 0.005).tangential_N.x;
    ASSERT_GE(force, before - 1e-12);
    ASSERT_LE(force - before, 0.05 * 0.5 + 1e-9);  // continuous: no faster than its steepness
    before = force;
  }
}

TEST(Palpation, InTheAirThereIsNoLimitAndItSetsInWithTheDepth) {
  const PalpationParameters parameters;
  PalpationState state;
  Vec3 before;
  double largest = 0.0;
  bool first = true;
  for (int i = 0; i < 1000; ++i) {  // down at 10 mm/s while across at 500
    const double z = 5.0 - 0.01 * i;
    const PalpationForce force = stepPalpation(parameters, state, onPlane(parameters, {0.5 * i, 0.0, z}), 0.001);
    ASSERT_EQ(length(force.force_N) > 0.0, z < 0.0) << z;
    if (!first) largest = std::max(largest, length(force.tangential_N - before));
    first = false;
    before = force.tangential_N;
  }
  EXPECT_LT(largest, 0.06);  // 4.1 N over 1 mm, 0.01 mm a step
  EXPECT_LT(before.x, -4.0);
}

/// Hands that wave with tremor, encoders' steps and jitter: what the tangential force has given is never more than it
/// has taken, 2 mJ a second, and what a step holds; and it is never above its most.
TEST(Palpation, TheForceAgainstTheHandNeverGivesMoreThanItTook) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  double worst_steps = 0.0;
  int pushed = 0;
  for (int k = 0; k < 300; ++k) {
    PalpationParameters parameters;
    parameters.speed_limit_mm_per_s = k % 5 == 0 ? 0.0 : 50.0;
    parameters.speed_time_constant_s = k % 3 == 0 ? 0.0 : k % 3 == 1 ? 0.01 : 0.2;
    PalpationState state;
    const double f = 0.5 + 10.0 * std::abs(any(random)), size = 1.0 + 30.0 * std::abs(any(random)), step_mm = 0.02;
    Vec3 at, force;
    double taken_mJ = 0.0, least_mJ = 0.0, farthest_mm = 0.0, t = 0.0;
    for (int i = 0; i < 3000; ++i) {
      const double dt_s = 0.0026 + 0.0024 * any(random);
      t += dt_s;
      Vec3 next{size * std::sin(2.0 * M_PI * f * t) + 0.1 * any(random), size * std::cos(2.7 * f * t), -4.0};
      next.x = step_mm * std::round(next.x / step_mm);
      next.y = step_mm * std::round(next.y / step_mm);
      if (i > 0) {
        taken_mJ -= dot(force, next - at);  // what acted while it moved
        farthest_mm = std::max(farthest_mm, length(next - at));
      }
      at = next;
      force = stepPalpation(parameters, state, onPlane(parameters, at), dt_s).tangential_N;
      pushed += length(force) > 0.0;
      ASSERT_LE(length(force), 5.0);
      ASSERT_EQ(force.z, 0.0);
      least_mJ = std::min(least_mJ, taken_mJ);
    }
    worst_steps = std::max(worst_steps, (-least_mJ - 2.0 * (1.0 + t)) / (5.0 * farthest_mm));  // 2 mJ a second
  }
  EXPECT_GT(pushed, 100'000);
  EXPECT_LT(worst_steps, 1.0);
  std::printf("most given beyond what was taken: %.2f of the most that a step holds\n", worst_steps);
}

TEST(Palpation, ASimulatedHandIsHeldNearTheLimitWithoutShaking) {
  for (const double dt_s : {0.0002, 0.001, 0.002}) {
    const PalpationParameters parameters;
    PalpationState state;
    double x = 0.0, v = 0.0, before = 0.0, largest_turn = 0.0;
    const double mass_kg = 0.3, pull_N = 3.0;
    for (int i = 0; i * dt_s < 3.0; ++i) {
      const double force = stepPalpation(parameters, state, onPlane(parameters, {x, 0.0, -5.0}), dt_s).tangential_N.x;
      v += (pull_N + force) / mass_kg * 1000.0 * dt_s;
      x += v * dt_s;
      if (i * dt_s > 2.0) largest_turn = std::max(largest_turn, std::abs(force - before));
      before = force;
    }
    // 3 N = 5 N · s/(s + 5 N): s = 7.5 N, 150 mm/s beyond the limit.
    EXPECT_NEAR(v, 200.0, 0.5) << dt_s;
    EXPECT_LT(largest_turn, 1e-3) << dt_s;
  }
}

TEST(Palpation, PressingAndLettingGoGivesNoEnergy) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  for (int k = 0; k < 50; ++k) {
    PalpationParameters parameters;
    parameters.damping_Ns_per_mm = k % 2 == 0 ? 0.0 : 0.01;
    PalpationState state;
    const double depth = 8.0 * std::abs(any(random)), f = 1.0 + std::abs(any(random));
    double given = 0.0, last_z = 1.0;
    Vec3 last;
    for (int i = 0; i <= 10'000; ++i) {
      const double z = 1.0 - (depth + 1.0) * 0.5 * (1.0 - std::cos(2.0 * M_PI * f * i / (10'000.0 * f)));
      const Vec3 force = stepPalpation(parameters, state, onPlane(parameters, {0.0, 0.0, z}), 1e-4).force_N;
      if (i > 0) given += 0.5 * (force.z + last.z) * (z - last_z);
      last = force;
      last_z = z;
    }
    ASSERT_LE(given, 1e-4);
    if (k % 2 == 0) {
      ASSERT_NEAR(given, 0.0, 1e-4);
    }
  }
}

TEST(Palpation, WhatIsNoNumberMovesNothing) {
  const PalpationParameters parameters;
  PalpationState state;
  static_cast<void>(stepPalpation(parameters, state, onPlane(parameters, {0.0, 0.0, -5.0}), 0.001));
  static_cast<void>(stepPalpation(parameters, state, onPlane(parameters, {1.0, 0.0, -5.0}), 0.001));
  const PalpationState before = state;
  std::vector<PalpationInputs> bad(6, onPlane(parameters, {0.0, 0.0, -5.0}));
  bad[0].probe_mm.y = kNaN;
  bad[1].touch.normal.x = kNaN;
  bad[2].touch.depth_mm = std::numeric_limits<double>::infinity();
  bad[3].touch.stiffness_N_per_mm = kNaN;
  bad[4].touch.normal = {};
  bad[5].probe_mm.x = 1e300;
  for (const PalpationInputs& each : bad) {
    const PalpationForce force = stepPalpation(parameters, state, each, 0.001);
    EXPECT_NE(force.refusal, Refusal::none);
    EXPECT_EQ(force.force_N, Vec3{});
    EXPECT_FALSE(force.touching);
  }
  EXPECT_EQ(stepPalpation(parameters, state, onPlane(parameters, {}), kNaN).refusal, Refusal::no_time);
  EXPECT_EQ(state.velocity_mm_per_s, before.velocity_mm_per_s);
  EXPECT_EQ(state.probe_mm, before.probe_mm);
}

TEST(Palpation, ParametersOutOfRangeAreNamed) {
  EXPECT_TRUE(checkParameters(PalpationParameters{}).has_value());
  PalpationParameters bad;
  bad.speed_limit_mm_per_s = -3.0;
  const auto checked = checkParameters(bad);
  ASSERT_FALSE(checked.has_value());
  EXPECT_NE(checked.error().text().find("palpation.speed_limit_mm_per_s = -3: expected"), std::string::npos);
}

}  // namespace
}  // namespace fyd::scene
