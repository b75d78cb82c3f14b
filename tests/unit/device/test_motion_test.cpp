// The motions behind the test buttons of the place "Devices", and the setting of a camera's controls.
#include "core/device/touchpad/test_motion.h"

#include <cmath>
#include <limits>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/videoio.hpp>

#include "core/device/camera/camera_controls.h"

namespace fyd::device {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr std::array<double, 2> kRest = {31.0, -29.0};
Duration ms(int n) { return std::chrono::milliseconds(n); }

class EveryTest : public testing::TestWithParam<DeviceTest> {};
INSTANTIATE_TEST_SUITE_P(Tests, EveryTest,
                         testing::Values(DeviceTest::motor_1, DeviceTest::motor_2, DeviceTest::vibration));

TEST_P(EveryTest, StartsAndEndsAtRestAndStaysSmallSlowAndWeak) {
  const auto motion = TestMotion::plan(GetParam(), kRest, 120.0);
  ASSERT_TRUE(motion);
  EXPECT_FALSE(motion->at(ms(-1)));
  EXPECT_FALSE(motion->at(motion->length()));
  EXPECT_LT(motion->length(), std::chrono::seconds(5));
  auto before = kRest;
  double furthest = 0.0;
  double strongest = 0.0;
  for (Duration t{}; t < motion->length(); t += ms(1)) {
    const auto command = motion->at(t);
    ASSERT_TRUE(command);
    EXPECT_TRUE(command->active);
    const auto angles = motion->anglesAt(t);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_LE(std::abs(angles[i] - before[i]), 1.6e-3) << "1.6°/s";
      EXPECT_NEAR(command->reference_ticks[i], angles[i] * control::kTicksPerDegree, 0.51);
      furthest = std::max(furthest, std::abs(angles[i] - kRest[i]));
      strongest = std::max(strongest, std::abs(command->vibration_duty_percent[i]));
    }
    before = angles;
  }
  EXPECT_NEAR(before[0], kRest[0], 1e-9);
  EXPECT_NEAR(before[1], kRest[1], 1e-9);
  const bool vibration = GetParam() == DeviceTest::vibration;
  EXPECT_NEAR(furthest, vibration ? 0.0 : kTestTravel_deg, 1e-6);
  EXPECT_NEAR(strongest, vibration ? kTestDuty_percent : 0.0, 0.6);
  EXPECT_LE(strongest, kTestDuty_percent);
}

TEST(TestMotion, OnlyTheMotorThatWasAskedForMoves) {
  const auto motion = TestMotion::plan(DeviceTest::motor_2, kRest, 120.0);
  EXPECT_EQ(motion->anglesAt(ms(2300))[0], kRest[0]);
  EXPECT_NEAR(motion->anglesAt(ms(2300))[1], kRest[1] + 2.0, 1e-6);
}

TEST(TestMotion, AtTheLimitItGoesInwardAndBeyondItNotAtAll) {
  const auto motion = TestMotion::plan(DeviceTest::motor_1, {119.5, 0.0}, 120.0);
  ASSERT_TRUE(motion);
  EXPECT_NEAR(motion->anglesAt(ms(2300))[0], 117.5, 1e-6);
  EXPECT_THAT(TestMotion::plan(DeviceTest::motor_1, {0.0, -121.0}, 120.0).error().text(),
              HasSubstr("motor 2 stands at -121"));
  EXPECT_FALSE(TestMotion::plan(DeviceTest::vibration, {std::nan(""), 0.0}, 120.0));
  EXPECT_FALSE(TestMotion::plan(static_cast<DeviceTest>(9), kRest, 120.0));
}

TEST(TestMotion, StretchGoesThereSlowlyFromWhereverTheMotorsStandAndWaits) {
  const auto motion = TestMotion::plan(DeviceTest::stretch, kRest, 120.0, 60.0);
  ASSERT_TRUE(motion);
  EXPECT_EQ(motion->anglesAt(ms(0)), kRest);
  auto before = kRest;
  Duration there{};
  for (Duration t{}; t < motion->length(); t += ms(1)) {
    const auto angles = motion->anglesAt(t);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_LE(std::abs(angles[i] - before[i]), 16e-3) << "16°/s";
    EXPECT_FALSE(motion->restsAt(t) && angles != motion->anglesAt(t - ms(300)));
    if (there == Duration{} && t > ms(500) && motion->restsAt(t)) there = t;
    before = angles;
  }
  EXPECT_NEAR(before[0], 60.0, 1e-9);
  EXPECT_NEAR(before[1], -60.0, 1e-9);
  EXPECT_LT(there, std::chrono::seconds(5));
  EXPECT_GE(motion->length() - there, std::chrono::seconds(59)) << "long enough to press";
  EXPECT_FALSE(motion->at(motion->length()));
  EXPECT_FALSE(TestMotion::plan(DeviceTest::stretch, kRest, 120.0, 121.0));
  EXPECT_FALSE(TestMotion::plan(DeviceTest::stretch, kRest, 120.0, std::nan("")));
}

