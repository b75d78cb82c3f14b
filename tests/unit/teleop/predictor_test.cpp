// Predictors: the published formulas, properties that all must have, the default one on hard inputs.
#include "core/teleop/prediction/predictor.h"
#include "core/teleop/prediction/predictor_choice.h"

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/teleop/prediction/learned_forecast.h"
#include "core/teleop/prediction/prediction_trial.h"
#include "core/teleop/prediction/stroke_weights.h"
#include "tests/not_a_number.h"

namespace fyd::teleop {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::unique_ptr<Predictor> named(std::string_view name, std::size_t axes = 1) {
  return makePredictor(predictorNamed(name).value(), {.axes = axes, .period_s = 0.010});
}

TEST(MakePredictor, ANumberOfAxesBeyondItsRangeCountsAsTheNearest) {
  for (const std::string_view name : kPredictorNames) {
    for (const std::size_t axes : {std::size_t{0}, std::size_t{4}, std::numeric_limits<std::size_t>::max()}) {
      const auto beyond = named(name, axes), nearest = named(name, axes == 0 ? 1 : kMostAxes);
      for (int i = 0; i < 600; ++i) {
        const double t_s = 0.01 * i;
        const Position at = {std::sin(t_s), std::cos(t_s), t_s};
        beyond->message(t_s, at);
        nearest->message(t_s, at);
        EXPECT_EQ(beyond->predict(t_s + 0.05), nearest->predict(t_s + 0.05)) << name << ", " << axes << " axes";
      }
    }
  }
  EXPECT_NE(makePredictor(static_cast<PredictorChoice>(200), {}), nullptr);
}

/// One without its line in makePredictor would be the experts.
TEST(MakePredictor, NoTwoNamesPredictAlike) {
  std::map<std::vector<double>, std::string_view> ways;
  for (const std::string_view name : kPredictorNames) {
    const auto predictor = named(name);
    std::vector<double> way;
    for (int i = 0; i < 400; ++i) {
      const double t_s = 0.01 * i;
      predictor->message(t_s, {30.0 * std::sin(5.0 * t_s) + 4.0 * std::sin(31.0 * t_s * t_s), 0.0, 0.0});
      way.push_back(predictor->predict(t_s + 0.05)[0]);
    }
    const auto [other, is_new] = ways.emplace(std::move(way), name);
    EXPECT_TRUE(is_new) << name << " is " << other->second;
  }
}

Trace traceOf(double seconds, double rate_Hz, const std::function<double(double)>& x, double start_s = 0.0) {
  Trace out{.axes = 1, .time_s = {}, .position_mm = {}};
  for (int i = 0; i < static_cast<int>(seconds * rate_Hz); ++i) {
    const double t = static_cast<double>(i) / rate_Hz;
    out.time_s.push_back(start_s + t);
    out.position_mm.push_back({x(t), 0.0, 0.0});
  }
  return out;
}

TrialFigures figuresOf(std::string_view name, const Trace& trace, const TrialNetwork& network, double smooth_s = 0.0) {
  const TrialPlan plan = planTrial(trace, network);
  const auto predictor = named(name, trace.axes);
  return trialFigures(trace, plan, runTrial(trace, plan, *predictor, smooth_s));
}

class EachPredictor : public testing::TestWithParam<std::string_view> {};
INSTANTIATE_TEST_SUITE_P(Names, EachPredictor, testing::ValuesIn(kPredictorNames), [](const auto& each) {
  return std::string(each.param == "default" ? "experts" : each.param);
});

TEST(Predictor, AnUnknownNameIsRefusedWithTheNames) {
  const auto none = predictorNamed("order2");
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().text(), testing::AllOf(testing::HasSubstr("order2"), testing::HasSubstr("default")));
}

TEST(Predictor, ThePapersThreeAsPrinted) {
  // 2 mm in the last 10 ms, 30 ms ago: 2, 2 + 6 and half the sum of both.
  for (const auto& [name, expected] : {std::pair{"order0", 2.0}, {"order1", 8.0}, {"hybrid", 5.0}}) {
    const auto predictor = named(name);
    predictor->message(1.00, {0.0});
    predictor->message(1.01, {2.0});
    EXPECT_NEAR(predictor->predict(1.04)[0], expected, 1e-9) << name;
  }
}

TEST(Predictor, TheSlopeIsOfTheMessagesNoOlderThanTenMilliseconds) {
  // Six at 2 ms, of a parabola, and an older one far off: least squares over the six is their mean slope.
  const auto predictor = makePredictor(PredictorChoice::order1, {.axes = 1, .period_s = 0.002});
  predictor->message(-1.0, {500.0});
  for (int i = 0; i <= 5; ++i) predictor->message(0.002 * i, {i * 1.0 * i});
  EXPECT_NEAR(predictor->predict(0.011)[0], 25.0 + 2500.0 * 0.001, 1e-9);
}

