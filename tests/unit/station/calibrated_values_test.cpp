// Whose calibrated values a session uses: the simulation's never with a real touchpad, one touchpad's never with
// another, and everyone's own again when it comes back.
#include "core/station/profile/calibrated_values.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/calibration/calibration_part.h"
#include "core/station/profile/calibration_file.h"
#include "core/station/profile/touchpad_name.h"
#include "tests/temporary_folder.h"

namespace fyd::station {
namespace {

using testing::HasSubstr;

constexpr double kUsual_g = 1004.8805;  // default slope of the load cell

class CalibratedValues : public testing::Test {
 protected:
  [[nodiscard]] std::string path() const { return folder_.file("lab.toml"); }
  /// As "Accept" does it in a session on this touchpad.
  void calibrate(const std::string& touchpad, double slope_g) {
    auto loaded = loadProfileFor(path(), touchpad);
    ASSERT_TRUE(loaded) << loaded.error().text();
    const auto saved = saveCalibration(result(slope_g), {.who = "A"}, loaded->profile, path());
    ASSERT_TRUE(saved) << saved.error().text();
    EXPECT_EQ(saved->touchpad, touchpad);
    EXPECT_EQ(saved->simulated, isSimulated(touchpad));
  }
  static calibration::CalibrationResult result(double slope_g) {
    calibration::CalibrationResult out{.procedure = "load-cell", .unit = "N"};
    out.changes = {{"sensing.force_slope_g", fmt::format("{}", slope_g)}};
    out.verdict = {.accepted = true};
    return out;
  }
  [[nodiscard]] TouchpadProfile load(const std::string& touchpad) const {
    auto loaded = loadProfileFor(path(), touchpad);
    EXPECT_TRUE(loaded) << loaded.error().text();
    return loaded ? *loaded : TouchpadProfile{};
  }
  [[nodiscard]] double slope(const std::string& touchpad) const {
    return load(touchpad).profile.step.sensing.load_cell.slope_g_per_mV_per_V;
  }

