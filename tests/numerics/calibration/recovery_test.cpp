// The fits recover what made the data, within the uncertainty they state, and hold out what they say they hold out.
#include <cmath>
#include <numeric>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/calibration/camera_calibration.h"
#include "core/calibration/fit/cross_validation.h"
#include "core/calibration/fit/least_squares.h"
#include "core/calibration/fit/outliers.h"
#include "core/calibration/fit/polynomial_basis.h"
#include "core/calibration/fit/student_quantile.h"
#include "core/calibration/ir_calibration.h"
#include "core/calibration/load_cell_calibration.h"
#include "core/calibration/stiffness_map.h"
#include "core/control/static_law.h"
#include "core/sensing/finger_detector.h"
#include "core/sensing/sensing_parameters.h"
#include "tests/processor_time.h"
#include "tests/sweep.h"

namespace fyd::calibration {
namespace {

const CalibrationParameters kStandard;
const sensing::IndentationParameters kPresent;
const std::vector<double> kDistances = {41, 50, 60, 70, 80, 90, 100, 120, 140, 160, 180, 200, 225, 250, 275, 299};

double codeOf(double volts) { return volts * 4096 / 3.3; }

template <class Curve>
IrSamples readingsOf(Curve&& volts, const std::vector<double>& distances, int repeats, double noise_V, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, 1);
  IrSamples samples;
  for (const double d : distances) {
    for (int i = 0; i < repeats; ++i) {
      samples.adc.push_back(codeOf(volts(d) + noise_V * noise(random)));
      samples.distance_mm.push_back(d);
    }
  }
  return samples;
}

TEST(LeastSquares, StatedErrorsHoldTheTruthAsOftenAsTheySay) {
  // 95 % intervals of both coefficients of a line, 2000 seeded trials: expected 1900, standard deviation 9.7.
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 0.3);
  int held[2] = {0, 0};
  constexpr int kTrials = 2000, kPoints = 9;
  for (int trial = 0; trial < kTrials; ++trial) {
    Eigen::MatrixXd design(kPoints, 2);
    Eigen::VectorXd y(kPoints);
    for (int i = 0; i < kPoints; ++i) {
      design.row(i) << i, 1.0;
      y[i] = 2.5 * i - 4.0 + noise(random);
    }
    const auto fit = fitLinear(design, y);
    ASSERT_TRUE(fit.has_value());
    const double t = studentQuantile(0.95, fit->degrees_of_freedom);
    held[0] += std::abs(fit->coefficients[0] - 2.5) <= t * fit->standardError(0);
    held[1] += std::abs(fit->coefficients[1] + 4.0) <= t * fit->standardError(1);
  }
  for (const int count : held) EXPECT_NEAR(count, 0.95 * kTrials, 45);
}

TEST(LeastSquares, RefusesWhatCannotBeSolved) {
  Eigen::MatrixXd same(4, 2);
  same << 1, 2, 2, 4, 3, 6, 4, 8;
  EXPECT_FALSE(fitLinear(same, Eigen::VectorXd::Ones(4)).has_value());
  EXPECT_FALSE(fitLinear(Eigen::MatrixXd::Ones(1, 2), Eigen::VectorXd::Ones(1)).has_value());
  EXPECT_FALSE(fitLinear(Eigen::MatrixXd::Zero(4, 1), Eigen::VectorXd::Ones(4)).has_value());
  Eigen::VectorXd nan = Eigen::VectorXd::Ones(4);
  nan[2] = std::nan("");
  EXPECT_FALSE(fitLinear(Eigen::MatrixXd::Ones(4, 1), nan).has_value());
}