TEST_P(EachPredictor, BeforeTheFirstMessageIsZeroAndAfterItHolds) {
  const auto predictor = named(GetParam());
  EXPECT_EQ(predictor->predict(5.0), Position{});
  predictor->message(5.0, {3.25});
  EXPECT_DOUBLE_EQ(predictor->predict(5.05)[0], 3.25);
}

TEST_P(EachPredictor, NothingMakesItsOutputAnythingButFinite) {
  std::mt19937 random(7);
  const std::array<double, 12> hostile = {kNaN, kInfinity, -kInfinity, 1e300, -1e300, 1e-300,
                                          0.0,  -0.0,      1e9,        -3.0,  5.0,    1e17};
  const auto predictor = named(GetParam(), 3);
  for (int i = 0; i < 20'000; ++i) {
    const auto any = [&] {
      return random() % 3 == 0 ? hostile[random() % hostile.size()] : static_cast<double>(random() % 1000) * 0.01;
    };
    predictor->message(any(), {any(), any(), any()});
    if (i % 97 == 0) predictor->endMotion();
    for (const double x : predictor->predict(any())) ASSERT_TRUE(std::isfinite(x)) << i;
    for (const double v : predictor->velocity(any())) ASSERT_TRUE(std::isfinite(v)) << i;
  }
  // And it is of use again afterwards.
  predictor->endMotion();
  for (int i = 0; i < 100; ++i) predictor->message(2e17 + i, {kNaN, 0.0, 0.0});
  predictor->endMotion();
  for (int i = 0; i < 300; ++i) predictor->message(10.0 + 0.01 * i, {4.0, 5.0, 6.0});
  EXPECT_NEAR(predictor->predict(13.04)[0], 4.0, 1e-3);
}

TEST_P(EachPredictor, AMessageTwiceChangesNothing) {
  const auto once = named(GetParam());
  const auto twice = named(GetParam());
  for (int i = 0; i < 200; ++i) {
    const double t = 0.01 * i;
    once->message(t, {8.0 * std::sin(9.0 * t)});
    for (int copy = 0; copy < 3; ++copy) twice->message(t, {8.0 * std::sin(9.0 * t)});
    twice->message(t, {1234.0});  // another position of the same date: the first counts
    EXPECT_EQ(once->predict(t + 0.05), twice->predict(t + 0.05));
  }
}

TEST_P(EachPredictor, AMessageThatIsIgnoredEndsNoMotion) {
  const auto clean = named(GetParam());
  const auto disturbed = named(GetParam());
  for (int i = 0; i < 100; ++i) {
    const double t = 0.01 * i;
    clean->message(t, {8.0 * std::sin(9.0 * t)});
    disturbed->message(t, {8.0 * std::sin(9.0 * t)});
    disturbed->message(t + 5.0, {kNaN});
    disturbed->message(t + 5.0, {1e12});
    disturbed->message(kInfinity, {1.0});
    EXPECT_EQ(clean->predict(t + 0.05), disturbed->predict(t + 0.05)) << i;
  }
}

TEST_P(EachPredictor, WhereThePredictionIsHeldItsVelocityIsZero) {
  const auto predictor = named(GetParam());
  constexpr double kNewest_s = 1.99;
  for (int i = 0; i < 200; ++i) {
    predictor->message(0.01 * i, {1.0 * i});
    static_cast<void>(predictor->predict(0.01 * i + 0.05));
  }
  // Before the newest date, as when the clocks differ, and after a long silence.
  for (const double time_s : {kNewest_s - 0.05, kNewest_s + kSilence_s + 0.5}) {
    if (predictor->predict(time_s) != predictor->predict(time_s + 0.01)) continue;
    EXPECT_EQ(predictor->velocity(time_s), Position{}) << time_s;
  }
  for (const std::string_view held : {"kalman", "default"}) {
    if (GetParam() == held) {
      EXPECT_EQ(predictor->velocity(kNewest_s - 0.05), Position{});
    }
  }
}

TEST_P(EachPredictor, TheFutureIsNotLookedAt) {
  const auto motion = [](double t) { return 6.0 * std::sin(7.0 * t) + 2.0 * std::sin(23.0 * t); };
  const Trace one = traceOf(3.0, 1000.0, motion);
  Trace other = one;
  constexpr std::size_t kFrom = 1700;
  for (std::size_t i = kFrom; i < other.time_s.size(); ++i)
    other.position_mm[i][0] += 0.1 * static_cast<double>(i - kFrom);
  const TrialNetwork network{.period_ms = 10.0, .delay_ms = 40.0, .jitter_ms = 30.0, .loss_percent = 20.0, .seed = 3};
  const TrialPlan plan = planTrial(one, network);
  const auto a = runTrial(one, plan, *named(GetParam()), 0.0);
  const auto b = runTrial(other, plan, *named(GetParam()), 0.0);
  bool differed = false;
  for (std::size_t i = 0; i < plan.ticks.size(); ++i) {
    if (plan.ticks[i].row < kFrom + 40) {
      ASSERT_EQ(a[i], b[i]) << plan.ticks[i].row;
    }
    differed = differed || a[i] != b[i];
  }
  EXPECT_TRUE(differed);
}

