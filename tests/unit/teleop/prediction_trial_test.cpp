// The prediction trial: simulated network, error figures, smoothing of the output.
#include "core/teleop/prediction/prediction_trial.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/teleop/prediction/predictor_choice.h"
#include "core/teleop/prediction/smooth_output.h"
#include "tests/not_a_number.h"

namespace fyd::teleop {
namespace {

Trace rows(std::initializer_list<std::pair<double, double>> each) {
  Trace out{.axes = 1, .time_s = {}, .position_mm = {}};
  for (const auto& [t, x] : each) {
    out.time_s.push_back(t);
    out.position_mm.push_back({x, 0.0, 0.0});
  }
  return out;
}

std::vector<std::pair<std::size_t, std::size_t>> arrivals(const TrialPlan& plan) {
  std::vector<std::pair<std::size_t, std::size_t>> out;  // tick's row, message's row
  for (const auto& tick : plan.ticks) {
    for (std::size_t m = tick.first; m < tick.last; ++m) out.emplace_back(tick.row, plan.messages[m].row);
  }
  return out;
}

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

TEST(PredictionTrial, AMessageIsTheNewestRowAtItsTimeAndArrivesADelayLater) {
  // Rows each 4 ms from 2 s, messages each 10 ms, 5 ms on the way: of rows 0 and 2 (8 ms), at 5 and 15 ms.
  Trace trace{.axes = 1, .time_s = {}, .position_mm = {}};
  for (int i = 0; i < 6; ++i) {
    trace.time_s.push_back(2.0 + 0.004 * i);
    trace.position_mm.push_back({1.0 * i, 0.0, 0.0});
  }
  const TrialPlan plan = planTrial(trace, {.period_ms = 10.0, .delay_ms = 5.0});
  EXPECT_THAT(arrivals(plan), ElementsAre(Pair(2, 0), Pair(4, 2)));
  ASSERT_EQ(plan.ticks.size(), 4U);  // from the first arrival to the end
  EXPECT_TRUE(plan.ticks.front().begins);
}

TEST(PredictionTrial, WithoutAPeriodEachRowIsAMessage) {
  const Trace trace = rows({{0.0, 1.0}, {0.016, 2.0}, {0.040, 3.0}, {0.050, 4.0}});
  EXPECT_THAT(arrivals(planTrial(trace, {.period_ms = 0.0, .delay_ms = 20.0})), ElementsAre(Pair(2, 0), Pair(2, 1)));
}

TEST(PredictionTrial, AGapDropsWhatIsUnderWayAndBeginsAnew) {
  const Trace trace =
      rows({{0.00, 1.0}, {0.01, 2.0}, {0.02, 3.0}, {0.03, kNaN}, {0.04, 5.0}, {0.05, 6.0}, {0.06, 7.0}});
  const TrialPlan plan = planTrial(trace, {.period_ms = 10.0, .delay_ms = 20.0});
  // Of rows 1 and 2 nothing arrives: they are under way when the hand is lifted. Row 4 arrives at 60 ms.
  EXPECT_THAT(arrivals(plan), ElementsAre(Pair(2, 0), Pair(6, 4)));
  ASSERT_EQ(plan.ticks.size(), 2U);
  EXPECT_TRUE(plan.ticks[1].begins);
}

TEST(PredictionTrial, JitterOvertakesAndLossLoses) {
  Trace trace{.axes = 1, .time_s = {}, .position_mm = {}};
  for (int i = 0; i < 20'000; ++i) {
    trace.time_s.push_back(0.001 * i);
    trace.position_mm.push_back({1.0 * i, 0.0, 0.0});
  }
  const TrialPlan plan =
      planTrial(trace, {.period_ms = 10.0, .delay_ms = 30.0, .jitter_ms = 50.0, .loss_percent = 20.0, .seed = 4});
  EXPECT_NEAR(static_cast<double>(plan.messages.size()), 0.8 * 2000, 60);
  std::size_t overtaken = 0;
  double earliest = 1.0, latest = 0.0;
  for (std::size_t m = 0; m < plan.messages.size(); ++m) {
    if (m > 0 && plan.messages[m].row < plan.messages[m - 1].row) ++overtaken;
    const double way = plan.messages[m].arrival_s - 0.001 * static_cast<double>(plan.messages[m].row);
    earliest = std::min(earliest, way);
    latest = std::max(latest, way);
  }
  EXPECT_GT(overtaken, 200U);
  EXPECT_NEAR(earliest, 0.030, 0.001);
  EXPECT_NEAR(latest, 0.080, 0.001);
  const TrialPlan all_lost = planTrial(trace, {.period_ms = 10.0, .delay_ms = 0.0, .loss_percent = 100.0});
  EXPECT_TRUE(all_lost.ticks.empty());
}

TEST(PredictionTrial, FiguresOfAHeldSineAreThoseOfTheBook) {
  // Each row held for exactly 20 ms: the error of A·sin ωt against itself τ earlier is 2A·sin(ωτ/2), RMS /√2.
  Trace trace{.axes = 2, .time_s = {}, .position_mm = {}};
  constexpr double kOmega = 2.0 * std::numbers::pi * 2.0;
  for (int i = 0; i < 4000; ++i) {
    trace.time_s.push_back(0.001 * i);
    trace.position_mm.push_back({3.0 * std::sin(kOmega * 0.001 * i), 4.0 * std::sin(kOmega * 0.001 * i), 0.0});
  }
  const TrialPlan plan = planTrial(trace, {.period_ms = 0.0, .delay_ms = 20.0});
  const auto hold = makePredictor(PredictorChoice::order0, {.axes = 2});
  const TrialFigures figures = trialFigures(trace, plan, runTrial(trace, plan, *hold, 0.0));
  const double most = 2.0 * 5.0 * std::sin(kOmega * 0.020 / 2.0);
  EXPECT_NEAR(figures.max_mm, most, 1e-3);
  EXPECT_NEAR(figures.rms_mm, most / std::numbers::sqrt2, 0.01);
  EXPECT_NEAR(figures.jerk_ratio, 1.0, 0.01);  // the same motion, later
  EXPECT_NEAR(figures.largest_step_mm, 5.0 * kOmega * 0.001, 1e-3);
}

TEST(PredictionTrial, VibrationIsOfTheBandBetween20And200Hz) {
  Trace trace{.axes = 1, .time_s = {}, .position_mm = {}};
  std::vector<Position> buzzing;
  constexpr double kTurn = 2.0 * std::numbers::pi;
  for (int i = 0; i < 8000; ++i) {
    const double t = 0.001 * i;
    trace.time_s.push_back(t);
    const double slow = 5.0 * std::sin(kTurn * 2.0 * t), tremor = 0.01 * std::sin(kTurn * 50.0 * t);
    trace.position_mm.push_back({slow + tremor, 0.0, 0.0});
    buzzing.push_back({2.0 * slow + 3.0 * tremor + 0.5 * std::sin(kTurn * 5.0 * t), 0.0, 0.0});
  }
  const TrialPlan plan = planTrial(trace, {.period_ms = 0.0, .delay_ms = 0.0});
  EXPECT_NEAR(trialFigures(trace, plan, buzzing).vibration_ratio, 3.0, 0.05);
  for (double& t : trace.time_s) t *= 2.0;  // 500 Hz
  EXPECT_TRUE(std::isnan(trialFigures(trace, plan, buzzing).vibration_ratio));
}

TEST(PredictionTrial, WhereNoMessageArrivesNothingWasPredictedWithoutAnError) {
  Trace trace{.axes = 1, .time_s = {}, .position_mm = {}};
  for (int i = 0; i < 2000; ++i) {
    trace.time_s.push_back(0.001 * i);
    trace.position_mm.push_back({0.01 * i, 0.0, 0.0});
  }
  for (const TrialNetwork& network : {TrialNetwork{.loss_percent = 100.0}, TrialNetwork{.delay_ms = 3000.0}}) {
    const TrialPlan plan = planTrial(trace, network);
    const TrialFigures out = trialFigures(trace, plan, {});
    EXPECT_EQ(out.ticks, 0U);
    for (const double each :
         {out.rms_mm, out.mean_mm, out.max_mm, out.vibration_ratio, out.largest_step_mm, out.jerk_ratio}) {
      EXPECT_TRUE(std::isnan(each));
    }
  }
}

TEST(PredictionTrial, MoreMessagesThanFitIntoMemoryAreRefusedWhateverTheirRows) {
  const auto two = [](double length_s) { return rows({{100.0, 1.0}, {100.0 + length_s, 2.0}}); };
  EXPECT_THAT(checkMessages(two(86'400.0), {.period_ms = 0.1}).error().text(),
              testing::AllOf(HasSubstr("period 0.1 ms: 864000001 messages in 86400 s"), HasSubstr("10000000")));
  EXPECT_FALSE(checkMessages(two(86'400.0), {.period_ms = 1.0}));
  EXPECT_TRUE(checkMessages(two(86'400.0), {.period_ms = 10.0}));
  EXPECT_TRUE(checkMessages(two(86'400.0), {.period_ms = 0.0})) << "two messages";
  EXPECT_TRUE(checkMessages(two(999.0), {.period_ms = 0.1})) << "9 990 001";
  EXPECT_FALSE(checkMessages(two(1000.0), {.period_ms = 0.1})) << "10 000 001";
}

TEST(PredictionTrial, WhatIsNoTraceAndNoNetworkIsRefusedByName) {
  EXPECT_THAT(checkTrace(rows({{0.0, 1.0}})).error().text(), HasSubstr("1 rows"));
  EXPECT_THAT(checkTrace(rows({{0.0, 1.0}, {0.0, 2.0}})).error().text(), HasSubstr("row 2"));
  EXPECT_THAT(checkTrace(rows({{0.0, 1.0}, {kNaN, 2.0}})).error().text(), HasSubstr("row 2"));
  EXPECT_THAT(checkTrace(rows({{0.0, 1.0}, {0.1, 1.0 / 0.0}})).error().text(), HasSubstr("inf"));
  EXPECT_TRUE(checkTrace(rows({{0.0, 1.0}, {0.1, kNaN}})));
  EXPECT_EQ(checkTrace(rows({{0.0, kNaN}, {0.1, kNaN}, {0.2, kNaN}})).error().text(),
            "3 rows, none of them with a position; expected one and more");
  EXPECT_TRUE(checkTrace(rows({{0.0, 1e9}, {0.1, -1e9}})));
  for (const double far : {1.001e9, -1.001e9, 1e308, -1e308}) {
    EXPECT_THAT(checkTrace(rows({{0.0, 1.0}, {0.1, far}})).error().text(),
                testing::AllOf(HasSubstr("row 2: position"), HasSubstr("within ±1000000000, or NaN in a gap")))
        << far;
  }
  EXPECT_TRUE(checkTrace(rows({{-400.0, 1.0}, {86'000.0, 2.0}})));
  EXPECT_THAT(checkTrace(rows({{0.0, 1.0}, {6e7, 2.0}})).error().text(), HasSubstr("in seconds?"));
  EXPECT_FALSE(checkTrace(rows({{-1e308, 1.0}, {1e308, 2.0}})));  // further apart than any number
  Trace uneven = rows({{0.0, 1.0}, {0.1, 2.0}, {0.2, 3.0}});
  uneven.position_mm.pop_back();
  EXPECT_THAT(checkTrace(uneven).error().text(), HasSubstr("2 positions for 3 times"));
  for (const std::size_t axes : {std::size_t{0}, kMostAxes + 1}) {
    Trace other = rows({{0.0, 1.0}, {0.1, 2.0}});
    other.axes = axes;
    EXPECT_THAT(checkTrace(other).error().text(), HasSubstr("axes; expected 1 to 3"));
  }
  EXPECT_TRUE(checkLength(Trace(), kLongestTrace_s)) << "without a row it lasts no time";
  EXPECT_THAT(checkNetwork({.period_ms = -1.0}).error().text(), HasSubstr("period -1"));
  EXPECT_THAT(checkNetwork({.delay_ms = kNaN}).error().text(), HasSubstr("delay"));
  EXPECT_THAT(checkNetwork({.jitter_ms = 1e9}).error().text(), HasSubstr("jitter"));
  EXPECT_THAT(checkNetwork({.loss_percent = 101.0}).error().text(), HasSubstr("loss 101"));
}

TEST(SmoothOutput, ACorrectionDecaysAsACriticallyDampedSystemAndSteadyMotionDoesNotLag) {
  constexpr double kTau_s = 0.020;
  SmoothOutput smooth(kTau_s);
  double t = 0.0;
  for (int i = 0; i < 100; ++i, t += 0.001) EXPECT_NEAR(smooth.step(t, {30.0 * t}, {30.0})[0], 30.0 * t, 1e-9);
  const double from = t;
  double last = 30.0 * (t - 0.001);
  for (int i = 0; i < 200; ++i, t += 0.001) {  // from here on the prediction is 5 mm further
    const double x = smooth.step(t, {5.0 + 30.0 * t}, {30.0})[0];
    const double since = (t - (from - 0.001)) / kTau_s;
    EXPECT_NEAR(x - 30.0 * t, 5.0 - 5.0 * (1.0 + since) * std::exp(-since), 1e-6);
    EXPECT_LT(std::abs(x - last), 0.15);
    last = x;
  }
  EXPECT_NEAR(last, 5.0 + 30.0 * (t - 0.001), 0.01);
}

TEST(SmoothOutput, TheUsualTimeConstantGrowsWithThePeriodAndALittleWithTheDelay) {
  for (const double period_s : {0.0, 0.001, 0.010}) EXPECT_EQ(defaultSmoothing_s(period_s, 0.3), 0.015) << period_s;
  EXPECT_NEAR(defaultSmoothing_s(0.030, 0.0), 0.035, 1e-12);
  EXPECT_NEAR(defaultSmoothing_s(0.100, 0.0), 0.055, 1e-12);
  EXPECT_NEAR(defaultSmoothing_s(0.500, 0.100), 0.070, 1e-12);
  for (const double wrong : {std::nan(""), -1e9, 1e9, std::numeric_limits<double>::infinity()}) {
    EXPECT_GE(defaultSmoothing_s(0.5, wrong), 0.055) << wrong;
    EXPECT_LE(defaultSmoothing_s(0.5, wrong), 0.130) << wrong;
  }
}

TEST(SmoothOutput, NaNLeavesTheOutputWhereItWas) {
  SmoothOutput smooth(0.01);
  static_cast<void>(smooth.step(0.0, {1.0}, {}));
  EXPECT_EQ(smooth.step(0.001, {kNaN}, {})[0], 1.0);
  EXPECT_EQ(smooth.step(kNaN, {2.0}, {})[0], 1.0);
  EXPECT_EQ(smooth.step(0.002, {1.0}, {kNaN})[0], 1.0);
  EXPECT_EQ(smooth.step(0.003, {1.0}, {})[0], 1.0);
}

}  // namespace
}  // namespace fyd::teleop
