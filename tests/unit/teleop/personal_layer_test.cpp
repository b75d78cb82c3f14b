// The personal layer of the predictor: learning of a hand's deviations, and their weight.
#include "core/teleop/prediction/personal_layer.h"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/teleop/prediction/trust.h"

namespace fyd::teleop {
namespace {

PersonalLayer::Inputs drawn(std::mt19937& random) {
  PersonalLayer::Inputs out{};
  for (float& each : out) each = std::max(0.0F, static_cast<float>(random() % 2001) * 1e-3F - 1.0F);
  return out;
}

/// What this hand does otherwise: half of one input along, less of another across, over the second node only.
PersonalLayer::Differences habit(const PersonalLayer::Inputs& in) {
  PersonalLayer::Differences out{};
  out[1] = {0.5F * in[3], -0.25F * in[40]};
  return out;
}

TEST(PersonalLayer, LearnsWhatAHandDoesOtherwise) {
  std::mt19937 random(1);
  PersonalLayer layer;
  for (int i = 0; i < 10000; ++i) {
    const auto in = drawn(random);
    layer.learn(in, habit(in));
  }
  for (int i = 0; i < 20; ++i) {
    const auto in = drawn(random);
    const auto said = layer(in), truth = habit(in);
    EXPECT_NEAR(said[1][0], truth[1][0], 0.05);
    EXPECT_NEAR(said[1][1], truth[1][1], 0.05);
    EXPECT_EQ(said[0][0], 0.0F);
  }
  layer.setNodes({2, 5, 0}, {5, 6, 0});  // what was known over five steps is the best that is known over six
  const auto in = drawn(random);
  EXPECT_EQ(layer(in)[0], layer(in)[1]);
}

TEST(PersonalLayer, WhatIsNotFiniteLeavesItAsItWasOrAnew) {
  constexpr float kNaNf = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();
  std::mt19937 random(2);
  PersonalLayer layer;
  for (int i = 0; i < 5000; ++i) {
    auto in = drawn(random);
    auto differences = habit(in);
    if (i % 5 == 0) in[random() % in.size()] = std::array{kNaNf, kInfinity, -kInfinity, 3e38F}[random() % 4];
    if (i % 7 == 0) differences[1][random() % 2] = std::array{kNaNf, kInfinity, -kInfinity, 3e38F}[random() % 4];
    layer.learn(in, differences);
    for (const auto& node : layer(drawn(random))) {
      for (const float x : node) ASSERT_TRUE(std::isfinite(x)) << i;
    }
  }
}

TEST(Trust, IsTheShareThatCameTrueAndNothingOfNoise) {
  Trust trust;
  EXPECT_NEAR(trust.initialFactor({10.0}), 1.0, 1e-3);  // large against a hand's noise, and nothing known against it
  EXPECT_LT(trust.initialFactor({0.02}), 0.02);
  for (int i = 0; i < 500; ++i) trust.addOutcome({4.0}, {1.0});
  EXPECT_NEAR(trust.factor(1.0, 0.0, 0.05), 1.2 * 0.25, 0.01);
  for (int i = 0; i < 500; ++i) trust.addOutcome({4.0}, {-1.0});
  EXPECT_EQ(trust.factor(1.0, 0.0, 0.05), 0.0);
  Trust walk;  // steps of a random walk: second differences are twice the first ones
  walk.addDifferences(100.0, 200.0);
  EXPECT_EQ(walk.initialFactor({10.0}), 0.0);
  EXPECT_EQ(walk.factor(1.0, 1.0, 0.05), 0.0);
}

}  // namespace
}  // namespace fyd::teleop
