// The calibration report: values before and after, refused fits and checks, and the choice of the former record.
#include "core/station/profile/calibration_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/report/report.h"

namespace fyd::station {
namespace {

using calibration::CalibrationRecord;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

CalibrationRecord record(const char* procedure, int sensor, const char* who) {
  CalibrationRecord out;
  out.procedure = procedure;
  out.sensor = sensor;
  out.who = who;
  out.when = "2026-11-21T20:15:00Z";
  out.unit = "N";
  out.verdict = "held-out error 0.01 N";
  out.points = 3;
  out.held_out_rmse = 0.0123;
  out.residuals = {0.01, -0.02, calibration::kUnknown};
  out.changes = {{"sensing.force_slope_g", "999", "1004.88"}};
  return out;
}

TEST(CalibrationReport, TheOneBeforeIsOfTheSamePartAndSensor) {
  const std::vector records = {record("ir", 1, "a"), record("ir", 2, "b"), record("ir", 1, "c"),
                               record("load-cell", 0, "d")};
  const RecordPair pair = newestOf(records, "ir", 1);
  EXPECT_EQ(pair.newest->who, "c");
  EXPECT_EQ(pair.former->who, "a");
  EXPECT_EQ(newestOf(records, "ir", 2).former, nullptr);
  EXPECT_EQ(newestOf(records, "camera", 0).newest, nullptr);
}

TEST(CalibrationReport, ShowsBothWithEveryValueAndTheResiduals) {
  const CalibrationRecord former = record("load-cell", 0, "Ada");
  const auto content =
      gatherCalibrationReport({.record = record("load-cell", 0, "Bo"), .outliers = {1}}, &former, "lab.toml");
  EXPECT_EQ(content.strips.size(), 2U);
  ASSERT_EQ(content.tables.size(), 3U);
  const auto html = report::reportHtml(content);
  ASSERT_TRUE(html);
  for (const char* words : {"Ada", "Bo", "999", "1004.88", "0.012 N", "lab.toml", "the others contradict it"}) {
    EXPECT_THAT(*html, HasSubstr(words));
  }
  EXPECT_THAT(*html, Not(HasSubstr("nan")));
  const auto pdf = report::reportPdf(content);
  ASSERT_TRUE(pdf);
  EXPECT_THAT(*pdf, HasSubstr("%PDF"));
}

TEST(CalibrationReport, TellsTheTouchpadThePointsAndHowWellTheCoefficientsAreKnown) {
  CalibrationRecord measured = record("load-cell", 0, "Ada");
  measured.touchpad = "serial:A7";
  measured.samples = {{"value", "mV/V", {0.125, 0.5, 1.0}}, {"force_N", "N", {0.0, 3.75, 8.625}}};
  measured.coefficients = {{"slope", "N/(mV/V)", 9.875, 0.0123}, {"mean", "g", 1.0, calibration::kUnknown}};
  const auto html = report::reportHtml(gatherCalibrationReport({.record = measured}, nullptr, "lab.toml"));
  ASSERT_TRUE(html);
  for (const char* words :
       {"serial number A7", "force_N, N", "value, mV/V", "8.625", "9.875", "± 0.012", "N/(mV/V)", "none: a mean"}) {
    EXPECT_THAT(*html, HasSubstr(words));
  }
}

TEST(CalibrationReport, ARefusedFitAndACheckSayWhyNothingChanges) {
  CalibrationRecord refused = record("stiffness", 0, "");
  refused.changes.clear();
  refused.residuals.clear();
  const auto content = gatherCalibrationReport({.record = refused, .accepted = false}, nullptr, "");
  EXPECT_THAT(content.strips, IsEmpty());
  EXPECT_THAT(content.tables[1].remark, HasSubstr("stay as they were"));
  EXPECT_TRUE(report::reportPdf(content));
  EXPECT_THAT(gatherCalibrationReport({.record = refused}, nullptr, "").tables[1].remark,
              HasSubstr("changes no value"));
}

}  // namespace
}  // namespace fyd::station