TEST(PolynomialBasis, KeepsItsDigitsWherePowersLoseThem) {
  // A quintic in codes clustered at 3000…3100: powers of raw codes have a condition number beyond double's digits.
  std::vector<double> codes;
  for (int i = 0; i <= 50; ++i) codes.push_back(3000 + 2 * i);
  const PolynomialBasis basis(codes, 5);
  Eigen::VectorXd y(51);
  for (int i = 0; i < 51; ++i) {
    const double t = (codes[static_cast<std::size_t>(i)] - 3050) / 50;
    y[i] = 100 - 20 * t + 3 * t * t - t * t * t * t * t;
  }
  const auto fit = fitLinear(basis.design(codes), y);
  ASSERT_TRUE(fit.has_value());
  EXPECT_LT(fit->condition_number, 10);
  EXPECT_LT(fit->max_residual, 1e-11);
  Eigen::MatrixXd raw(51, 6);
  for (int i = 0; i < 51; ++i) {
    for (int j = 0; j < 6; ++j) raw(i, j) = std::pow(codes[static_cast<std::size_t>(i)], j);
  }
  EXPECT_FALSE(fitLinear(raw, y).has_value());  // refused, not silently wrong
}

TEST(PolynomialBasis, PowersSayTheSameCurve) {
  const std::vector<double> x = {0.4, 0.9, 1.7, 2.2, 2.75};
  const PolynomialBasis basis(x, 4);
  const Eigen::VectorXd c = (Eigen::VectorXd(5) << 1, -2, 0.5, 3, -0.25).finished();
  const Eigen::VectorXd powers = basis.toPowers() * c;
  const Eigen::VectorXd direct = basis.design(x) * c;
  for (int i = 0; i < 5; ++i) {
    double sum = 0;
    for (int j = 4; j >= 0; --j) sum = sum * x[static_cast<std::size_t>(i)] + powers[j];
    EXPECT_NEAR(sum, direct[i], 1e-11);
  }
}

TEST(Outliers, AreFoundWhenTheyHideEachOther) {
  std::mt19937_64 random(11);
  std::normal_distribution<double> noise(0, 0.02);
  Eigen::MatrixXd design(24, 2);
  Eigen::VectorXd y(24);
  for (int i = 0; i < 24; ++i) {
    design.row(i) << 0.1 * i, 1.0;
    y[i] = 9.8 * 0.1 * i + noise(random);
  }
  for (const int bad : {21, 22, 23}) y[bad] -= 3.0;  // all at one end: they pull the line to themselves
  EXPECT_EQ(findOutliers(design, y, {}), (std::vector<std::size_t>{21, 22, 23}));
}

TEST(Outliers, GoodPointsAreSeldomAccused) {
  int accused = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0, 0.1);
    Eigen::MatrixXd design(15, 2);
    Eigen::VectorXd y(15);
    for (int i = 0; i < 15; ++i) {
      design.row(i) << i, 1.0;
      y[i] = i + noise(random);
    }
    accused += findOutliers(design, y, {}).empty() ? 0 : 1;
  }
  EXPECT_LE(accused, 15);  // 1 % is meant; the search for the best half costs some
}

TEST(Outliers, ExactDataHasNoneButTheOneThatIs) {
  Eigen::MatrixXd design(8, 2);
  Eigen::VectorXd y(8);
  for (int i = 0; i < 8; ++i) {
    design.row(i) << i, 1.0;
    y[i] = 3.0 * i + 1.0;
  }
  EXPECT_TRUE(findOutliers(design, y, {}).empty());
  y[3] += 0.5;
  EXPECT_EQ(findOutliers(design, y, {}), std::vector<std::size_t>{3});
}

/// A stiffness map's rows: presses at four angles, `at_the_last` of them at the last one.
struct ManyRows {
  Eigen::MatrixXd design;
  Eigen::VectorXd force;
};
ManyRows manyRows(Eigen::Index rows, Eigen::Index at_the_last, const std::vector<std::size_t>& outliers) {
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0, 0.05);
  ManyRows out{Eigen::MatrixXd::Zero(rows, 5), Eigen::VectorXd(rows)};
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Eigen::Index angle = i >= rows - at_the_last ? 3 : i % 3;
    const double depth_mm = 1.0 + static_cast<double>(i % 7);
    out.design(i, angle) = depth_mm;
    out.design(i, 4) = 1.0;
    out.force[i] = (0.4 + 0.1 * static_cast<double>(angle)) * depth_mm + 0.2 + noise(random);
  }
  for (const std::size_t row : outliers) out.force[static_cast<Eigen::Index>(row)] += 1.0;
  return out;
}

