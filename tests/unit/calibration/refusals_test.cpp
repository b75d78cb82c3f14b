// What calibrations refuse and what they say, how results reach parameters, and the record that goes with a profile.
#include <cmath>
#include <limits>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/calibration/calibration_record.h"
#include "core/calibration/camera_calibration.h"
#include "core/calibration/encoder_calibration.h"
#include "core/calibration/fit/cross_validation.h"
#include "core/calibration/ir_calibration.h"
#include "core/calibration/load_cell_calibration.h"
#include "core/calibration/rest_calibration.h"
#include "core/calibration/stiffness_map.h"
#include "core/calibration/threshold_suggestion.h"
#include "core/control/control_parameters.h"
#include "core/sensing/sensing_parameters.h"

namespace fyd::calibration {
namespace {

using testing::HasSubstr;

const CalibrationParameters kStandard;
const sensing::IndentationParameters kPresent;

IrSamples thesisAt(const std::vector<double>& distances_mm) {
  const sensing::IrDistance thesis;
  IrSamples samples;
  for (const double d : distances_mm) {
    samples.adc.push_back(thesis.voltsAt(d) * 4096 / 3.3);
    samples.distance_mm.push_back(d);
  }
  return samples;
}

LoadCellSamples thesisCell(const std::vector<double>& values) {
  LoadCellSamples samples;
  for (const double value : values) {
    samples.value_mV_per_V.push_back(value);
    samples.force_N.push_back((1004.8805 * value - 20.2512) / 1000 * 9.80665);
  }
  return samples;
}

StiffnessSamples mapOf(const std::vector<std::pair<double, double>>& law) {
  StiffnessSamples samples;
  for (const auto& [angle, k] : law) {
    for (const double depth : {2.0, 4.0, 6.0, 8.0}) {
      samples.angle_deg.push_back(angle);
      samples.indentation_mm.push_back(depth);
      samples.force_N.push_back(k * depth + 0.02 * std::sin(7 * angle + depth));
    }
  }
  return samples;
}

CameraSamples gridOf(double sx, double sy) {
  CameraSamples samples;
  for (const double u : {50.0, 150.0, 250.0}) {
    for (const double v : {50.0, 120.0, 190.0}) {
      samples.x_px.push_back(u);
      samples.y_px.push_back(v);
      samples.x_mm.push_back(sx * (u - 150));
      samples.y_mm.push_back(sy * (v - 120));
    }
  }
  return samples;
}

TEST(IrRefusal, TooFewDistancesSayWhereToAddSome) {
  const auto found = calibrateIr(thesisAt({40, 60, 100, 150, 100, 60}), kPresent, kStandard);
  EXPECT_FALSE(found.result.verdict.accepted);
  EXPECT_THAT(found.result.verdict.reason.text(), HasSubstr("4 different distances in 6 points"));
  EXPECT_THAT(found.result.verdict.reason.text(), HasSubstr("add points between 150 and 300 mm"));
  EXPECT_TRUE(found.result.changes.empty());
}

TEST(IrRefusal, RepeatedPointsAreNoNewDistances) {
  const auto found = calibrateIr(thesisAt(std::vector<double>(40, 100.0)), kPresent, kStandard);
  EXPECT_THAT(found.result.verdict.reason.text(), HasSubstr("1 different distances in 40 points"));
}

TEST(IrRefusal, ClusteredPointsAreSpreadOut) {
  const auto found = calibrateIr(thesisAt({98, 99, 100, 101, 102, 103}), kPresent, kStandard);
  EXPECT_FALSE(found.result.verdict.accepted);
  EXPECT_THAT(found.result.verdict.reason.text(), HasSubstr("span only 5 mm"));
  const auto gap = calibrateIr(thesisAt({40, 45, 50, 55, 60, 300}), kPresent, kStandard);
  EXPECT_THAT(gap.result.verdict.reason.text(), HasSubstr("add points between 60 and 300 mm"));
}

TEST(IrRefusal, AFoldedSensorIsNamedByItsDistances) {
  IrSamples samples = thesisAt({40, 60, 80, 120, 200, 300});
  samples.adc.push_back(2400);  // at 20 mm the voltage has fallen again
  samples.distance_mm.push_back(20);
  const auto found = calibrateIr(samples, kPresent, kStandard);
  EXPECT_FALSE(found.result.verdict.accepted);
  EXPECT_THAT(found.result.verdict.reason.text(), HasSubstr("adc rises from 2400 at 20 mm"));
  EXPECT_THAT(found.result.verdict.reason.text(), HasSubstr("too near"));
}

TEST(IrRefusal, ConstantCodesAndNonsenseAreRefused) {
  IrSamples samples = thesisAt({40, 60, 80, 120, 200, 300});
  samples.adc.assign(6, 1000);
  EXPECT_FALSE(calibrateIr(samples, kPresent, kStandard).result.verdict.accepted);
  EXPECT_FALSE(calibrateIr({}, kPresent, kStandard).result.verdict.accepted);
  EXPECT_FALSE(calibrateIr({.adc = {1, 2}, .distance_mm = {3}}, kPresent, kStandard).result.verdict.accepted);
  EXPECT_FALSE(
      calibrateIr(thesisAt({40, 60, 80, 120, 200, 300}), kPresent, kStandard, {.sensor = 8}).result.verdict.accepted);
}

TEST(BadRow, TheFirstBadPointIsNamed) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL, -1.0, 1e308}) {
    IrSamples samples = thesisAt({40, 60, 80, 120, 200, 300});
    samples.distance_mm[4] = bad;
    samples.adc[2] = bad;
    const auto found = calibrateIr(samples, kPresent, kStandard);
    EXPECT_FALSE(found.result.verdict.accepted);
    EXPECT_EQ(found.result.bad_row, 2U) << bad;
    EXPECT_THAT(found.result.verdict.reason.text(), HasSubstr("adc = "));
  }
  LoadCellSamples cell = thesisCell({0, 0.2, 0.4, 0.6});
  cell.force_N[3] = std::nan("");
  EXPECT_EQ(calibrateLoadCell(cell, kStandard).result.bad_row, 3U);
}

