// Paths of the simulated finger: recorded hands, demonstration, constant press.
#include "core/sim/finger_path.h"
#include "tests/sweep.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace fyd::sim {
namespace {

class Recording : public ::testing::Test {
 protected:
  ~Recording() override { std::filesystem::remove(path_); }

  Result<FingerPath> load(const std::string& text) const {
    std::ofstream(path_) << text;
    return FingerPath::fromCsv(path_);
  }
  std::string errorOf(const std::string& rows) const {
    const auto path = load("t_s,x_mm,y_mm,z_mm\n" + rows);
    if (path) return "accepted";
    std::string message = path.error().text();
    if (message.starts_with(path_)) message.erase(0, path_.size());
    return message;
  }

  const std::string path_ =
      (std::filesystem::temp_directory_path() / fmt::format("fyd_finger_{}.csv", ::getpid())).string();
};

TEST_F(Recording, OneThatFitsIsTakenAsItStands) {
  const auto path = load("t_s,x_mm,y_mm,z_mm\n5,-10,4,-2\n6,10,8,-4\n7,10,8,1\n");
  ASSERT_TRUE(path) << path.error().text();
  EXPECT_EQ(path->at(0.0).x_mm, -10.0);
  EXPECT_EQ(path->at(0.0).indentation_mm, 2.0);
  const FingerState half = path->at(0.5);
  EXPECT_DOUBLE_EQ(half.x_mm, 0.0);
  EXPECT_DOUBLE_EQ(half.y_mm, 6.0);
  EXPECT_DOUBLE_EQ(half.indentation_mm, 3.0);
  EXPECT_FALSE(half.lifted);
  EXPECT_TRUE(path->at(2.0).lifted) << "z > 0 is above the cloth";
}

TEST_F(Recording, TheClothIsMetWhereTheLineMeetsIt) {
  const auto path = load("t_s,x_mm,y_mm,z_mm\n0,-10,0,1\n1,10,0,-4\n2,10,0,1\n");
  ASSERT_TRUE(path) << path.error().text();
  EXPECT_TRUE(path->at(0.19).lifted);
  EXPECT_EQ(path->at(0.19).indentation_mm, 0.0);
  EXPECT_NEAR(path->at(0.1).x_mm, -8.0, 1e-12);
  EXPECT_FALSE(path->at(0.21).lifted);
  EXPECT_NEAR(path->at(0.6).indentation_mm, 2.0, 1e-12);
  EXPECT_NEAR(path->at(1.4).indentation_mm, 2.0, 1e-12);
  EXPECT_TRUE(path->at(1.81).lifted);
}

TEST_F(Recording, AnyOtherIsScaledByOneFactorIntoTheUsableArea) {
  // 180 × 60 mm: x decides, factor 0.5, centre (1090, −30); z 100…200, of 11 samples the lowest 8 touch (0.7·10 = rank
  // 7)
  std::string text = "t_s,x_mm,y_mm,z_mm\n";
  for (int i = 0; i <= 10; ++i) text += fmt::format("{},{},{},{}\n", 0.1 * i, 1000 + 18 * i, -60 + 6 * i, 100 + 10 * i);
  const auto path = load(text);
  ASSERT_TRUE(path) << path.error().text();
  EXPECT_NEAR(path->at(0.0).x_mm, -45.0, 1e-9);
  EXPECT_NEAR(path->at(0.0).y_mm, -15.0, 1e-9);
  EXPECT_NEAR(path->at(0.0).indentation_mm, 8.0, 1e-9) << "the lowest point is the deepest press";
  EXPECT_NEAR(path->at(0.35).indentation_mm, 4.0, 1e-9) << "half way to the touch height of 170";
  EXPECT_TRUE(path->at(0.8).lifted);
  EXPECT_TRUE(path->at(1.0).lifted);
  EXPECT_NEAR(path->at(1.0).x_mm, 45.0, 1e-9);
}

TEST_F(Recording, ARowOfNaNsIsALiftedFingerThatStaysWhereItWas) {
  const auto path = load("t_s,x_mm,y_mm,z_mm\n0,1,2,-3\n1,nan,NaN,nan\n2,5,6,-3\n");
  ASSERT_TRUE(path) << path.error().text();
  EXPECT_FALSE(path->at(0.5).lifted) << "until the row that says lifted";
  EXPECT_EQ(path->at(0.5).x_mm, 1.0) << "no motion towards a row without a place";
  EXPECT_TRUE(path->at(1.5).lifted);
  EXPECT_EQ(path->at(1.5).x_mm, 1.0);
  EXPECT_EQ(path->at(1.5).indentation_mm, 0.0);
  EXPECT_EQ(path->at(2.0).x_mm, 5.0);
}

TEST_F(Recording, RefusesWithFileAndLine) {
  EXPECT_EQ(errorOf("0,1,2,-3\n1,nan,2,-3\n"),
            ":3: 1 of x_mm, y_mm, z_mm are NaN; all three mean a lifted finger, otherwise none may be");
  EXPECT_EQ(errorOf("0,1,2,-3\nnan,1,2,-3\n"), ":3: t_s is nan; expected a time in seconds");
  EXPECT_EQ(errorOf("0,1,2,-3\n1,1,2,-3\n\n1,1,2,-3\n"), ":5: t_s is 1 after 1; time must increase from row to row");
  EXPECT_EQ(errorOf("2,1,2,-3\n1,1,2,-3\n"), ":3: t_s is 1 after 2; time must increase from row to row");
  EXPECT_EQ(errorOf("0,inf,2,-3\n"), ":2: x_mm is inf; expected millimetres within ±1000000");
  EXPECT_EQ(errorOf("0,1,2e300,-3\n"), ":2: y_mm is 2e+300; expected millimetres within ±1000000");
  EXPECT_EQ(errorOf("0,1,two,-3\n"), ":2: column y_mm: 'two' is not a number");
  EXPECT_EQ(errorOf(""), ": a header but no rows");
  EXPECT_FALSE(load("t_s,x_mm,y_mm\n0,1,2\n"));
  EXPECT_FALSE(FingerPath::fromCsv("/nonexistent/finger.csv"));
}

TEST_F(Recording, RepeatsAfterTheEndWithTheFingerLiftedInBetween) {
  const auto path = load("t_s,x_mm,y_mm,z_mm\n0,1,2,-3\n1,2,2,-3\n");
  ASSERT_TRUE(path);
  EXPECT_EQ(path->duration_s(), 1.5);
  EXPECT_FALSE(path->at(1.0).lifted);
  EXPECT_TRUE(path->at(1.25).lifted) << "no jump across the cloth while pressing";
  EXPECT_NEAR(path->at(150.5).x_mm, 1.5, 1e-9);
}

TEST_F(Recording, ConstantAndEmptyHandsAreFine) {
  const auto one = load("t_s,x_mm,y_mm,z_mm\n0,500,600,700\n");
  ASSERT_TRUE(one);
  EXPECT_EQ(one->at(3.0).x_mm, 0.0);
  EXPECT_EQ(one->at(3.0).indentation_mm, 8.0);
  const auto lifted = load("t_s,x_mm,y_mm,z_mm\n0,nan,nan,nan\n1,nan,nan,nan\n");
  ASSERT_TRUE(lifted);
  EXPECT_TRUE(lifted->at(0.5).lifted);
}

TEST(RealHand, PressesAndLiftsWithinTheUsableArea) {
  const auto path = FingerPath::fromCsv(FYD_TEST_DATA "/hand_motion/index_tip.csv");
  ASSERT_TRUE(path) << path.error().text();
  EXPECT_EQ(path->rows(), 6000U);
  int pressing = 0;
  double deepest = 0.0;
  double widest = 0.0;
  const std::vector<double> times_s = stepsBefore(0.0, 59.9, 0.01);
  for (const double t : times_s) {
    const FingerState finger = path->at(t);
    ASSERT_LE(std::abs(finger.x_mm), kUsableHalfWidth_mm + 1e-9);
    ASSERT_LE(std::abs(finger.y_mm), kUsableHalfDepth_mm + 1e-9);
    ASSERT_TRUE(finger.indentation_mm >= 0.0 && finger.indentation_mm <= kDeepestPress_mm);
    ASSERT_EQ(finger.lifted, finger.indentation_mm == 0.0);
    pressing += finger.lifted ? 0 : 1;
    deepest = std::max(deepest, finger.indentation_mm);
    widest = std::max(widest, std::abs(finger.x_mm));
  }
  EXPECT_NEAR(static_cast<double>(pressing) / static_cast<double>(times_s.size()), 0.7, 0.02);
  EXPECT_NEAR(deepest, 8.0, 1e-6);
  EXPECT_NEAR(widest, 45.0, 1e-3);
}

TEST(Demonstration, PressesStrokesLiftsAndIsSmooth) {
  const FingerPath path = FingerPath::demonstration();
  EXPECT_NEAR(path.duration_s(), 16.0, 1e-12);
  int touches = 0;
  bool was_lifted = true;
  FingerState last = path.at(0.0);
  for (int i = 0; i < 32'000; ++i) {
    const FingerState finger = path.at(i * 1e-3);
    if (was_lifted && !finger.lifted) ++touches;
    was_lifted = finger.lifted;
    if (!finger.lifted && !last.lifted) {
      ASSERT_LT(std::hypot(finger.x_mm - last.x_mm, finger.y_mm - last.y_mm), 0.1) << "slower than 100 mm/s at " << i;
      ASSERT_LT(std::abs(finger.indentation_mm - last.indentation_mm), 0.05);
    }
    last = finger;
  }
  EXPECT_EQ(touches, 10) << "five in each round";
}

TEST(ConstantPress, IsClampedAndNeverNaN) {
  EXPECT_EQ(FingerPath::constant(3, -4, 5).at(1e9).indentation_mm, 5.0);
  EXPECT_EQ(FingerPath::constant(300, -400, 50).at(0).x_mm, 45.0);
  EXPECT_EQ(FingerPath::constant(300, -400, 50).at(0).y_mm, -30.0);
  EXPECT_EQ(FingerPath::constant(300, -400, 50).at(0).indentation_mm, 8.0);
  EXPECT_TRUE(FingerPath::constant(0, 0, 0).at(0).lifted);
  const FingerState nan = FingerPath::constant(std::nan(""), std::nan(""), std::nan("")).at(std::nan(""));
  EXPECT_EQ(nan.x_mm, 0.0);
  EXPECT_TRUE(nan.lifted);
}

}  // namespace
}  // namespace fyd::sim