TEST(Outliers, AFewAreFoundAmongManyRows) {
  const std::vector<std::size_t> planted = {5, 4000, 9001, 19'998};
  const ManyRows rare = manyRows(20'000, 4, planted), even = manyRows(20'000, 5000, planted);
  double start_s = processorTime_s();
  EXPECT_EQ(findOutliers(even.design, even.force, {}), planted);
  const double even_s = processorTime_s() - start_s;
  start_s = processorTime_s();
  EXPECT_EQ(findOutliers(rare.design, rare.force, {}), planted);
  EXPECT_LT(processorTime_s() - start_s, 5.0 * even_s) << "an angle of few presses must not cost a fit for each row";
}

TEST(IrCalibration, RecoversTheThesisPolynomialFromItsOwnPoints) {
  const sensing::IrDistance thesis;
  const auto found =
      calibrateIr(readingsOf([&](double d) { return thesis.voltsAt(d); }, kDistances, 1, 0, 1), kPresent, kStandard);
  ASSERT_TRUE(found.result.verdict.accepted) << found.result.verdict.reason.text();
  EXPECT_TRUE(found.result.outliers.empty());
  EXPECT_LT(found.result.max_residual, 1e-6) << found.result.curve.text();
  const auto fitted = found.curve.sensor(0, 4095);
  for (const double d : stepsBefore(45, 295, 5)) EXPECT_NEAR(fitted.distance_mm(thesis.voltsAt(d)), d, 1e-5);
  // and the degree-5 candidate itself finds the six printed figures
  const auto samples = readingsOf([&](double d) { return thesis.voltsAt(d); }, kDistances, 1, 0, 1);
  const auto quintic = fitIrCurve(IrCandidate::degree5, irPoints(samples.adc, samples.distance_mm, 10));
  ASSERT_TRUE(quintic.has_value());
  const std::array printed = {790.712, -1885.623, 2208.604, -1338.297, 399.54, -46.327};
  for (std::size_t i = 0; i < printed.size(); ++i)
    EXPECT_NEAR(quintic->coefficients[i], printed[i], 1e-5 * std::abs(printed[i]));
}

TEST(IrCalibration, RecoversAnInverseCurveWithinItsUncertainty) {
  int held = 0;
  constexpr int kTrials = 60;
  for (unsigned seed = 0; seed < kTrials; ++seed) {
    const auto samples = readingsOf([](double d) { return 130.0 / (d + 6.0) - 0.05; }, kDistances, 4, 0.004, seed);
    const auto curve = fitIrCurve(IrCandidate::inverse, irPoints(samples.adc, samples.distance_mm, 4));
    ASSERT_TRUE(curve.has_value()) << curve.error().text();
    held += std::abs(curve->coefficients[0] - 130) <= 2 * curve->standard_errors[0];
  }
  EXPECT_GE(held, 50);  // 95 % of 60 is 57
}

TEST(IrCalibration, TheSimplestGoodCurveIsChosenAndHeldOutErrorIsReallyHeldOut) {
  // An inverse sensor, few noisy points: the quintic comes nearer to its points and farther from the sensor.
  int overfitted = 0, inverse_chosen = 0;
  for (unsigned seed = 0; seed < 12; ++seed) {
    const auto samples = readingsOf([](double d) { return 130.0 / (d + 6.0) - 0.05; },
                                    {40, 55, 75, 100, 130, 170, 220, 300}, 1, 0.012, seed);
    sensing::IndentationParameters present;
    present.ir_noise_mV = 12;
    const auto found = calibrateIr(samples, present, kStandard);
    const auto attempt = [&](IrCandidate c) { return found.attempts[static_cast<std::size_t>(c)]; };
    const IrAttempt simple = attempt(IrCandidate::inverse), wild = attempt(IrCandidate::degree5);
    overfitted += wild.held_out_rmse_mm > 1.5 * simple.held_out_rmse_mm && wild.held_out_rmse_mm > 2 * wild.rmse_mm;
    inverse_chosen += found.curve.candidate != IrCandidate::degree5;
  }
  EXPECT_GE(overfitted, 8);
  EXPECT_GE(inverse_chosen, 11);
}

TEST(IrCalibration, AStrayPointIsFoundKeptAndLeftOutOnlyWhenSaid) {
  const sensing::IrDistance thesis;
  IrSamples samples = readingsOf([&](double d) { return thesis.voltsAt(d); }, kDistances, 2, 0.005, 3);
  samples.distance_mm[12] += 45;  // 100 mm written down as 145
  const auto kept = calibrateIr(samples, kPresent, kStandard);
  EXPECT_EQ(kept.result.outliers, std::vector<std::size_t>{12});
  EXPECT_FALSE(kept.result.verdict.accepted);
  const auto without = calibrateIr(samples, kPresent, kStandard, {.without_outliers = true});
  EXPECT_TRUE(without.result.verdict.accepted) << without.result.verdict.reason.text();
  EXPECT_EQ(without.result.outliers, std::vector<std::size_t>{12});
  EXPECT_GT(std::abs(without.result.residuals[12]), 35);
}

TEST(IrCalibration, WhatTheProfileGetsIsWhatTheStepReads) {
  // A unit 15 mm off at 100 mm. The changes go into a profile; the estimator with that profile reads the truth.
  const auto volts = [](double d) { return 150.0 / (d + 10.0) - 0.02; };
  const auto found = calibrateIr(readingsOf(volts, kDistances, 8, 0.005, 5), kPresent, kStandard, {.sensor = 1});
  ASSERT_TRUE(found.result.verdict.accepted) << found.result.verdict.reason.text();
  sensing::SensingParameters profile;
  ASSERT_TRUE(applyChanges(bindParameters(profile), found.result.changes).has_value());
  const auto& p = profile.indentation;
  EXPECT_EQ(p.ir_lowest_code[0], 524);  // the other sensors keep theirs
  const sensing::IrDistance sensor(p.ir_curve_mm[1].view(), static_cast<int>(p.ir_lowest_code[1]),
                                   static_cast<int>(p.ir_highest_code[1]), p.ir_curve_form[1]);
  for (const double d : {60.0, 80.0, 100.0, 130.0}) {
    const auto reading = sensor.read(static_cast<std::uint16_t>(std::lround(codeOf(volts(d)))));
    ASSERT_TRUE(reading.valid) << d;
    EXPECT_NEAR(reading.distance_mm, d, 0.7);
    EXPECT_GT(std::abs(sensing::IrDistance().distance_mm(volts(d)) - d), 2) << "the default would not do";
  }
  EXPECT_TRUE(fallsAtEveryCode(found.curve, static_cast<int>(found.result.valid_from),
                               static_cast<int>(found.result.valid_to)));
}

TEST(IrCalibration, AWavyCurveIsNotUsed) {
  IrCurve wavy{.candidate = IrCandidate::degree3, .coefficients = {300, -300, 150, -24}, .standard_errors = {}};
  EXPECT_TRUE(fallsAtEveryCode(wavy, 524, 1500));
  EXPECT_FALSE(fallsAtEveryCode(
      {.candidate = IrCandidate::degree2, .coefficients = {300, -200, 50}, .standard_errors = {}}, 524, 3408));
  EXPECT_FALSE(
      fallsAtEveryCode({.candidate = IrCandidate::degree2, .coefficients = {10, -20}, .standard_errors = {}}, 0, 3408));
}

TEST(LoadCell, RecoversTheThesisFormula) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> noise(0, 0.0005);  // mV/V
  LoadCellSamples samples;
  for (const int g : {0, 100, 200, 300, 400, 500, 600, 700, 600, 500, 400, 300, 200, 100, 0}) {
    samples.force_N.push_back(g / 1000.0 * 9.80665);
    samples.value_mV_per_V.push_back((g + 20.2512) / 1004.8805 + noise(random));
  }
  const auto found = calibrateLoadCell(samples, kStandard);
  ASSERT_TRUE(found.result.verdict.accepted) << found.result.verdict.reason.text();
  const auto& [slope, offset] = std::tie(found.result.coefficients[0], found.result.coefficients[1]);
  EXPECT_NEAR(slope.value, 1.0048805 * 9.80665, 3 * slope.standard_error);
  EXPECT_NEAR(offset.value, -0.0202512 * 9.80665, 3 * offset.standard_error);
  EXPECT_LT(slope.standard_error, 0.02);
  sensing::LoadCellParameters profile;
  ASSERT_TRUE(applyChanges(bindParameters(profile), found.result.changes).has_value());
  EXPECT_NEAR(sensing::LoadCell(profile).force_N(0.8), 7.685, 0.01);
  EXPECT_NEAR(sensing::LoadCell(profile).force_N(0.0), -0.199, 0.01);
}

