// The way to the finger, found from what the device tests see of the simulated one, which shares no formula with it.
#include "core/calibration/texture_calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/base/parameter.h"
#include "core/sim/touchpad/vibration_sweep.h"

namespace fyd::calibration {
namespace {

std::vector<texture::SweepRow> sweepOf(const sim::FingerVibrationParameters& parameters) {
  std::vector<texture::SweepRow> out;
  int part = 0;
  const auto add = [&](device::DeviceTest test, double stretch_deg) {
    const int before = part;
    for (texture::SweepRow row : sim::simulatedSweep(parameters, test, stretch_deg, 3)) {
      row.part = part = before + row.part;
      out.push_back(row);
      part = before;
    }
    part = out.back().part;
  };
  add(device::DeviceTest::breakaway, 20.0);
  add(device::DeviceTest::chirp, 31.0);
  add(device::DeviceTest::chirp, 79.0);
  return out;
}

TEST(TextureCalibration, FindsBreakawayThoughAMotorSticksWhereTheRampBeforeLeftIt) {
  for (const double breakaway : {5.0, 15.0, 25.0}) {
    sim::FingerVibrationParameters truth;
    truth.breakaway_percent = breakaway;
    truth.resonance_Hz = 60.0;
    truth.resonance_Hz_per_deg = 0.4;
    texture::FeltPlant profile;
    const TextureCalibration found = calibrateTexture(sweepOf(truth), profile);
    ASSERT_TRUE(found.result.verdict.accepted) << found.result.verdict.reason.text();
    const auto& motors = found.identified.breakaway;
    EXPECT_NEAR(motors[0].percent, breakaway, 0.1 * breakaway + 1.0);
    const double second = breakaway * truth.second_friction / truth.second_strength;
    EXPECT_NEAR(motors[1].percent, second, 0.1 * second + 1.0);
    for (const texture::FoundCloth& cloth : found.identified.cloths) {
      const double resonance_Hz = 60.0 + 0.4 * (cloth.stretch_deg - 45.0);
      EXPECT_NEAR(cloth.resonance_Hz, resonance_Hz, 0.05 * resonance_Hz) << breakaway;
    }
    ASSERT_TRUE(applyChanges(bindParameters(profile), found.result.changes));
    EXPECT_TRUE(profile.identified);
    EXPECT_NEAR(profile.resonance_Hz_per_deg, 0.4, 0.08);
    EXPECT_EQ(profile.free_speed_deg_s, texture::FeltPlant{}.free_speed_deg_s) << "nothing tells it";
  }
}

TEST(TextureCalibration, IsRefusedInWordsWithoutAnAccelerometer) {
  auto sweep = sweepOf({});
  for (texture::SweepRow& row : sweep) row.acceleration_g = kUnknown;
  const TextureCalibration found = calibrateTexture(sweep, {});
  EXPECT_FALSE(found.result.verdict.accepted);
  EXPECT_TRUE(found.result.changes.empty());
  EXPECT_THAT(found.result.verdict.reason.text(), testing::HasSubstr("accelerometer"));
}

/// The sweep, with the accelerations of the chirps multiplied by these factors, in order.
std::vector<texture::SweepRow> withChirpsTimes(std::vector<texture::SweepRow> sweep, double first, double second) {
  for (texture::SweepRow& row : sweep) row.acceleration_g *= row.stretch_deg < 50.0 ? first : second;
  return sweep;
}

TEST(TextureCalibration, HowTheAccelerometerLiesMakesNoDifference) {
  const auto sweep = sweepOf({});
  const TextureCalibration upright = calibrateTexture(sweep, {});
  ASSERT_TRUE(upright.result.verdict.accepted) << upright.result.verdict.reason.text();
  EXPECT_GT(upright.identified.plant.cloth_gain, 0.5);
  for (const auto& [first, second] : {std::pair(-1.0, -1.0), std::pair(1.0, -1.0), std::pair(-1.0, 1.0)}) {
    const TextureCalibration turned = calibrateTexture(withChirpsTimes(sweep, first, second), {});
    ASSERT_TRUE(turned.result.verdict.accepted) << turned.result.verdict.reason.text();
    EXPECT_NEAR(turned.identified.plant.cloth_gain, upright.identified.plant.cloth_gain, 1e-6);
  }
}

TEST(TextureCalibration, GainsThatDoNotAgreeOrCannotBeAreRefused) {
  const auto sweep = sweepOf({});
  const auto refusal = [&](double first, double second) {
    const TextureCalibration found = calibrateTexture(withChirpsTimes(sweep, first, second), {});
    EXPECT_FALSE(found.result.verdict.accepted);
    EXPECT_TRUE(found.result.changes.empty());
    return found.result.verdict.reason.text();
  };
  EXPECT_THAT(refusal(1.0, 0.3), testing::HasSubstr("within a factor of 2"));
  EXPECT_THAT(refusal(1.0, -4.0), testing::HasSubstr("within a factor of 2"));
  EXPECT_THAT(refusal(20.0, 20.0), testing::HasSubstr("texture.plant_cloth_gain"));
}

}  // namespace
}  // namespace fyd::calibration
