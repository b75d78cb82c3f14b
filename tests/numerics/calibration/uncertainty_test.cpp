// The stated standard uncertainty of every coefficient agrees with the spread of the coefficient over repeated
// calibrations of the same part with fresh noise.
#include <cmath>
#include <map>
#include <random>

#include <gtest/gtest.h>

#include "core/calibration/camera_calibration.h"
#include "core/calibration/encoder_calibration.h"
#include "core/calibration/load_cell_calibration.h"
#include "core/calibration/stiffness_map.h"
#include "tests/sweep.h"

namespace fyd::calibration {
namespace {

constexpr int kRepeats = 400;    // the spread itself is then known to 4 %
constexpr double kWithin = 1.5;  // factor

/// Collects the coefficients of many results.
class Spreads {
 public:
  void add(const CalibrationResult& result) {
    ASSERT_TRUE(result.verdict.accepted) << result.verdict.reason.text();
    for (const Coefficient& each : result.coefficients) {
      Seen& seen = seen_[each.name];
      ++seen.count;
      seen.sum += each.value;
      seen.squares += each.value * each.value;
      seen.stated_squares += each.standard_error * each.standard_error;
    }
  }
  void expectAsStated(std::size_t coefficients) const {
    EXPECT_EQ(seen_.size(), coefficients);
    for (const auto& [name, seen] : seen_) {
      const double mean = seen.sum / seen.count;
      const double spread = std::sqrt((seen.squares / seen.count - mean * mean) * seen.count / (seen.count - 1));
      const double stated = std::sqrt(seen.stated_squares / seen.count);
      EXPECT_LT(stated, kWithin * spread) << name;
      EXPECT_GT(stated, spread / kWithin) << name;
    }
  }

 private:
  struct Seen {
    double count = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    double stated_squares = 0.0;
  };
  std::map<std::string, Seen> seen_;
};

std::mt19937_64& chance() {
  static std::mt19937_64 random(2014);
  return random;
}
double noise(double sigma) { return std::normal_distribution<double>(0.0, sigma)(chance()); }

TEST(Uncertainty, OfTheLoadCellIsItsSpread) {
  Spreads spreads;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    LoadCellSamples samples;
    for (const double force_N : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 5.0, 4.0, 3.0, 2.0, 1.0, 0.0}) {
      samples.value_mV_per_V.push_back((force_N + 0.2) / 9.85 + noise(0.001));
      samples.force_N.push_back(force_N);
    }
    spreads.add(calibrateLoadCell(samples, {}).result);
  }
  spreads.expectAsStated(2);
}

TEST(Uncertainty, OfTheCamerasScaleIsItsSpread) {
  Spreads spreads;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    CameraSamples samples;
    for (const double x_px : stepsTo(50, 250, 50)) {
      for (const double y_px : stepsTo(50, 190, 35)) {
        samples.x_px.push_back(x_px);
        samples.y_px.push_back(y_px);
        samples.x_mm.push_back(0.4545 * (x_px - 150) + noise(0.05));
        samples.y_mm.push_back(-0.4667 * (y_px - 120) + noise(0.05));
      }
    }
    spreads.add(calibrateCamera(samples, {}).result);
  }
  spreads.expectAsStated(4);
}

TEST(Uncertainty, OfTheStiffnessMapIsItsSpread) {
  Spreads spreads;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    StiffnessSamples samples;
    for (const auto& [angle_deg, k] : {std::pair{20.0, 0.45}, {45.0, 0.55}, {70.0, 0.65}, {90.0, 0.75}}) {
      for (const double depth_mm : {2.0, 3.5, 5.0, 6.5}) {
        samples.angle_deg.push_back(angle_deg);
        samples.indentation_mm.push_back(depth_mm);
        samples.force_N.push_back(k * depth_mm + 0.05 + noise(0.03));
      }
    }
    spreads.add(calibrateStiffness(samples, {}).result);
  }
  spreads.expectAsStated(4);
}

TEST(Uncertainty, OfTheEncodersIsTheirSpread) {
  Spreads spreads;
  for (int repeat = 0; repeat < kRepeats; ++repeat) {
    EncoderSamples samples;
    for (const double deg : stepsTo(0, 60, 5)) {
      for (const std::size_t motor : {std::size_t{0}, std::size_t{1}}) {
        samples.command_deg[motor].push_back(deg);
        samples.counts[motor].push_back(1000.0 + 4096.0 / 360.0 * deg + noise(2.0));
      }
    }
    spreads.add(calibrateEncoders(samples, {}).result);
  }
  spreads.expectAsStated(4);
}

}  // namespace
}  // namespace fyd::calibration
