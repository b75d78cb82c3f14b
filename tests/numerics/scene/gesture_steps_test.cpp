// What holds for each step of the three gestures: nothing is allocated, the same inputs give the same bits, and
// whatever comes in, what comes out is a number and no larger than its parameters say.
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "app/bench/parts/allocation_count.h"
#include "core/scene/gesture/ball.h"
#include "core/scene/gesture/palpation.h"
#include "core/scene/gesture/swords.h"

namespace fyd::scene {
namespace {

/// Numbers that programs meet: ordinary ones, none, tiny, huge, and no numbers.
class Hostile {
 public:
  explicit Hostile(unsigned seed) : random_(seed) {}

  double number(double usual) {
    switch (random_() % 64) {
      case 0: return 0.0;
      case 1: return usual * 1e-300;
      case 2: return 1e9 * (2.0 * share() - 1.0);
      case 3: return 1e300;
      case 4: return std::numeric_limits<double>::quiet_NaN();
      case 5: return -std::numeric_limits<double>::infinity();
      case 6: return usual;
      case 7: return std::numeric_limits<double>::denorm_min();
      default: return usual * (2.0 * share() - 1.0);
    }
  }
  Vec3 vec(double usual) { return {number(usual), number(usual), number(usual)}; }
  double dt() { return random_() % 50 == 0 ? number(0.01) : 0.0002 + 0.0048 * share(); }
  double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  bool one(unsigned of) { return random_() % of == 0; }
  /// Each parameter at an end of its range, its default, or between.
  template <class Parameters>
  Parameters parameters() {
    Parameters out;
    for (const Parameter& each : bindParameters(out)) {
      const auto pick = random_() % 6;
      const double low = each.info.minimum, high = each.info.maximum;
      double value = pick == 0 ? low : pick == 1 ? high : pick == 2 ? low + share() * (high - low) : each.value();
      if (each.kind != ParameterKind::real) value = std::floor(std::min(value + 0.5, high));
      each.set(value);
    }
    EXPECT_TRUE(checkParameters(out).has_value());
    return out;
  }