TEST(Enormous, AMillionPointsAreRefusedAtOnce) {
  const std::vector<double> many(1'000'000, 0.5);
  const auto found = calibrateLoadCell({.value_mV_per_V = many, .force_N = many}, kStandard);
  EXPECT_THAT(found.result.verdict.reason.text(), HasSubstr("1000000 points"));
}

TEST(LoadCellRefusal, NeedsDifferentWeightsOverASpan) {
  EXPECT_THAT(calibrateLoadCell(thesisCell({0, 0, 0.3, 0.3}), kStandard).result.verdict.reason.text(),
              HasSubstr("2 different weights in 4 points"));
  const auto narrow = calibrateLoadCell(thesisCell({0.10, 0.11, 0.12}), kStandard);
  EXPECT_THAT(narrow.result.verdict.reason.text(), HasSubstr("add weights between 0.984 and 7.65 N"));
  EXPECT_FALSE(calibrateLoadCell({}, kStandard).result.verdict.accepted);
  LoadCellSamples dead = thesisCell({0, 0.2, 0.4, 0.6});
  dead.value_mV_per_V.assign(4, 0.1);
  EXPECT_THAT(calibrateLoadCell(dead, kStandard).result.verdict.reason.text(), HasSubstr("cable"));
}

TEST(StiffnessRefusal, AFallingStiffnessIsNamedByItsAngles) {
  const auto map = calibrateStiffness(mapOf({{20, 0.5}, {45, 0.7}, {60, 0.55}, {90, 0.72}}), kStandard);
  EXPECT_FALSE(map.result.verdict.accepted);
  EXPECT_THAT(map.result.verdict.reason.text(), HasSubstr("falls from 0.7"));
  EXPECT_THAT(map.result.verdict.reason.text(), HasSubstr("45 deg"));
  EXPECT_TRUE(map.result.changes.empty());
}