TEST(LoadCell, OutliersAreFlaggedAndKept) {
  LoadCellSamples samples;
  for (int i = 0; i < 12; ++i) {
    samples.value_mV_per_V.push_back(0.06 * i);
    samples.force_N.push_back(9.8 * 0.06 * i - 0.2 + 0.002 * ((i * 7) % 5 - 2));
  }
  samples.force_N[9] += 0.2;
  const auto found = calibrateLoadCell(samples, kStandard);
  EXPECT_EQ(found.result.outliers, std::vector<std::size_t>{9});
  // the line over all twelve, by the textbook's sums
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < 12; ++i) {
    sx += samples.value_mV_per_V[i];
    sy += samples.force_N[i];
    sxx += samples.value_mV_per_V[i] * samples.value_mV_per_V[i];
    sxy += samples.value_mV_per_V[i] * samples.force_N[i];
  }
  EXPECT_NEAR(found.result.coefficients[0].value, (12 * sxy - sx * sy) / (12 * sxx - sx * sx), 1e-9);
}

TEST(LoadCell, AHugeOffsetCostsNoDigits) {
  LoadCellSamples samples;
  for (int i = 0; i < 10; ++i) {
    samples.value_mV_per_V.push_back(900.0 + 0.01 * i);
    samples.force_N.push_back(98.0 * 0.01 * i);
  }
  const auto found = calibrateLoadCell(samples, kStandard);
  EXPECT_NEAR(found.result.coefficients[0].value, 98.0, 1e-6);
  EXPECT_LT(found.result.condition_number, 10);
}