TEST(TestMotion, ASweepClimbsByStepsAndComesBackAndNeedsNoEncoder) {
  const auto motion = TestMotion::plan(DeviceTest::sweep, {std::nan(""), 170.0}, 120.0);
  ASSERT_TRUE(motion);
  EXPECT_FALSE(motion->restsAt(ms(590))) << "the drive is still switching on";
  std::vector<double> rests;
  for (Duration t{}; t < motion->length(); t += ms(1)) {
    const auto angles = motion->anglesAt(t);
    EXPECT_EQ(angles[1], -angles[0]);
    if (motion->restsAt(t) && (rests.empty() || rests.back() != angles[0])) rests.push_back(angles[0]);
  }
  EXPECT_EQ(rests, (std::vector<double>{0, 5, 10, 15, 20, 25, 30, 25, 20, 15, 10, 5, 0}));
}

TEST(TestMotion, ASweepThatWouldPassTheMotorsLimitIsRefused) {
  EXPECT_TRUE(TestMotion::plan(DeviceTest::sweep, kRest, kSweepTop_deg));
  EXPECT_EQ(TestMotion::plan(DeviceTest::sweep, kRest, 20.0).error().text(),
            "stretch 30°: beyond control.motor_limit_deg = 20");
}

/// A camera whose driver knows some controls.
struct Driver {
  std::map<int, double> share;
  std::vector<int> set_in_order;
  ControlAccess access() {
    return {.set =
                [this](int what, double value) {
                  set_in_order.push_back(what);
                  if (!share.contains(what)) return false;
                  share[what] = value;
                  return true;
                },
            .get = [this](int what) { return share.contains(what) ? share[what] : 0.0; }};
  }
};

TEST(CameraControls, WhatIsWantedIsSetReadBackAndSaid) {
  Driver driver{
      .share = {{cv::CAP_PROP_BRIGHTNESS, 0.5}, {cv::CAP_PROP_EXPOSURE, 0.1}, {cv::CAP_PROP_AUTO_EXPOSURE, 0.75}}};
  const auto controls =
      applyControls({.brightness_percent = 100, .contrast_percent = 100, .exposure_percent = 20}, driver.access());
  ASSERT_EQ(controls.size(), 3U);
  EXPECT_EQ(controls[0].words.text(), "set to 100 %");
  EXPECT_EQ(controls[0].actual, 100.0);
  EXPECT_TRUE(controls[0].supported);
  EXPECT_FALSE(controls[1].supported);
  EXPECT_THAT(controls[1].words.text(), HasSubstr("has none"));
  EXPECT_NEAR(controls[2].actual, 20.0, 1e-9);
  EXPECT_EQ(driver.share[cv::CAP_PROP_AUTO_EXPOSURE], 0.25) << "manual, before the exposure is set";
  EXPECT_EQ(missingControls(controls).text(), "contrast: this camera has none, or refuses the value");
}

TEST(CameraControls, WhatIsNotWantedIsLeftAlone) {
  Driver driver{.share = {{cv::CAP_PROP_BRIGHTNESS, 0.5}}};
  const auto controls = applyControls(cameraSettings({}), driver.access());
  EXPECT_THAT(driver.set_in_order, IsEmpty());
  EXPECT_EQ(controls[0].words.text(), "left as it is");
  EXPECT_EQ(controls[0].actual, 50.0);
  EXPECT_FALSE(controls[1].supported);
  EXPECT_EQ(missingControls(controls).text(), "");
}

TEST(CameraControls, ASourceWithoutThemSaysSoForWhatIsWanted) {
  const auto controls = noControls({.brightness_percent = 40}, say("a video file has none"));
  EXPECT_EQ(missingControls(controls).text(), "brightness: a video file has none");
  EXPECT_EQ(controls[0].wanted, 40.0);
  EXPECT_TRUE(std::isnan(controls[1].wanted));
}

TEST(CameraControls, AValueThatTheCameraChangedIsSaid) {
  Driver driver{.share = {{cv::CAP_PROP_CONTRAST, 0.5}}};
  ControlAccess access = driver.access();
  access.set = [](int, double) { return true; };  // grants and does nothing
  const auto controls = applyControls({.contrast_percent = 90}, access);
  EXPECT_EQ(controls[1].words.text(), "asked for 90 %, the camera took 50 %");
}

}  // namespace
}  // namespace fyd::device