TEST(StiffnessRefusal, NeedsAnglesPressesAndDepth) {
  EXPECT_THAT(calibrateStiffness(mapOf({{20, 0.5}, {90, 0.7}}), kStandard).result.verdict.reason.text(),
              HasSubstr("between 20 and 90 deg"));
  StiffnessSamples few = mapOf({{20, 0.5}, {45, 0.55}, {60, 0.67}});
  few.angle_deg.push_back(90);
  few.indentation_mm.push_back(5);
  few.force_N.push_back(3.6);
  EXPECT_THAT(calibrateStiffness(few, kStandard).result.verdict.reason.text(), HasSubstr("1 points at 90 deg"));
  StiffnessSamples shallow = mapOf({{20, 0.5}, {45, 0.55}, {60, 0.67}});
  for (std::size_t i = 8; i < 12; ++i) shallow.indentation_mm[i] = 0.0;
  EXPECT_THAT(calibrateStiffness(shallow, kStandard).result.verdict.reason.text(), HasSubstr("press deeper"));
}

TEST(StiffnessRefusal, PointsOnTheUntouchedClothAreNoPresses) {
  const auto untouched = [](int zeros_before_the_last, const std::vector<double>& depths_mm) {
    StiffnessSamples samples;
    for (const auto& [angle, k] : {std::pair{20.0, 0.5}, {45.0, 0.55}, {60.0, 0.67}, {90.0, 0.72}}) {
      for (std::size_t i = 0; i < depths_mm.size(); ++i) {
        const int zeros = i + 1 == depths_mm.size() ? zeros_before_the_last : 0;
        for (int z = 0; z <= zeros; ++z) {
          const double depth = z < zeros ? 0.0 : depths_mm[i];
          samples.angle_deg.push_back(angle);
          samples.indentation_mm.push_back(depth);
          samples.force_N.push_back(k * depth);
        }
      }
    }
    return samples;
  };
  const auto one = calibrateStiffness(untouched(2, {5.0}), kStandard);
  EXPECT_FALSE(one.result.verdict.accepted);
  EXPECT_THAT(one.result.verdict.reason.text(), HasSubstr("1 points at 20 deg"));
  EXPECT_EQ(one.result.verdict.threshold, "calibration.stiffness_fewest_presses");
  // Ten points lie between an angle's two presses, so both are held out at once, and nothing predicts them.
  CalibrationParameters two;
  two.stiffness_fewest_presses = 2;
  const auto together = calibrateStiffness(untouched(9, {5.0, 6.0}), two);
  EXPECT_FALSE(together.result.verdict.accepted);
  EXPECT_THAT(together.result.verdict.reason.text(), HasSubstr("points at 20 deg cannot be predicted"));
  EXPECT_TRUE(calibrateStiffness(untouched(8, {5.0, 6.0}), two).result.verdict.accepted);
}

TEST(StiffnessMapping, NeighboursWithinTheirUncertaintyArePooledAndTheLawStillRises) {
  const auto map = calibrateStiffness(mapOf({{20, 0.5}, {45, 0.6}, {60, 0.599}, {90, 0.72}}), kStandard);
  ASSERT_TRUE(map.result.verdict.accepted) << map.result.verdict.reason.text();
  ASSERT_EQ(map.law_angle_deg.size(), 3U);
  control::ControlParameters control;
  ASSERT_TRUE(applyChanges(bindParameters(control), map.result.changes).has_value());
  EXPECT_TRUE(control::checkControlParameters(control).has_value());
  EXPECT_NEAR(map.law_angle_deg[1], 52.5, 1.0);
}