TEST(LoadCell, DriftAndHysteresisAreToldApart) {
  const auto cell = [](double hysteresis_N, double drift_N) {
    LoadCellSamples samples;
    int i = 0;
    for (const double f :
         {0., 1., 2., 3., 4., 5., 6., 5., 4., 3., 2., 1., 0., 1., 2., 3., 4., 5., 6., 5., 4., 3., 2., 1., 0.}) {
      const bool unloading = (i > 6 && i <= 12) || i > 18;
      samples.force_N.push_back(f);
      samples.value_mV_per_V.push_back((f - (unloading ? hysteresis_N : 0) * (f > 0 && f < 6) - drift_N * i / 24.0) /
                                       9.85);
      ++i;
    }
    return calibrateLoadCell(samples, kStandard);
  };
  EXPECT_NEAR(cell(0.15, 0).hysteresis_N, -0.15, 0.04);
  EXPECT_NEAR(cell(0, 0.2).drift_N, 0.2, 0.03);
  EXPECT_NEAR(cell(0, 0).drift_N, 0, 1e-9);
  EXPECT_NEAR(cell(0, 0).hysteresis_N, 0, 1e-9);
  EXPECT_FALSE(cell(0.15, 0).result.notes.empty());
  LoadCellSamples once;  // loaded once, upward: order and force are one and the same
  for (int i = 0; i < 8; ++i) {
    once.force_N.push_back(i);
    once.value_mV_per_V.push_back(0.1 * i);
  }
  EXPECT_TRUE(std::isnan(calibrateLoadCell(once, kStandard).drift_N));
}

struct Press {
  double angle_deg, depth_mm, force_N;
};

