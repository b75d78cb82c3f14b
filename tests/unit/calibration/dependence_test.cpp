// Values that rest on an older calibration of another part: found, named, and not found once they were taken again.
#include "core/calibration/calibration_dependence.h"

#include <gtest/gtest.h>

#include "core/control/control_parameters.h"
#include "core/sensing/sensing_parameters.h"

namespace fyd::calibration {
namespace {

struct Parts {
  sensing::SensingParameters sensing;
  control::ControlParameters control;
  template <class Visitor>
  void describe(Visitor& v) {
    sensing.describe(v);
    control.describe(v);
  }
};

/// A profile with its records, calibrated as saveCalibration does it.
struct Bench {
  Parts parts;
  std::vector<CalibrationRecord> records;
  void set(const char* id, const std::string& value) {
    ASSERT_TRUE(assignParameter(*findParameter(bindParameters(parts), id), value)) << id << value;
  }
  void calibrate(const char* procedure, int sensor, std::vector<ParameterChange> changes, bool notes = true) {
    auto applied = applyChanges(bindParameters(parts), changes);
    ASSERT_TRUE(applied);
    for (AppliedChange& left : leftBehind(procedure, bindParameters(parts))) {
      const bool own = std::ranges::any_of(*applied, [&](const auto& each) { return each.id == left.id; });
      if (notes && !own) applied->push_back(left);
    }
    CalibrationRecord record;
    record.procedure = procedure;
    record.sensor = sensor;
    record.changes = *applied;
    records.push_back(record);
  }
  void curve(int sensor, const char* coefficients, bool notes = true) {
    calibrate("ir", sensor, {{fmt::format("sensing.ir{}_curve_mm", sensor), coefficients}}, notes);
  }
  void noTouch(const char* offsets) {
    calibrate("no-touch", 0, {{"sensing.ir_offset_mm", offsets}, {"sensing.force_zero_N", "0.25"}});
  }
  [[nodiscard]] std::vector<NewerBasis> outdated(const char* part) {
    return newerBases(records, part, bindParameters(parts));
  }
};

using Bases = std::vector<NewerBasis>;

TEST(Dependence, OffsetsTakenBeforeANewCurveAreOutdatedUntilTheyAreTakenAgain) {
  Bench b;
  EXPECT_TRUE(b.outdated("no-touch").empty());
  b.noTouch("[101.5, 102.5, 103.5]");
  EXPECT_TRUE(b.outdated("no-touch").empty());
  b.curve(2, "[1, 2, 3]");
  EXPECT_EQ(b.outdated("no-touch"), (Bases{{"ir", 2}}));
  EXPECT_EQ(describeBases("no-touch", b.outdated("no-touch")).text(),
            "taken with another curve: take it again (Distance sensor 2)");
  EXPECT_TRUE(inForce(b.records.back(), bindParameters(b.parts)));
  b.noTouch("[101.5, 102.5, 103.5]");  // the very same numbers, but measured now
  EXPECT_TRUE(b.outdated("no-touch").empty());
}

TEST(Dependence, ATareWritesNoRecordAndIsKnownByItsValue) {
  Bench b;
  b.curve(1, "[1, 2, 3]");  // nobody ever took the offsets: they are those of another curve all the same
  b.curve(3, "[1, 2, 4]");
  EXPECT_EQ(b.outdated("no-touch"), (Bases{{"ir", 1}, {"ir", 3}}));
  b.set("sensing.ir_offset_mm", "[99.5, 100, 100]");  // only one sensor's is new
  EXPECT_EQ(b.outdated("no-touch"), (Bases{{"ir", 3}}));
  b.set("sensing.ir_offset_mm", "[99.5, 100.5, 98.25]");
  EXPECT_TRUE(b.outdated("no-touch").empty());
  for (const CalibrationRecord& each : b.records) EXPECT_TRUE(inForce(each, bindParameters(b.parts)));
  // A tare that was taken before the curve, then the curve.
  b.curve(1, "[5, 6, 7]");
  EXPECT_EQ(b.outdated("no-touch"), (Bases{{"ir", 1}}));
  // The former curve by hand: the offset fits again.
  b.set("sensing.ir1_curve_mm", "[1, 2, 3]");
  EXPECT_TRUE(b.outdated("no-touch").empty());
}

TEST(Dependence, TheLoadCellsZeroIsOneOfThem) {
  Bench b;
  b.noTouch("[101.5, 102.5, 103.5]");
  b.calibrate("load-cell", 0, {{"sensing.force_slope_g", "1010"}, {"sensing.force_zero_N", "0"}});
  EXPECT_EQ(b.outdated("no-touch"), (Bases{{"load-cell", 0}}));
  b.set("sensing.force_zero_N", "0.125");
  EXPECT_TRUE(b.outdated("no-touch").empty());
}

TEST(Dependence, RecordsWithoutANoteAreJudgedByTheirOrder) {
  Bench b;
  b.noTouch("[101.5, 102.5, 103.5]");
  b.curve(2, "[1, 2, 3]", false);
  EXPECT_EQ(b.outdated("no-touch"), (Bases{{"ir", 2}}));
  b.set("sensing.ir_offset_mm", "[101, 102, 103]");  // changed since, by a tare: when, nobody knows
  EXPECT_TRUE(b.outdated("no-touch").empty());
}

TEST(Dependence, AStiffnessMapRestsOnWhatMeasuredIt) {
  Bench b;
  b.calibrate("encoders", 0, {{"control.encoder_zero_first_counts", "100"}});
  EXPECT_TRUE(b.outdated("stiffness").empty()) << "never measured is another matter";
  b.calibrate("stiffness", 0, {{"control.law", "interpolated"}});
  EXPECT_TRUE(b.outdated("stiffness").empty());
  b.calibrate("encoders", 0, {{"control.encoder_zero_first_counts", "200"}});
  b.calibrate("load-cell", 0, {{"sensing.force_slope_g", "1010"}, {"sensing.force_zero_N", "0"}});
  b.curve(1, "[1, 2, 3]");
  b.noTouch("[101.5, 102.5, 103.5]");  // taken each day: no reason to measure a map again
  EXPECT_EQ(b.outdated("stiffness"), (Bases{{"encoders", 0}, {"load-cell", 0}, {"ir", 1}}));
  EXPECT_EQ(describeBases("stiffness", b.outdated("stiffness")).text(),
            "measured with another calibration: measure it again (Encoders: sign, zero, range; Load cell; Distance "
            "sensor 1)");
  b.calibrate("stiffness", 0, {{"control.law", "interpolated"}});
  EXPECT_TRUE(b.outdated("stiffness").empty());
  for (const char* part : {"ir", "load-cell", "camera", "rest", ""}) EXPECT_TRUE(b.outdated(part).empty()) << part;
}

}  // namespace
}  // namespace fyd::calibration