TEST_P(EachPredictor, WhenTheClockBeganDoesNotMatter) {
  // Dates of 1e9 s are told apart to 1e-7 s.
  const auto motion = [](double t) { return 6.0 * std::sin(7.0 * t); };
  const TrialNetwork network{.period_ms = 10.0, .delay_ms = 50.0};
  const double here = figuresOf(GetParam(), traceOf(3.0, 1000.0, motion), network).rms_mm;
  EXPECT_NEAR(figuresOf(GetParam(), traceOf(3.0, 1000.0, motion, -3.0), network).rms_mm, here, 0.02 * here);
  EXPECT_NEAR(figuresOf(GetParam(), traceOf(3.0, 1000.0, motion, 1e9), network).rms_mm, here, 0.02 * here);
}

TEST(DefaultPredictor, ARampIsFollowedAndASineLearnt) {
  const TrialNetwork network{.period_ms = 10.0, .delay_ms = 50.0};
  const Trace ramp = traceOf(4.0, 1000.0, [](double t) { return 30.0 * t; });
  EXPECT_LT(figuresOf("default", ramp, network).rms_mm, 0.25 * figuresOf("order0", ramp, network).rms_mm);
  const Trace sine = traceOf(8.0, 1000.0, [](double t) { return 8.0 * std::sin(12.0 * t); });
  EXPECT_LT(figuresOf("default", sine, network).rms_mm, 0.3 * figuresOf("order1", sine, network).rms_mm);
}

TEST(DefaultPredictor, AHandThatNeverMovedIsFollowedWhenItDoes) {
  // Errors that were exactly 0 for so long that what is remembered of the beginning is 0 too.
  constexpr int kRest = 80'000, kMotion = 1'000;
  constexpr double kWay_mm = 0.1;
  const auto predictor = named("default");
  double x_mm = 4.0;
  for (int i = 0; i < kRest + kMotion; ++i) {
    if (i >= kRest) x_mm += kWay_mm;
    predictor->message(0.01 * i, {x_mm});
    ASSERT_TRUE(std::isfinite(predictor->predict(0.01 * i + 0.05)[0])) << i;
  }
  EXPECT_NEAR(predictor->predict(0.01 * (kRest + kMotion - 1) + 0.05)[0], x_mm + 5.0 * kWay_mm, 0.01);
}

TEST(DefaultPredictor, SilenceOf637MillisecondsEndsInABoundedGuess) {
  const auto predictor = named("default");
  const auto motion = [](double t) { return 8.0 * std::sin(12.0 * t); };
  for (int i = 0; i < 300; ++i) {
    predictor->message(0.01 * i, {motion(0.01 * i)});
    static_cast<void>(predictor->predict(0.01 * i + 0.05));
  }
  for (int i = 0; i < 637; ++i) {
    const double x = predictor->predict(3.04 + 0.001 * i)[0];
    ASSERT_LE(std::abs(x), 8.0 + 1.25 * 16.0) << i;
  }
  for (int i = 0; i < 30; ++i) {
    const double t = 3.63 + 0.01 * i;
    predictor->message(t, {motion(t)});
    static_cast<void>(predictor->predict(t + 0.05));
  }
  EXPECT_NEAR(predictor->predict(3.97)[0], motion(3.97), 4.0);
}

TEST(DefaultPredictor, ClocksThatDriftApartBy100ppm) {
  // The sender's dates fall behind: the age of the newest message grows from 50 to 51 ms in 10 s.
  const auto motion = [](double t) { return 8.0 * std::sin(9.0 * t); };
  double drifting = 0.0, hold = 0.0;
  const auto predictor = named("default");
  for (int i = 0; i < 1000; ++i) {
    const double t = 0.01 * i;
    predictor->message(t * (1.0 - 1e-4), {motion(t)});
    for (int k = 0; k < 10; ++k) {
      const double now = t + 0.05 + 0.001 * k;
      const double x = predictor->predict(now)[0];
      if (i < 100) continue;
      drifting += std::pow(x - motion(now), 2);
      hold += std::pow(motion(t) - motion(now), 2);
    }
  }
  EXPECT_LT(drifting, 0.1 * hold);
}