/// Every angle pressed to each of five depths, in turn; 0.4 N/mm at the first, 0.03 N/mm more at each further.
std::vector<Press> pressedInTurn(int angles) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, 0.02);
  std::vector<Press> out;
  for (const double depth : stepsTo(2, 10, 2)) {
    for (int a = 0; a < angles; ++a) {
      const double k = 0.4 + 0.03 * a;
      out.push_back({20.0 + 7.0 * a, depth, k * depth + noise(random)});
    }
  }
  return out;
}

StiffnessMap mapOf(const std::vector<Press>& presses) {
  StiffnessSamples samples;
  for (const Press& press : presses) {
    samples.angle_deg.push_back(press.angle_deg);
    samples.indentation_mm.push_back(press.depth_mm);
    samples.force_N.push_back(press.force_N);
  }
  return calibrateStiffness(samples, kStandard);
}

TEST(StiffnessMap, APressThatTheOthersContradictIsNamedAmongManyAngles) {
  std::vector<Press> presses = pressedInTurn(12);
  EXPECT_TRUE(mapOf(presses).result.outliers.empty());
  constexpr std::size_t kBad = 31;
  presses[kBad].force_N += 3.0;
  const double bad_N = presses[kBad].force_N;
  EXPECT_EQ(mapOf(presses).result.outliers, std::vector<std::size_t>{kBad});
  std::ranges::stable_sort(presses, {}, &Press::angle_deg);
  const auto place = std::ranges::find(presses, bad_N, &Press::force_N) - presses.begin();
  EXPECT_EQ(mapOf(presses).result.outliers, std::vector<std::size_t>{static_cast<std::size_t>(place)});
}

TEST(StiffnessMap, OfAnglesPressedInTurnIsThatOfAnglesPressedOneAfterTheOther) {
  constexpr int kAngles = 10;
  const std::vector<Press> in_turn = pressedInTurn(kAngles);
  std::vector<Press> one_by_one = in_turn;
  std::ranges::stable_sort(one_by_one, {}, &Press::angle_deg);
  const auto turn = mapOf(in_turn);
  EXPECT_TRUE(turn.result.verdict.accepted) << turn.result.verdict.reason.text();
  EXPECT_NEAR(turn.result.held_out_rmse, mapOf(one_by_one).result.held_out_rmse, 1e-9);
  ASSERT_EQ(turn.angles.size(), std::size_t{kAngles});
  for (int a = 0; a < kAngles; ++a)
    EXPECT_NEAR(turn.angles[static_cast<std::size_t>(a)].stiffness_N_per_mm, 0.4 + 0.03 * a, 0.01);
}

TEST(StiffnessMap, RecoversTheThesisPointsWithAWrongTare) {
  constexpr std::array<std::pair<double, double>, 4> kThesis = {{{20, 0.501}, {45, 0.550}, {60, 0.673}, {90, 0.715}}};
  int held = 0;
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> noise(0, 0.03);
    StiffnessSamples samples;
    for (const auto& [angle, k] : kThesis) {
      for (const double depth : stepsTo(1, 10, 1)) {
        samples.angle_deg.push_back(angle + 0.2 * noise(random));
        samples.indentation_mm.push_back(depth);
        samples.force_N.push_back(k * depth + 0.15 + noise(random));
      }
    }
    const auto map = calibrateStiffness(samples, kStandard);
    ASSERT_TRUE(map.result.verdict.accepted) << map.result.verdict.reason.text();
    ASSERT_EQ(map.angles.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i)
      held += map.angles[i].low_95 <= kThesis[i].second && kThesis[i].second <= map.angles[i].high_95;
    EXPECT_NEAR(map.force_offset_N, 0.15, 4 * map.force_offset_error_N);
    control::ControlParameters control;
    ASSERT_TRUE(applyChanges(bindParameters(control), map.result.changes).has_value());
    const control::StaticLaw law(control);
    EXPECT_NEAR(law.angle_deg(0.673).value, 60, 5);
  }
  EXPECT_GE(held, 180);  // 95 % of 200 is 190
}