TEST(PoolViolators, GivesTheWeightedMeanByHand) {
  const auto blocks = poolViolators({{0, 1, 1}, {1, 3, 1}, {2, 2, 3}, {3, 5, 1}});
  ASSERT_EQ(blocks.size(), 3U);
  EXPECT_DOUBLE_EQ(blocks[1].level, (3 + 3 * 2) / 4.0);
  EXPECT_DOUBLE_EQ(blocks[1].place, (1 + 3 * 2) / 4.0);
  EXPECT_EQ(poolViolators({{0, 3, 1}, {1, 2, 1}, {2, 1, 1}}).size(), 1U);
}

TEST(CameraRefusal, PointsOnALineAndRepeatsSayWhatToAdd) {
  CameraSamples line;
  for (const double t : {0.0, 1.0, 2.0, 3.0, 4.0}) {
    line.x_px.push_back(50 + 40 * t);
    line.y_px.push_back(60 + 30 * t);
    line.x_mm.push_back(20 * t);
    line.y_mm.push_back(-14 * t);
  }
  EXPECT_THAT(calibrateCamera(line, kStandard).result.verdict.reason.text(), HasSubstr("add points off that line"));
  CameraSamples repeated;
  for (int i = 0; i < 20; ++i) {
    repeated.x_px.push_back(100);
    repeated.y_px.push_back(100);
    repeated.x_mm.push_back(0);
    repeated.y_mm.push_back(0);
  }
  EXPECT_THAT(calibrateCamera(repeated, kStandard).result.verdict.reason.text(), HasSubstr("1 different points"));
}

TEST(CameraMapping, AMirroredTargetIsPointedOut) {
  EXPECT_FALSE(calibrateCamera(gridOf(0.45, -0.47), kStandard).mirrored);
  const auto wrong = calibrateCamera(gridOf(0.45, 0.47), kStandard);
  EXPECT_TRUE(wrong.mirrored);
  ASSERT_FALSE(wrong.result.notes.empty());
  EXPECT_THAT(wrong.result.notes.back().text(), HasSubstr("signs of y_mm"));
}

TEST(Threshold, LiesInTheValleyBetweenFingerAndCloth) {
  std::array<std::uint64_t, 256> histogram{};
  for (std::size_t i = 0; i < 25; ++i) {
    histogram[48 + i] = 20;     // a finger of 500 pixels
    histogram[208 + i] = 1200;  // on 30 000 of cloth
  }
  const auto found = suggestThreshold(histogram);
  ASSERT_TRUE(found.plausible) << found.reason.text();
  EXPECT_GT(found.threshold, 73);
  EXPECT_LT(found.threshold, 207);
  EXPECT_NEAR(found.finger_share, 500.0 / 30500, 1e-6);
}

TEST(Threshold, ACoveredOrEmptyPictureGivesNone) {
  std::array<std::uint64_t, 256> histogram{};
  EXPECT_FALSE(suggestThreshold(histogram).plausible);
  histogram[200] = 1000;
  EXPECT_THAT(suggestThreshold(histogram).reason.text(), HasSubstr("one grey value"));
  for (std::size_t i = 150; i < 250; ++i) histogram[i] = 100;
  EXPECT_THAT(suggestThreshold(histogram).reason.text(), HasSubstr("not told apart"));
}

TEST(Encoders, FindSignAndZeroAcrossTheSeam) {
  EncoderSamples samples;
  for (int i = 0; i <= 20; ++i) {
    const double angle = -10 + 5.0 * i;
    const auto onCircle = [](double counts) { return counts - 4096 * std::floor(counts / 4096); };
    samples.command_deg[0].push_back(angle);
    samples.counts[0].push_back(onCircle(std::round(4000 + angle * 4096 / 360)));
    samples.command_deg[1].push_back(-angle);
    samples.counts[1].push_back(onCircle(std::round(100 + angle * 4096 / 360)));
  }
  const auto found = calibrateEncoders(samples, kStandard);
  ASSERT_TRUE(found.result.verdict.accepted) << found.result.verdict.reason.text();
  EXPECT_NEAR(found.encoders[0].zero_counts, 4000, 1);
  EXPECT_FALSE(found.encoders[0].inverted);
  EXPECT_NEAR(found.encoders[1].zero_counts, 100, 1);
  EXPECT_TRUE(found.encoders[1].inverted);
  control::ControlParameters control;
  ASSERT_TRUE(applyChanges(bindParameters(control), found.result.changes).has_value());
  EXPECT_TRUE(control.encoder_second_inverted);

  for (double& counts : samples.counts[1]) counts = 100;  // a motor that does not turn
  EXPECT_THAT(calibrateEncoders(samples, kStandard).result.verdict.reason.text(),
              HasSubstr("second encoder turns 100.0 % less"));
}