TEST(DefaultPredictor, TheFirstMessageLostAndAMotionOfOneRow) {
  const auto predictor = named("default", 2);
  for (int stroke = 0; stroke < 50; ++stroke) {
    predictor->endMotion();
    predictor->message(stroke, {1.0 * stroke, 2.0, 0.0});
    EXPECT_EQ(predictor->predict(stroke + 0.05), (Position{1.0 * stroke, 2.0, 0.0}));
  }
}

TEST(DefaultPredictor, WhatItLearntStaysOverALiftedHand) {
  // The same short stroke again and again: the last ones are better known than the first.
  const auto predictor = named("default");
  std::vector<double> error;
  for (int stroke = 0; stroke < 40; ++stroke) {
    predictor->endMotion();
    error.push_back(0.0);
    for (int i = 0; i < 40; ++i) {
      const auto motion = [](double t) { return 10.0 * std::sin(15.0 * t); };
      predictor->message(stroke + 0.01 * i, {motion(0.01 * i)});
      error.back() += std::pow(predictor->predict(stroke + 0.01 * i + 0.05)[0] - motion(0.01 * i + 0.05), 2);
    }
  }
  EXPECT_LT(error.back(), 0.3 * error.front());
}

TEST(DefaultPredictor, GivesTheSameBitsAgain) {
  const Trace trace = traceOf(3.0, 1000.0, [](double t) { return 6.0 * std::sin(7.0 * t) + std::sin(31.0 * t); });
  const TrialPlan plan =
      planTrial(trace, {.period_ms = 10.0, .delay_ms = 40.0, .jitter_ms = 30.0, .loss_percent = 20.0});
  EXPECT_EQ(runTrial(trace, plan, *named("default"), 0.01), runTrial(trace, plan, *named("default"), 0.01));
}

TEST(StrokeWeights, TheLargestLeaveEveryPredictionFiniteAndNotHeld) {
  const std::string largest = std::to_string(StrokeWeights::kLargestWeight) + " ";
  for (const unsigned one_negative_of : {2U, 3U, 10000U}) {
    std::mt19937 random(one_negative_of);
    std::string text = "22 64 24\n";
    for (int i = 0; i < 7720; ++i) text += (random() % one_negative_of == 0 ? "-" : "") + largest;
    const auto weights = StrokeWeights::parse(text);
    ASSERT_TRUE(weights.has_value()) << weights.error().text();
    const auto predictor = makePredictor(PredictorChoice::experts, {.axes = 2, .period_s = 0.0, .weights = *weights});
    int held = 0;
    for (int i = 0; i < 400; ++i) {
      const double t = 0.016 * i;
      const Position at{40.0 * std::sin(5.0 * t), 20.0 * std::sin(8.0 * t + 1.0), 0.0};
      predictor->message(t, at);
      const Position there = predictor->predict(t + 0.05);
      for (const double x : there) ASSERT_TRUE(std::isfinite(x)) << i;
      for (const double v : predictor->velocity(t + 0.05)) ASSERT_TRUE(std::isfinite(v)) << i;
      held += static_cast<int>(there == at);
    }
    EXPECT_LT(held, 40);  // as it would be from where a forecast is no number
  }
}

TEST(StrokeWeights, OfAnotherShapeOrWithoutNumbersAreRefused) {
  EXPECT_THAT(StrokeWeights::parse("").error().text(), testing::HasSubstr("0 weights"));
  EXPECT_THAT(StrokeWeights::parse("22 64 24\n1 2 x3").error().text(), testing::HasSubstr("\"x3\""));
  EXPECT_THAT(StrokeWeights::parse("22 64 24\n1 nan").error().text(), testing::HasSubstr("nan"));
  EXPECT_THAT(StrokeWeights::parse("22 64 24\n1 0.5-0.3 2").error().text(), testing::HasSubstr("\"0.5-0.3\""));
  EXPECT_THAT(StrokeWeights::parse("22 64 24\n1 2e38").error().text(),
              testing::HasSubstr("\"2e38\"; expected one from"));
  const std::string usual(strokeWeightsText());
  EXPECT_TRUE(StrokeWeights::parse(usual).has_value());
  const std::size_t shape = usual.find("22 64 24");
  ASSERT_NE(shape, std::string::npos);
  const auto fraction = StrokeWeights::parse(std::string(usual).replace(shape, 2, "22.7"));
  ASSERT_FALSE(fraction.has_value());
  EXPECT_THAT(fraction.error().text(), testing::HasSubstr("expected 22, 64, 24"));
  EXPECT_THAT(StrokeWeights::parse("22 64 24\n1 2 3\n").error().text(), testing::HasSubstr("3 weights"));
  EXPECT_THAT(StrokeWeights::parse("-1 1e30 24\n").error().text(), testing::HasSubstr("expected 22, 64, 24"));
}

}  // namespace
}  // namespace fyd::teleop
