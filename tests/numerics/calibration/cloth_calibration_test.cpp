// The cloth's calibration with sensors that do not read.
#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/parameter.h"
#include "core/calibration/cloth_calibration.h"
#include "core/sensing/ir_distance.h"
#include "core/sim/touchpad/cloth_presses.h"

namespace fyd::calibration {
namespace {

const sensing::IndentationParameters kProfile;
constexpr std::array<double, 3> kDepths_mm{2.0, 4.0, 6.0};

/// The simulated cloth pressed over each sensor, without noise.
ClothSamples pressedCloth() {
  const sensing::IrDistance curve;
  ClothSamples samples;
  for (const sim::ClothPress& press : sim::pressesOverSensors(sim::SimParameters(), 45.0, kDepths_mm)) {
    std::vector<double> codes;
    for (std::size_t i = 0; i < press.deflection_mm.size(); ++i) {
      const double volts = curve.voltsAt(kProfile.ir_offset_mm[i] - press.deflection_mm[i]);
      codes.push_back(volts * sensing::kAdcCodes / sensing::kAdcReference_V);
    }
    samples.codes.push_back(codes);
    samples.x_mm.push_back(press.contact.x_mm);
    samples.y_mm.push_back(press.contact.y_mm);
    samples.area_mm2.push_back(press.contact.area_mm2);
  }
  return samples;
}

TEST(ClothCalibration, ADeadSensorMakesTheLastingErrorThatOfTheOthers) {
  ClothSamples samples = pressedCloth();
  const ClothCalibration three = calibrateCloth(samples, kProfile, {});
  ASSERT_TRUE(three.result.verdict.accepted) << three.result.verdict.reason.text();
  for (auto& press : samples.codes) press[2] = std::nan("");
  const ClothCalibration two = calibrateCloth(samples, kProfile, {});
  ASSERT_TRUE(two.result.verdict.accepted) << two.result.verdict.reason.text();

  // A touchpad that never had the third, pressed over the others: it has no other lasting error, but for its presses' mean
  // area, which is that of six.
  sensing::IndentationParameters pair = kProfile;
  pair.ir_x_mm = sensing::listOf(kProfile.ir_x_mm[0], kProfile.ir_x_mm[1]);
  pair.ir_y_mm = sensing::listOf(kProfile.ir_y_mm[0], kProfile.ir_y_mm[1]);
  ClothSamples without_third;
  for (std::size_t i = 0; i < samples.codes.size(); ++i) {
    const auto from_mm = [&](std::size_t sensor) {
      return std::hypot(samples.x_mm[i] - kProfile.ir_x_mm[sensor], samples.y_mm[i] - kProfile.ir_y_mm[sensor]);
    };
    if (from_mm(2) < std::min(from_mm(0), from_mm(1))) continue;
    without_third.codes.push_back({samples.codes[i][0], samples.codes[i][1]});
    without_third.x_mm.push_back(samples.x_mm[i]);
    without_third.y_mm.push_back(samples.y_mm[i]);
    without_third.area_mm2.push_back(samples.area_mm2[i]);
  }
  ASSERT_EQ(without_third.codes.size(), 2 * kDepths_mm.size());
  const ClothCalibration of_pair = calibrateCloth(without_third, pair, {});
  ASSERT_TRUE(of_pair.result.verdict.accepted) << of_pair.result.verdict.reason.text();
  EXPECT_NEAR(two.stiffness_error, of_pair.stiffness_error, 0.03 * of_pair.stiffness_error);
  EXPECT_GT(two.stiffness_error, 1.2 * three.stiffness_error);
}

TEST(ClothCalibration, OfAProfileThatListsMoreSensorsThanThereMayBeTheFirstEightCount) {
  const ClothSamples samples = pressedCloth();
  sensing::IndentationParameters longer = kProfile;
  while (longer.ir_x_mm.push(40.0) && longer.ir_y_mm.push(30.0) && longer.ir_offset_mm.push(100.0)) {
  }
  ASSERT_GT(longer.ir_x_mm.size(), sensing::kMaximumIrSensors);
  const ClothCalibration found = calibrateCloth(samples, longer, {});
  EXPECT_EQ(found.sensors.size(), sensing::kMaximumIrSensors);
}

TEST(ClothCalibration, APressThatOnlyTheSensorUnderTheFingerReadsHasNoErrorAndSpoilsNone) {
  ClothSamples samples = pressedCloth();
  samples.codes[0][1] = samples.codes[0][2] = std::nan("");  // the first press is over the first sensor
  const ClothCalibration found = calibrateCloth(samples, kProfile, {});
  ASSERT_TRUE(std::isfinite(found.result.rmse)) << found.result.verdict.reason.text();
  EXPECT_TRUE(std::isnan(found.result.residuals[0]));
  EXPECT_GE(found.result.max_residual, found.result.rmse);
}

}  // namespace
}  // namespace fyd::calibration