TEST(Rest, AcceptsStillnessAndRefusesMotionAndAWrongScale) {
  RestSamples samples;
  for (int i = 0; i < 200; ++i) {
    samples.axis_g[0].push_back(0.01 * std::sin(i));
    samples.axis_g[1].push_back(0.6 + 0.01 * std::cos(i));
    samples.axis_g[2].push_back(0.8);
  }
  EXPECT_TRUE(calibrateRest(samples, kStandard).result.verdict.accepted);
  RestSamples without_gravity = samples;
  for (std::size_t i = 0; i < 200; ++i) {
    without_gravity.axis_g[1][i] -= 0.6;
    without_gravity.axis_g[2][i] -= 0.8;
  }
  const auto taken_away = calibrateRest(without_gravity, kStandard).result;
  EXPECT_TRUE(taken_away.verdict.accepted) << taken_away.verdict.reason.text();
  ASSERT_EQ(taken_away.notes.size(), 1U);
  RestSamples dead = samples;
  for (auto& axis : dead.axis_g) std::fill(axis.begin(), axis.end(), 0.0);
  EXPECT_FALSE(calibrateRest(dead, kStandard).result.verdict.accepted);
  RestSamples moving = samples;
  for (std::size_t i = 0; i < 200; ++i) moving.axis_g[0][i] *= 20;
  EXPECT_THAT(calibrateRest(moving, kStandard).result.verdict.reason.text(), HasSubstr("it moves"));
  for (auto& axis : samples.axis_g) {
    for (double& a : axis) a *= 1.3;
  }
  EXPECT_THAT(calibrateRest(samples, kStandard).result.verdict.reason.text(), HasSubstr("counts per g"));
}

TEST(NoTouch, AFinishedTareBecomesOffsetsAndAFailedOneWords) {
  sensing::TareResult tare{.sensors = 3, .offset_mm = {101, 99, 102}, .spread_mm = {1, 1, 1}, .force_N = 0.05};
  const auto good = judgeTare(sensing::TareState::done, tare, 0.1);
  sensing::SensingParameters sensing;
  ASSERT_TRUE(applyChanges(bindParameters(sensing), good.changes).has_value());
  EXPECT_DOUBLE_EQ(sensing.indentation.ir_offset_mm[2], 102);
  EXPECT_NEAR(sensing.load_cell.zero_N, 0.15, 1e-12);
  const auto moved = judgeTare(sensing::TareState::unsteady, tare, 0.1);
  EXPECT_FALSE(moved.verdict.accepted);
  EXPECT_TRUE(moved.changes.empty());
  EXPECT_THAT(moved.verdict.reason.text(), HasSubstr("come to rest"));
}

TEST(Folds, WholeTargetsAreHeldOutAndTheEndsAreNotWhenKept) {
  const std::vector<double> targets = {40, 60, 40, 80, 60, 100};
  const auto kept = foldsByTarget(targets, 0.25, Ends::kept);
  EXPECT_EQ(kept[0], kNeverHeldOut);
  EXPECT_EQ(kept[5], kNeverHeldOut);
  EXPECT_EQ(kept[1], kept[4]);
  EXPECT_NE(kept[1], kept[3]);
  const auto all = foldsByTarget(targets, 0.25, Ends::held_out);
  EXPECT_EQ(all[0], all[2]);
  EXPECT_NE(all[0], kNeverHeldOut);
}