  Folder folder_;
};

TEST_F(CalibratedValues, OfTheSimulationAreNeverARealTouchpads) {
  calibrate("simulated", 700.0);
  EXPECT_EQ(slope("simulated"), 700.0);
  EXPECT_EQ(slope("serial:A"), kUsual_g);
  EXPECT_EQ(slope(""), kUsual_g) << "nor of one that does not answer yet";
  calibrate("serial:A", 900.0);
  EXPECT_EQ(slope("serial:A"), 900.0);
  EXPECT_EQ(slope("simulated"), 700.0);
  const auto records = loadCalibrationRecords(path());
  ASSERT_TRUE(records);
  EXPECT_EQ(recordsFor(*records, "simulated").size(), 1U);
  EXPECT_EQ(recordsFor(*records, "serial:A").size(), 1U);
  EXPECT_EQ(recordsFor(*records, "serial:B").size(), 0U);
}

TEST_F(CalibratedValues, OfAnotherTouchpadAreSetAsideByName) {
  calibrate("serial:A", 900.0);
  const TouchpadProfile other = load("serial:B");
  EXPECT_EQ(other.profile.step.sensing.load_cell.slope_g_per_mV_per_V, kUsual_g);
  EXPECT_TRUE(other.set_aside);
  EXPECT_THAT(other.notice.text(), HasSubstr("lab.toml"));
  EXPECT_THAT(other.notice.text(), HasSubstr("the touchpad with serial number A"));
  EXPECT_THAT(other.notice.text(), HasSubstr("the touchpad with serial number B"));
  EXPECT_THAT(other.notice.text(), HasSubstr("Load cell"));
  calibrate("serial:B", 800.0);
  EXPECT_EQ(slope("serial:B"), 800.0);
  EXPECT_FALSE(load("serial:B").set_aside);
  EXPECT_EQ(slope("serial:A"), 900.0);
  EXPECT_TRUE(load("simulated").set_aside);
}

TEST_F(CalibratedValues, TheSettingsAreEveryTouchpads) {
  calibrate("serial:A", 900.0);
  Profile simulated = load("simulated").profile;
  simulated.step.control.kp = 0.125;
  simulated.step.sensing.load_cell.zero_N = 0.5;  // a tare on the simulation
  ASSERT_TRUE(saveProfileFor(simulated, path()));
  const Profile real = load("serial:A").profile;
  EXPECT_EQ(real.step.control.kp, 0.125);
  EXPECT_EQ(real.step.sensing.load_cell.zero_N, 0.0);
  EXPECT_EQ(real.step.sensing.load_cell.slope_g_per_mV_per_V, 900.0);
  EXPECT_EQ(load("simulated").profile.step.sensing.load_cell.zero_N, 0.5);
}

TEST_F(CalibratedValues, AnEarlierProfileIsKeptButNotWhatTheSimulationWrote) {
  Profile former;
  former.step.sensing.load_cell.slope_g_per_mV_per_V = 900.0;
  former.step.sensing.indentation.ir_lowest_code[0] = 600.0;
  former.step.sensing.indentation.ir_lowest_code[1] = 700.0;
  ASSERT_TRUE(saveProfile(former, path()));
  const auto fields = [](const char* procedure, int sensor, const char* conditions) {
    return fmt::format(
        "[[record]]\nprocedure = '{}'\nsensor = {}\nwho = ''\nwhen = '2026-08-01T09:30:00Z'\nconditions = '{}'\n"
        "curve = ''\nunit = 'N'\nverdict = ''\npoints = 3\noutliers = 0\nrmse = 0.1\nheld_out_rmse = 0.1\n"
        "max_residual = 0.1\ncondition_number = 1.0\nresiduals = []\n",
        procedure, sensor, conditions);
  };
  const std::string measured =
      "[[record.change]]\nid = 'sensing.ir_lowest_code'\nbefore = '[524, 524, 524]'\n"
      "after = '[600, 524, 524]'\n";
  const std::string simulated =
      "[[record.change]]\nid = 'sensing.ir_lowest_code'\nbefore = '[600, 524, 524]'\n"
      "after = '[600, 700, 524]'\n";
  const std::string cell = "[[record.change]]\nid = 'sensing.force_slope_g'\nbefore = '1004.8805'\nafter = '900'\n";
  std::ofstream(calibrationFileOf(path()))
      << "format = 1\n"
      << fields("ir", 1, "") << measured << fields("ir", 2, "simulated points; lamp off") << simulated
      << fields("load-cell", 0, "21 C") << cell;

  const TouchpadProfile real = load("serial:A");
  EXPECT_EQ(real.profile.step.sensing.load_cell.slope_g_per_mV_per_V, 900.0);
  EXPECT_EQ(real.profile.step.sensing.indentation.ir_lowest_code[0], 600.0);
  EXPECT_EQ(real.profile.step.sensing.indentation.ir_lowest_code[1], 524.0);
  EXPECT_TRUE(real.set_aside);
  EXPECT_THAT(real.notice.text(), HasSubstr("simulated"));
  EXPECT_EQ(load("simulated").profile.step.sensing.indentation.ir_lowest_code[1], 700.0);
  ASSERT_TRUE(saveProfileFor(real.profile, path()));
  EXPECT_EQ(load("serial:A").notice.text(), "");
  EXPECT_EQ(slope("serial:B"), kUsual_g);
}

TEST_F(CalibratedValues, SimulatedPointsAndRecordingsAreRefused) {
  auto loaded = loadProfileFor(path(), "serial:A");
  ASSERT_TRUE(loaded);
  const auto simulated = saveCalibration(result(700.0), {.simulated = true}, loaded->profile, path());
  ASSERT_FALSE(simulated);
  EXPECT_THAT(simulated.error().text(), HasSubstr("simulated points"));
  loaded = loadProfileFor(path(), "recording");
  ASSERT_TRUE(loaded);
  EXPECT_FALSE(saveCalibration(result(700.0), {}, loaded->profile, path()));
  calibration::CalibrationResult setting = result(700.0);
  setting.changes = {{"control.kp", "1"}};
  loaded = loadProfileFor(path(), "serial:A");
  EXPECT_FALSE(saveCalibration(setting, {}, loaded->profile, path())) << "a setting is no calibrated value";
  EXPECT_FALSE(std::filesystem::exists(path()));
}

TEST(TouchpadName, TellsWhatItIs) {
  EXPECT_TRUE(isSimulated("simulated"));
  EXPECT_TRUE(isSimulated(touchpadName("simulated", "qbmove:/dev/ttyUSB0")));
  EXPECT_FALSE(isSimulated("serial:simulated"));
  EXPECT_EQ(serialIn("serial:A7 with qbmove:id=B2"), "A7");
  EXPECT_EQ(serialIn("modbus-tcp:10.0.0.7:502"), "");
  EXPECT_EQ(valuesFileOf("x/lab.toml", "simulated"), "x/lab.simulated.toml");
  EXPECT_NE(valuesFileOf("lab.toml", "serial:A/B"), valuesFileOf("lab.toml", "serial:A-B"));
  EXPECT_EQ(valuesFileOf("lab.toml", "serial:../x").find('/'), std::string::npos);
}

}  // namespace
}  // namespace fyd::station