TEST(Camera, RecoversScalesTurnAndMirrorAsTheDetectorUsesThem) {
  std::mt19937_64 random(9);
  std::normal_distribution<double> noise(0, 0.03);
  for (const double turn : {0.0, 3.0, -12.0, 40.0, 179.0, -95.0}) {
    for (const bool mirror : {false, true}) {
      sensing::FingerParameters truth;
      truth.rotation_deg = turn;
      truth.mirror = mirror;
      truth.scale_x_mm_per_px = 0.44;
      truth.scale_y_mm_per_px = 0.48;
      truth.centre_x_px = 143;
      truth.centre_y_px = 117;
      CameraSamples samples;
      for (const double u : stepsTo(45, 255, 35)) {
        for (const double v : stepsTo(50, 190, 35)) {
          double x = 0, y = 0;
          toMillimetres(truth, u, v, x, y);
          samples.x_px.push_back(u);
          samples.y_px.push_back(v);
          samples.x_mm.push_back(x + noise(random));
          samples.y_mm.push_back(y + noise(random));
        }
      }
      const auto found = calibrateCamera(samples, kStandard);
      ASSERT_TRUE(found.result.verdict.accepted) << turn << found.result.verdict.reason.text();
      sensing::FingerParameters profile;
      ASSERT_TRUE(applyChanges(bindParameters(profile), found.result.changes).has_value());
      for (const auto& [u, v] : {std::pair{60.0, 60.0}, {240.0, 180.0}, {150.0, 120.0}}) {
        double x = 0, y = 0, fx = 0, fy = 0;
        toMillimetres(truth, u, v, x, y);
        toMillimetres(profile, u, v, fx, fy);
        EXPECT_NEAR(fx, x, 0.1) << turn << mirror;
        EXPECT_NEAR(fy, y, 0.1) << turn << mirror;
      }
      EXPECT_EQ(found.rotated, turn != 0.0);
      EXPECT_NEAR(found.shear_deg, 0, 0.2);
    }
  }
}

/// Marks as a pinhole camera sees them that stands under the touchpad's origin: focal length times x over the distance.
CameraSamples throughAPinhole(double height_mm, const std::vector<double>& depths_mm, double half_width_mm,
                              double noise_px, std::uint64_t seed) {
  const double focal_px = height_mm / 0.46;
  std::mt19937_64 random(seed);
  std::normal_distribution<double> noise(0, noise_px);
  CameraSamples out;
  for (const double depth : depths_mm) {
    for (const double x : {-half_width_mm, 0.0, half_width_mm}) {
      for (const double y : {-0.6 * half_width_mm, 0.0, 0.6 * half_width_mm}) {
        out.x_px.push_back(150 + focal_px * x / (height_mm - depth) + noise(random));
        out.y_px.push_back(120 - focal_px * y / (height_mm - depth) + noise(random));
        out.x_mm.push_back(x);
        out.y_mm.push_back(y);
        out.depth_mm.push_back(depth);
      }
    }
  }
  return out;
}

TEST(Camera, MarksThatArePressedDownTellItsHeight) {
  int within = 0, trials = 0;
  for (const double height_mm : {60.0, 100.0, 180.0}) {
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      const auto found = calibrateCamera(throughAPinhole(height_mm, {0, 8}, 40, 0.5, seed), kStandard);
      ASSERT_TRUE(found.result.verdict.accepted) << height_mm << ' ' << found.result.verdict.reason.text();
      ASSERT_EQ(found.result.coefficients.size(), 5U);
      const Coefficient& height = found.result.coefficients[4];
      EXPECT_NEAR(height.value, height_mm, 0.2 * height_mm);
      within += std::abs(height.value - height_mm) <= 2 * height.standard_error ? 1 : 0;
      ++trials;
      sensing::FingerParameters finger;
      sensing::IndentationParameters indentation;
      std::vector<Parameter> both = bindParameters(finger), more = bindParameters(indentation);
      both.insert(both.end(), more.begin(), more.end());
      ASSERT_TRUE(applyChanges(both, found.result.changes).has_value());
      EXPECT_NEAR(indentation.camera_height_mm, height.value, 1e-3);
      EXPECT_NEAR(finger.scale_x_mm_per_px, 0.46, 0.01);
    }
  }
  EXPECT_GE(within, 0.9 * trials);  // 95 % of them, if the uncertainty is right
  EXPECT_LE(within, 0.99 * trials);

  const auto exact = calibrateCamera(throughAPinhole(100, {0, 4, 8}, 40, 0, 1), kStandard);
  ASSERT_TRUE(exact.result.verdict.accepted) << exact.result.verdict.reason.text();
  EXPECT_NEAR(exact.result.coefficients[4].value, 100, 1e-3);
}