TEST(Folds, MeasuredValuesOfOneTargetAreHeldOutTogether) {
  const std::vector<double> measured = {40.0, 60.1, 40.2, 80.0, 59.95, 100.0};
  const auto folds = foldsByTarget(measured, 0.25, Ends::held_out);
  EXPECT_EQ(folds[0], folds[2]);
  EXPECT_EQ(folds[1], folds[4]);
  EXPECT_NE(folds[0], folds[1]);
}

TEST(Apply, IsAllOrNothing) {
  sensing::SensingParameters sensing;
  const auto parameters = bindParameters(sensing);
  const auto failed = applyChanges(
      parameters, std::vector<ParameterChange>{{"sensing.force_zero_N", "1"}, {"sensing.force_slope_g", "1e9"}});
  ASSERT_FALSE(failed.has_value());
  EXPECT_THAT(failed.error().text(), HasSubstr("sensing.force_slope_g"));
  EXPECT_EQ(sensing.load_cell.zero_N, 0.0);
  EXPECT_FALSE(applyChanges(parameters, std::vector<ParameterChange>{{"no.such", "1"}}).has_value());
}

CalibrationRecord exampleRecord() {
  return {.procedure = "ir",
          .sensor = 2,
          .who = "R. \"quoted\" Übung",
          .when = "2026-08-01T09:30:00Z",
          .conditions = "20 °C\nlamp off",
          .touchpad = "serial:A7",
          .simulated = true,
          .picture = "",
          .curve = "inverse",
          .unit = "mm",
          .verdict = "good",
          .points = 12,
          .outliers = 1,
          .rmse = 0.123456789012345,
          .held_out_rmse = 0.5,
          .max_residual = 1.0,
          .residuals = {0.1, -0.2, 1.0 / 3.0},
          .samples = {{"adc", "counts", {700.0, 1.0 / 3.0}}, {"distance_mm", "mm", {40.0, 300.0}}},
          .coefficients = {{"c0", "mm", 790.712, 0.25}, {"c1", "mm/V", -1.0 / 3.0, kUnknown}},
          .changes = {{"sensing.force_zero_N", "0", "0.25"}}};
}

TEST(Record, ReadsBackWhatItWroteToTheLastBit) {
  const std::vector<CalibrationRecord> records = {exampleRecord(), exampleRecord()};
  const std::string text = formatRecords(records);
  const auto back = parseRecords(text, "lab.calibration.toml");
  ASSERT_TRUE(back.has_value()) << back.error().text();
  ASSERT_EQ(back->size(), 2U);
  const CalibrationRecord& r = back->front();
  EXPECT_EQ(r.who, exampleRecord().who);
  EXPECT_EQ(r.conditions, exampleRecord().conditions);
  EXPECT_EQ(r.sensor, 2);
  EXPECT_EQ(r.rmse, exampleRecord().rmse);
  EXPECT_TRUE(std::isnan(r.condition_number));
  EXPECT_EQ(r.residuals, exampleRecord().residuals);
  EXPECT_EQ(r.touchpad, "serial:A7");
  EXPECT_TRUE(r.simulated);
  ASSERT_EQ(r.samples.size(), 2U);
  EXPECT_EQ(r.samples[0].unit, "counts");
  EXPECT_EQ(r.samples[0].values, exampleRecord().samples[0].values);
  ASSERT_EQ(r.coefficients.size(), 2U);
  EXPECT_EQ(r.coefficients[1].value, -1.0 / 3.0);
  EXPECT_TRUE(std::isnan(r.coefficients[1].standard_error));
  ASSERT_EQ(r.changes.size(), 1U);
  EXPECT_EQ(r.changes[0].after, "0.25");
  EXPECT_EQ(formatRecords(*back), text);
  ASSERT_TRUE(parseRecords(formatRecords({}), "x").has_value());
}

