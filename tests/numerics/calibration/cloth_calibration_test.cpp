// The cloth's calibration with sensors that do not read.
#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/parameter.h"
#include "core/calibration/cloth_calibration.h"
#include "core/calibration/cloth_fit.h"
#include "core/sensing/contact_cloth.h"
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
  EXPECT_GT(two.stiffness_error, three.stiffness_error);

  // A touchpad that never had the third: nine places, 4 mm deep, with the presses' mean area.
  sensing::IndentationParameters pair = kProfile;
  ASSERT_TRUE(applyChanges(bindParameters(pair), std::span(two.result.changes).first(7)));
  pair.ir_x_mm = sensing::listOf(kProfile.ir_x_mm[0], kProfile.ir_x_mm[1]);
  pair.ir_y_mm = sensing::listOf(kProfile.ir_y_mm[0], kProfile.ir_y_mm[1]);
  double area_mm2 = 0.0;
  for (const double area : samples.area_mm2) area_mm2 += area / static_cast<double>(samples.area_mm2.size());
  sensing::ContactCloth cloth(pair);
  double squares = 0.0;
  for (const double x : {-25.0, 0.0, 25.0}) {
    for (const double y : {-17.5, 0.0, 17.5}) {
      const sensing::Contact contact{.x_mm = x, .y_mm = y, .area_mm2 = area_mm2};
      cloth.press(contact, 4.0);
      std::array<sensing::Drop, 2> drops;
      for (std::size_t i = 0; i < 2; ++i)
        drops[i] = {.drop_mm = 4.0 * cloth.share(i), .sigma_mm = kPressNoise_mm, .used = true};
      const sensing::ClothDepth depth = cloth.solve(contact, drops);
      squares += depth.variance_mm2 / (depth.indentation_mm * depth.indentation_mm) / 9;
    }
  }
  EXPECT_NEAR(two.stiffness_error, std::sqrt(squares), 1e-9);
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