 private:
  std::mt19937 random_;
};

template <class T>
bool sameBytes(const T& a, const T& b) {
  // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): the bits are what is asked for; there is no padding
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

TEST(GestureSteps, OfSwordsGiveNumbersWhateverComesIn) {
  int touched = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    Hostile hostile(seed);
    const auto parameters = hostile.parameters<SwordParameters>();
    const double most_N = parameters.most_force_N * (1.0 + parameters.friction);
    SwordState state;
    const double size = hostile.one(3) ? 1e-3 : hostile.one(2) ? 1.0 : 1000.0;
    Blade a{hostile.vec(size), hostile.vec(size)}, b{hostile.vec(size), hostile.vec(size)};
    for (int i = 0; i < 50; ++i) {
      if (hostile.one(2)) a.tip_mm = hostile.vec(size);
      if (hostile.one(3)) b = hostile.one(4) ? a : Blade{hostile.vec(size), hostile.vec(size)};
      const SwordTouch touch = stepSwords(parameters, state, a, b, hostile.dt());
      touched += touch.touching;
      ASSERT_TRUE(touch.force_N.finite() && touch.torque_Nmm.finite() && touch.point_mm.finite()) << seed << " " << i;
      ASSERT_TRUE(touch.normal.finite() && std::isfinite(touch.depth_mm) && std::isfinite(touch.began_ago_s));
      ASSERT_LE(length(touch.force_N), most_N * (1.0 + 1e-9)) << seed << " " << i;
      if (touch.refusal != Refusal::none) {
        ASSERT_EQ(touch.force_N, Vec3{});
      }
    }
  }
  EXPECT_GT(touched, 1000);
}

TEST(GestureSteps, OfABallGiveNumbersWhateverComesIn) {
  int impacts = 0, rests = 0;
  for (unsigned seed = 0; seed < 1000; ++seed) {
    Hostile hostile(seed);
    const auto parameters = hostile.parameters<BallParameters>();
    BallGameState state;
    state.ball = {{0.0, 0.0, 300.0}, {}, {}};
    RacketPose pose;
    for (int i = 0; i < 40; ++i) {
      if (hostile.one(20)) state.ball = {hostile.vec(300.0), hostile.vec(1e4), hostile.vec(100.0)};
      if (hostile.one(3)) pose = {hostile.vec(100.0), hostile.vec(1.0), hostile.vec(1.0)};
      const BallState before = state.ball;
      const auto racket = hostile.one(10) ? std::nullopt : std::optional(pose);
      const BallStep step = stepBall(parameters, state, racket, hostile.dt());
      impacts += step.impacts;
      rests += step.rest != BallRest::flies;
      ASSERT_TRUE(step.force_N.finite()) << seed << " " << i;
      ASSERT_LE(length(step.force_N), parameters.most_force_N * (1.0 + 1e-9)) << seed << " " << i;
      if (step.refusal != Refusal::none) {
        ASSERT_TRUE(sameBytes(state.ball, before)) << seed << " " << i;
        state.ball = {{0.0, 0.0, 300.0}, {}, {}};
      } else {
        ASSERT_TRUE(state.ball.position_mm.finite() && state.ball.velocity_mm_per_s.finite() &&
                    state.ball.spin_rad_per_s.finite())
            << seed << " " << i;
      }
    }
  }
  EXPECT_GT(impacts, 1000);
  EXPECT_GT(rests, 100);
}

TEST(GestureSteps, OfPalpationGiveNumbersWhateverComesIn) {
  int touching = 0, held_back = 0;
  for (unsigned seed = 0; seed < 2000; ++seed) {
    Hostile hostile(seed);
    const auto parameters = hostile.parameters<PalpationParameters>();
    PalpationState state;
    for (int i = 0; i < 50; ++i) {
      PalpationInputs inputs{hostile.vec(50.0), {hostile.vec(1.0), hostile.number(10.0), hostile.number(1.0)}, {}};
      if (hostile.one(4)) inputs.measured_N = hostile.number(10.0);
      const PalpationForce force = stepPalpation(parameters, state, inputs, hostile.dt());
      ASSERT_TRUE(force.force_N.finite() && force.segment.to_mm.finite() && std::isfinite(force.segment.value_N))
          << seed << " " << i;
      ASSERT_LE(length(force.normal_N), parameters.most_force_N * (1.0 + 1e-9)) << seed << " " << i;
      ASSERT_LE(length(force.tangential_N), parameters.most_tangential_N * (1.0 + 1e-9)) << seed << " " << i;
      touching += length(force.normal_N) > 0.0;
      held_back += length(force.tangential_N) > 0.0;
    }
  }
  EXPECT_GT(touching, 1000);
  EXPECT_GT(held_back, 500);
}

struct All {
  SwordState swords;
  BallGameState ball{.ball = {{0.0, 0.0, 200.0}, {100.0, 0.0, 0.0}, {}}, .racket = {}, .pending_impulse_Ns = {}};
  PalpationState palpation;

  double step(double t) {
    SwordParameters sword;
    sword.radius_mm = 3.0;
    sword.friction = 0.2;
    BallParameters game;
    game.drag_per_m = 0.02;
    game.friction = 0.2;
    const PalpationParameters probe;
    const double a = 30.0 * std::sin(9.0 * t);
    const auto swords_out = stepSwords(sword, swords, {{0.0, 0.0, a}, {900.0, 100.0, a}},
                                       {{500.0, -400.0, 0.0}, {450.0, 500.0, 5.0}}, 0.001);
    const auto ball_out =
        stepBall(game, ball, RacketPose{.centre_mm = {0.0, 0.0, a}, .normal = {0.1, 0.001 * a, 1.0}}, 0.001);
    const Vec3 at{5.0 * a, 0.0, 0.1 * a};
    const auto probe_out = stepPalpation(probe, palpation, {at, touchPlane(probe, {}, at), {}}, 0.001);
    return swords_out.force_N.z + ball_out.force_N.z + probe_out.force_N.x;
  }
};

TEST(GestureSteps, AllocateNothingAndGiveTheSameBits) {
  All one, other;
  double sum = 0.0, again = 0.0;
  const bench::AllocationCount allocations;
  for (int i = 0; i < 5000; ++i) sum += one.step(0.001 * i);
  EXPECT_EQ(allocations.count(), 0U);
  for (int i = 0; i < 5000; ++i) again += other.step(0.001 * i);
  EXPECT_TRUE(sameBytes(sum, again));
  EXPECT_NE(sum, 0.0);
}

}  // namespace
}  // namespace fyd::scene