TEST(Record, WhatIsNoRecordIsRefusedWithItsLine) {
  const auto problemOf = [](std::string_view text) {
    const auto parsed = parseRecords(text, "f");
    return parsed ? std::string("accepted") : parsed.error().text();
  };
  EXPECT_THAT(problemOf(""), HasSubstr("format"));
  EXPECT_THAT(problemOf("format = 3\n"), HasSubstr("format 3"));
  EXPECT_THAT(problemOf("format = 0\n"), HasSubstr("format 0"));
  EXPECT_THAT(problemOf("format = 1\n[[record]]\nwho = \"x\"\n"), HasSubstr("missing"));
  EXPECT_THAT(problemOf("format = [\n"), HasSubstr("f:"));
  EXPECT_THAT(problemOf("format = 1\nother = 3\n"), HasSubstr("f:2"));
  std::string text = formatRecords(std::vector<CalibrationRecord>{exampleRecord()});
  EXPECT_THAT(problemOf(text + "more = 1\n"), testing::Not(testing::StrEq("accepted")));
  for (std::size_t cut = 1; cut < text.size(); cut += 7)
    (void)parseRecords(text.substr(0, cut), "f");  // must not crash
}

TEST(Record, IsInForceUntilAParameterIsChangedByHand) {
  sensing::SensingParameters sensing;
  sensing.load_cell.zero_N = 0.25;
  EXPECT_TRUE(inForce(exampleRecord(), bindParameters(sensing)));
  sensing.load_cell.zero_N = 0.26;
  EXPECT_FALSE(inForce(exampleRecord(), bindParameters(sensing)));
}

TEST(Record, AnotherSensorsEntryAndALaterTareDoNotTakeItOutOfForce) {
  sensing::SensingParameters sensing;
  const auto bound = bindParameters(sensing);
  CalibrationRecord record = exampleRecord();
  ASSERT_TRUE(assignParameter(*findParameter(bound, "sensing.ir_lowest_code"), "[500, 510, 520]"));
  record.changes = {{"sensing.ir_lowest_code", "[524, 524, 524]", "[524, 510, 524]"}};
  EXPECT_TRUE(inForce(record, bound)) << "the others were calibrated since";
  ASSERT_TRUE(assignParameter(*findParameter(bound, "sensing.ir_lowest_code"), "[524, 511, 524]"));
  EXPECT_FALSE(inForce(record, bound));
  record.changes = {{"sensing.ir2_curve_mm", "[]", "[1, 2, 3]"}};
  ASSERT_TRUE(assignParameter(*findParameter(bound, "sensing.ir2_curve_mm"), "[7, 2, 3]"));
  EXPECT_FALSE(inForce(record, bound)) << "its own curve counts whole";
  record.procedure = "load-cell";
  record.sensor = 0;
  record.changes = {{"sensing.force_zero_N", "0.1", "0"}};
  sensing.load_cell.zero_N = 0.3;
  EXPECT_TRUE(inForce(record, bound));
}

TEST(Record, AgesByTheCalendar) {
  const auto age = [](std::string_view today) { return ageOf(exampleRecord(), today, CalibrationParameters{}); };
  EXPECT_EQ(age("2026-08-02")->days, 1);
  EXPECT_EQ(age("2026-08-02")->age, Age::fresh);
  EXPECT_EQ(age("2026-10-30")->age, Age::fresh);  // 90 days
  EXPECT_EQ(age("2026-10-31")->age, Age::ageing);
  EXPECT_EQ(age("2027-08-01T00:00:00Z")->age, Age::ageing);  // 365 days
  EXPECT_EQ(age("2027-08-02")->age, Age::old);
  EXPECT_THAT(age("2026-07-01")->warning.text(), HasSubstr("future"));
  for (const char* bad : {"", "yesterday", "2026-13-01", "2026-02-30", "2026/08/01", "2026-08-01x"}) {
    EXPECT_FALSE(age(bad).has_value()) << bad;
  }
}

}  // namespace
}  // namespace fyd::calibration
