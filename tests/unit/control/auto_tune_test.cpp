// Auto-tune: excitation, identification of scale, delay and lag, proposed gains, prediction of the loop.
#include "core/control/auto_tune.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "core/control/static_law.h"
#include "tests/not_a_number.h"
#include "tests/processor_time.h"
#include "tests/sweep.h"
#include "tests/unit/control/bench_plant.h"

namespace fyd::control {
namespace {

std::vector<TuneSample> excite(double scale, double delay_s, double lag_s, double noise, double rate_Hz = 200) {
  const ControlParameters parameters;
  BenchPlant plant;
  plant.scale = scale;
  plant.delay_s = delay_s;
  plant.lag_s = lag_s;
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::vector<TuneSample> recording;
  const int every = static_cast<int>(1000 / rate_Hz);
  for (int i = 0; i < 12000; ++i) {
    const double time_s = 0.001 * i;
    const double measured = plant.read(0).measured_N_per_mm;
    if (i % every == 0) recording.push_back({time_s, plant.angle_deg, measured * (1 + noise * normal(random))});
    plant.move(excitationAngle_deg(time_s, parameters));
  }
  return recording;
}

TEST(Excitation, StaysInTheMiddleOfTheTravelAndSlow) {
  const ControlParameters parameters;
  double last = excitationAngle_deg(0, parameters);
  for (const double t : stepsBefore(0, 2 * kExcitation_s, 0.001)) {
    const double angle = excitationAngle_deg(t, parameters);
    EXPECT_GE(angle, 20 + 0.25 * 70 - 1e-9);
    EXPECT_LE(angle, 20 + 0.75 * 70 + 1e-9);
    EXPECT_LE(std::abs(angle - last), 0.0601) << t;
    last = angle;
  }
  EXPECT_TRUE(std::isfinite(excitationAngle_deg(kNaN, parameters)));
}

TEST(Excitation, SlowMotorsClimbLowerStairsAndNeverJump) {
  for (const double rate : {1.0, 20.0, 52.0}) {
    ControlParameters parameters;
    parameters.rate_limit_deg_per_s = rate;
    double last = excitationAngle_deg(0, parameters);
    for (const double t : stepsBefore(0, 2 * kExcitation_s, 0.001)) {
      const double angle = excitationAngle_deg(t, parameters);
      ASSERT_LE(std::abs(angle - last), rate / 3 * 0.001 + 1e-6) << rate << " at " << t;
      last = angle;
    }
  }
}

TEST(Excitation, NeverLeavesATravelThatTheLawDoesNotReach) {
  ControlParameters parameters;
  for (const auto& [from, to] : {std::pair{0.0, 15.0}, {100.0, 120.0}}) {
    parameters.travel_minimum_deg = from;
    parameters.travel_maximum_deg = to;
    for (const double t : stepsBefore(0, kExcitation_s, 0.1)) {
      EXPECT_GE(excitationAngle_deg(t, parameters), from) << t;
      EXPECT_LE(excitationAngle_deg(t, parameters), to) << t;
    }
  }
}

/// The processor's time for a recording whose measurement drifts all the while.
double identificationOf_s(std::size_t samples) {
  const ControlParameters parameters;
  const StaticLaw law(parameters);
  std::vector<TuneSample> recording;
  for (std::size_t i = 0; i < samples; ++i) {
    const double time_s = 0.0101 * static_cast<double>(i), angle = excitationAngle_deg(time_s, parameters);
    const double drift = 0.04 * static_cast<double>(i) / static_cast<double>(samples);
    recording.push_back({time_s, angle, law.stiffness_N_per_mm(angle).value * (1 + drift)});
  }
  const double before_s = processorTime_s();
  const auto cloth = identifyCloth(recording, parameters);
  const double took_s = processorTime_s() - before_s;
  EXPECT_TRUE(cloth) << cloth.error().text();
  EXPECT_EQ(cloth ? cloth->noise_correlation_s : 0.0, 2.0) << "the longest that counts";
  return took_s;
}

TEST(AutoTune, TakesTimeInProportionToTheRecording) {
  // The least of two runs each, as a busy machine lengthens any; in proportion to the length's square it were 64 times.
  const double brief_s = std::min(identificationOf_s(10'000), identificationOf_s(10'000));
  const double long_s = std::min(identificationOf_s(80'000), identificationOf_s(80'000));
  EXPECT_LT(long_s, 16 * brief_s) << "eight times as long";
}

TEST(AutoTune, FindsScaleDelayAndLag) {
  const auto cloth = identifyCloth(excite(1.2, 0.08, 0.3, 0.0), {});
  ASSERT_TRUE(cloth) << cloth.error().text();
  EXPECT_NEAR(cloth->scale, 1.2, 0.02);
  EXPECT_NEAR(cloth->shape_gain, 1.0, 0.03);
  EXPECT_NEAR(cloth->delay_s, 0.08, 0.02);
  EXPECT_NEAR(cloth->lag_s, 0.3, 0.03);
  EXPECT_LT(cloth->residual_rms_relative, 0.01);
}

TEST(AutoTune, FindsThemThroughNoise) {
  const auto cloth = identifyCloth(excite(0.75, 0.05, 0.2, 0.05), {});
  ASSERT_TRUE(cloth) << cloth.error().text();
  EXPECT_NEAR(cloth->scale, 0.75, 0.03);
  EXPECT_NEAR(cloth->shape_gain, 1.0, 0.1);
  EXPECT_NEAR(cloth->delay_s + cloth->lag_s, 0.25, 0.08);
  EXPECT_NEAR(cloth->residual_rms_relative, 0.05, 0.01);
}

TEST(AutoTune, ProposesGainsThatKeepTheirMarginsAndSettle) {
  const auto proposal = proposeGains(excite(1.1, 0.05, 0.2, 0.03), {});
  ASSERT_TRUE(proposal) << proposal.error().text();
  EXPECT_TRUE(proposal->after.stable());
  EXPECT_GE(proposal->after.margins.gain_margin, 2.0);
  EXPECT_GE(proposal->after.margins.phase_margin_deg, 60.0);
  EXPECT_LE(proposal->after.settling_s, 3.0);
  EXPECT_LE(proposal->after.overshoot_percent, 10.0);
  EXPECT_NEAR(proposal->proposed.measurement_delay_s + proposal->proposed.measurement_lag_s, 0.25, 0.1);
}

TEST(AutoTune, FindsHowLongTheNoiseRepeatsItself) {
  auto recording = excite(1.0, 0.05, 0.1, 0.0);
  // First-order noise of 4 % with a time constant of 0.3 s.
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const double keep = std::exp(-0.005 / 0.3);
  double noise = 0.0;
  for (TuneSample& sample : recording) {
    noise = keep * noise + 0.04 * std::sqrt(1 - keep * keep) * normal(random);
    sample.stiffness_N_per_mm *= std::exp(noise);
  }
  const auto cloth = identifyCloth(recording, {});
  ASSERT_TRUE(cloth) << cloth.error().text();
  EXPECT_GT(cloth->noise_correlation_s, 0.12);
  EXPECT_LT(cloth->noise_correlation_s, 0.5);
  EXPECT_NEAR(identifyCloth(excite(1, 0.05, 0.1, 0.04), {})->noise_correlation_s, 0.02, 0.01) << "white noise";
}

TEST(AutoTune, LateSensorsGetSlowerGains) {
  const auto quick = proposeGains(excite(1.0, 0.02, 0.02, 0.01), {});
  const auto late = proposeGains(excite(1.0, 0.35, 1.0, 0.01), {});
  ASSERT_TRUE(quick && late);
  EXPECT_LE(late->proposed.ki_per_s, quick->proposed.ki_per_s);
}

TEST(AutoTune, SaysWhatTheRecordingLacks) {
  const auto problem = [](std::vector<TuneSample> recording) {
    const auto proposal = proposeGains(recording, {});
    return proposal ? std::string("none") : proposal.error().text();
  };
  const auto good = excite(1, 0.05, 0.1, 0.02);
  EXPECT_EQ(problem(good), "none");
  EXPECT_THAT(problem({}), testing::HasSubstr("0 samples"));
  auto blind = good;
  for (TuneSample& sample : blind) sample.stiffness_N_per_mm = kNaN;
  EXPECT_THAT(problem(blind), testing::HasSubstr("observable in 0 samples"));
  auto backwards = good;
  backwards[500].time_s = 1.0;
  EXPECT_THAT(problem(backwards), testing::HasSubstr("time to rise"));
  auto still = good;
  for (TuneSample& sample : still) sample.angle_deg = 40;
  EXPECT_THAT(problem(still), testing::HasSubstr("moves the law by 0.0 %"));
  auto unrelated = good;
  for (std::size_t i = 0; i < unrelated.size(); ++i) unrelated[i].stiffness_N_per_mm = i % 2 == 0 ? 0.4 : 0.8;
  EXPECT_THAT(problem(unrelated), testing::HasSubstr("explains"));
  auto text = good;
  text[3].angle_deg = kNaN;
  EXPECT_THAT(problem(text), testing::HasSubstr("expected numbers"));
}

TEST(LoopPrediction, MarginsOfAKnownLoop) {
  // The measurement is as modelled: L = ki/s·e^(−Ta·s)/(0.015 s + 1)², Ta = 1 ms. With ki = 10: |L| = 1 at
  // ω·(1 + (0.015ω)²) = 10, ω = 9.789; phase margin 90° − 2·atan(0.14683) − 0.561° = 72.73°. The phase is −180° where
  // 2·atan(0.015ω) + 0.001ω = 90°, ω = 62.55; gain margin 62.55·(1 + 0.8803)/10 = 11.76.
  ControlParameters parameters;
  parameters.kp = parameters.kd_s = 0;
  parameters.ki_per_s = 10;
  parameters.measurement_delay_s = parameters.measurement_lag_s = 0;
  const LoopMargins margins = loopMargins({}, parameters, {.motors_age_s = 0.0});
  EXPECT_NEAR(margins.phase_margin_deg, 72.73, 0.5);
  EXPECT_NEAR(margins.gain_margin, 11.76, 0.2);
}

TEST(LoopPrediction, WithAnyGainTheGainMarginIsFiniteAndDeadTimeCostsIt) {
  for (double ControlParameters::*gain :
       {&ControlParameters::kp, &ControlParameters::ki_per_s, &ControlParameters::kd_s, &ControlParameters::thesis_kp,
        &ControlParameters::thesis_ki, &ControlParameters::thesis_kd}) {
    ControlParameters parameters;
    parameters.kp = parameters.ki_per_s = parameters.thesis_kp = parameters.thesis_ki = 0;
    const bool thesis = gain == &ControlParameters::thesis_kp || gain == &ControlParameters::thesis_ki ||
                        gain == &ControlParameters::thesis_kd;
    parameters.mode = thesis ? ControlMode::thesis : ControlMode::normal;
    double last = std::numeric_limits<double>::infinity();
    for (const double age_s : {0.0, 0.002, 0.01, 0.05}) {
      parameters.*gain = 1e-3;
      const LoopMargins margins = loopMargins(assumedCloth(parameters), parameters, {.motors_age_s = age_s});
      EXPECT_LT(margins.gain_margin, last) << age_s;
      last = margins.gain_margin;
    }
  }
}

TEST(LoopPrediction, TheRangesOfTheGainsEndWhereNoLoopIsSteady) {
  ControlParameters parameters;
  for (const Parameter& parameter : bindParameters(parameters)) {
    const bool thesis = parameter.id.starts_with("control.thesis_k");
    if (!thesis && parameter.id != "control.kp" && parameter.id != "control.ki" && parameter.id != "control.kd")
      continue;
    const auto verdictAt = [&](double share) {
      parameters.kp = parameters.ki_per_s = parameters.kd_s = 0;
      parameters.thesis_kp = parameters.thesis_ki = parameters.thesis_kd = 0;
      parameters.mode = thesis ? ControlMode::thesis : ControlMode::normal;
      parameter.set(share * parameter.info.maximum);
      return predictLoop(assumedCloth(parameters), parameters, {.motors_age_s = 0.0}).verdict;
    };
    EXPECT_EQ(verdictAt(1.0), LoopVerdict::unstable) << parameter.id;
    EXPECT_NE(verdictAt(0.1), LoopVerdict::unstable) << parameter.id;
  }
}

TEST(LoopPrediction, LateMotorsMakeASteadyLoopSwing) {
  ControlParameters parameters;
  parameters.kp = 4;
  const IdentifiedCloth cloth = assumedCloth(parameters);
  EXPECT_EQ(predictLoop(cloth, parameters, {.motors_age_s = 0.0}).verdict, LoopVerdict::settles);
  EXPECT_EQ(predictLoop(cloth, parameters, {.motors_age_s = 0.02}).verdict, LoopVerdict::unstable);
}

TEST(LoopPrediction, ASmallCorrectionLimitIsNoWeakLoop) {
  // The predicted cloth is 30 % softer than its law on purpose.
  ControlParameters parameters;
  const IdentifiedCloth cloth = assumedCloth(parameters);
  const LoopPrediction usual = predictLoop(cloth, parameters, {.motors_age_s = 0.0});
  parameters.correction_limit = 0.2;
  const LoopPrediction limited = predictLoop(cloth, parameters, {.motors_age_s = 0.0});
  EXPECT_EQ(limited.verdict, usual.verdict);
  EXPECT_DOUBLE_EQ(limited.settling_s, usual.settling_s);
}

TEST(LoopPrediction, TheMotorsSpeedLimitCountsBesideTheMargins) {
  ControlParameters parameters;
  parameters.kp = 15;
  const LoopPrediction loop = predictLoop(assumedCloth(parameters), parameters, {.motors_age_s = 0.0});
  EXPECT_GT(loop.margins.gain_margin, 1.5);
  EXPECT_GT(loop.margins.phase_margin_deg, 5.0);
  EXPECT_EQ(loop.verdict, LoopVerdict::unstable);
}

TEST(LoopPrediction, UnmodelledDeadTimeCostsMargin) {
  ControlParameters parameters;
  parameters.measurement_delay_s = 0;
  parameters.measurement_lag_s = 0;
  parameters.noise_correlation_s = 0.05;  // an observer that believes quickly
  IdentifiedCloth late;
  late.delay_s = 0.3;
  EXPECT_LT(loopMargins(late, parameters).phase_margin_deg, loopMargins({}, parameters).phase_margin_deg);
}

TEST(LoopPrediction, NoGainsIsNoLoop) {
  ControlParameters parameters;
  parameters.kp = parameters.ki_per_s = parameters.kd_s = 0;
  EXPECT_TRUE(std::isinf(loopMargins({}, parameters).gain_margin));
}

TEST(LoopPrediction, CourseAndFiguresAreOfOneRun) {
  const ControlParameters parameters;
  const IdentifiedCloth assumed = assumedCloth(parameters);
  EXPECT_EQ(assumed.delay_s, parameters.measurement_delay_s);
  EXPECT_EQ(assumed.lag_s, parameters.measurement_lag_s);
  std::vector<LoopPoint> course;
  const LoopPrediction loop = predictLoop(assumed, parameters, {}, &course);
  ASSERT_EQ(course.size(), 1001u);  // 10 s by 10 ms
  EXPECT_TRUE(loop.stable());
  EXPECT_GT(loop.rise_s, 0.0);
  EXPECT_LT(loop.rise_s, loop.settling_s + 1.0);
  EXPECT_LT(loop.steady_error_percent, 2.0);
  double highest = 0.0;
  for (const LoopPoint& point : course) {
    highest = std::max(highest, 100 * (point.relative - 1));
    if (point.time_s <= loop.settling_s + 0.01) continue;
    EXPECT_NEAR(point.relative, 1.0, 0.05) << point.time_s;
  }
  EXPECT_NEAR(highest, loop.overshoot_percent, 0.5);
}

TEST(LoopPrediction, WithoutGainsTheCourseStaysOff) {
  ControlParameters parameters;
  parameters.kp = parameters.ki_per_s = parameters.kd_s = 0;
  const LoopPrediction loop = predictLoop(assumedCloth(parameters), parameters);
  EXPECT_TRUE(std::isnan(loop.settling_s));
  EXPECT_TRUE(std::isnan(loop.rise_s));
  EXPECT_FALSE(loop.stable());
  EXPECT_GT(loop.steady_error_percent, 5.0);
}

TEST(AutoTune, TellsHowFarItIsAndEndsWhenAsked) {
  const auto recording = excite(1.1, 0.05, 0.2, 0.03);
  std::vector<double> told;
  const auto proposal = proposeGains(recording, {}, [&](double done) {
    told.push_back(done);
    return true;
  });
  ASSERT_TRUE(proposal);
  ASSERT_GE(told.size(), 2u);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.front(), 0.0);
  EXPECT_LE(told.back(), 1.0);
  int asked = 0;
  const auto ended = proposeGains(recording, {}, [&](double) { return ++asked < 2; });
  ASSERT_FALSE(ended);
  EXPECT_EQ(asked, 2);
  EXPECT_THAT(ended.error().text(), testing::HasSubstr("cancelled"));
}

}  // namespace
}  // namespace fyd::control