TEST(Camera, AHeightThatThePointsDoNotTellIsRefused) {
  const auto refusedFor = [](const CameraSamples& samples) {
    const auto found = calibrateCamera(samples, kStandard).result;
    EXPECT_FALSE(found.verdict.accepted);
    EXPECT_EQ(found.verdict.threshold, "calibration.camera_height_percent");
    EXPECT_TRUE(found.changes.empty());
    return found.verdict.reason.text();
  };
  EXPECT_THAT(refusedFor(throughAPinhole(100, {6, 6}, 40, 0.5, 1)), testing::HasSubstr("pressed down as deep"));
  EXPECT_THAT(refusedFor(throughAPinhole(100, {6}, 40, 0, 1)), testing::HasSubstr("do not tell"));
  EXPECT_THAT(refusedFor(throughAPinhole(100, {0, 2}, 20, 0.5, 1)), testing::HasSubstr("only to"));
  EXPECT_THAT(refusedFor(throughAPinhole(100, {0, 0.5}, 40, 0.5, 1)), testing::HasSubstr("camera's height"));
  CameraSamples few = throughAPinhole(100, {0, 8}, 40, 0, 1);
  for (auto* column : {&few.x_px, &few.y_px, &few.x_mm, &few.y_mm, &few.depth_mm}) {
    std::vector<double> kept;
    for (const std::size_t i : {0U, 2U, 6U, 11U, 17U}) kept.push_back((*column)[i]);
    *column = kept;
  }
  EXPECT_THAT(refusedFor(few), testing::HasSubstr("at least 6"));
}

TEST(Camera, DepthsThatAreNoneAreRefusedByName) {
  for (const double depth : {-1.0, 26.0, std::numeric_limits<double>::quiet_NaN(), 1e300}) {
    CameraSamples samples = throughAPinhole(100, {0, 8}, 40, 0.5, 1);
    samples.depth_mm[3] = depth;
    const auto found = calibrateCamera(samples, kStandard).result;
    EXPECT_FALSE(found.verdict.accepted) << depth;
    EXPECT_THAT(found.verdict.reason.text(), testing::HasSubstr("depth_mm")) << depth;
  }
  CameraSamples uneven = throughAPinhole(100, {0, 8}, 40, 0.5, 1);
  uneven.depth_mm.pop_back();
  EXPECT_FALSE(calibrateCamera(uneven, kStandard).result.verdict.accepted);
  // All on the cloth: the height stays as it is.
  const auto flat = calibrateCamera(throughAPinhole(100, {0, 0}, 40, 0.3, 1), kStandard).result;
  EXPECT_TRUE(flat.verdict.accepted) << flat.verdict.reason.text();
  EXPECT_EQ(flat.coefficients.size(), 4U);
}

TEST(Camera, ATiltedViewIsFoundOut) {
  CameraSamples samples;
  for (const double u : stepsTo(45, 255, 35)) {
    for (const double v : stepsTo(50, 190, 35)) {
      const double depth = 1 + 0.002 * (v - 120);
      samples.x_px.push_back(u);
      samples.y_px.push_back(v);
      samples.x_mm.push_back(0.45 * (u - 150) / depth);
      samples.y_mm.push_back(-0.45 * (v - 120) / depth);
    }
  }
  const auto found = calibrateCamera(samples, kStandard);
  EXPECT_FALSE(found.result.verdict.accepted);
  EXPECT_THAT(found.result.verdict.reason.text(), testing::HasSubstr("square"));
}

}  // namespace
}  // namespace fyd::calibration
