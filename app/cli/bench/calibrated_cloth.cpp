#include "app/cli/bench/calibrated_cloth.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "core/base/parameter.h"
#include "core/calibration/cloth_calibration.h"
#include "core/sensing/ir_distance.h"
#include "core/sim/cloth.h"

namespace fyd::bench {
namespace {

constexpr double kMeanNoise_mV = 0.4;  // of readings of 10 mV averaged over 11 s at 60 Hz
constexpr double kAngle_deg = 45.0;
constexpr std::array<double, 3> kDepths_mm{2.0, 4.0, 6.0};

}  // namespace

pipeline::Parameters calibratedOn(const sim::SimParameters& parameters) {
  pipeline::Parameters out;
  const sensing::IndentationParameters& indentation = out.sensing.indentation;
  const sensing::IrDistance curve;
  sim::Cloth cloth(parameters);
  std::mt19937_64 random(11);
  std::normal_distribution<double> noise_V(0.0, 1e-3 * kMeanNoise_mV);
  calibration::ClothSamples samples;
  for (std::size_t over = 0; over < indentation.ir_x_mm.size(); ++over) {
    for (const double depth_mm : kDepths_mm) {
      const sim::FingerState finger{.x_mm = indentation.ir_x_mm[over],
                                    .y_mm = indentation.ir_y_mm[over],
                                    .indentation_mm = depth_mm,
                                    .lifted = false};
      const sim::Pressing pressed = cloth.press(kAngle_deg, finger, 0.0);
      std::vector<double> codes;
      for (std::size_t i = 0; i < indentation.ir_x_mm.size(); ++i) {
        const double sunk_mm = cloth.deflection_mm(indentation.ir_x_mm[i], indentation.ir_y_mm[i], finger);
        const double volts = curve.voltsAt(indentation.ir_offset_mm[i] - sunk_mm) + noise_V(random);
        codes.push_back(volts * sensing::kAdcCodes / sensing::kAdcReference_V);
      }
      samples.codes.push_back(codes);
      samples.x_mm.push_back(finger.x_mm + pressed.centre_x_mm);
      samples.y_mm.push_back(finger.y_mm + pressed.centre_y_mm);
      samples.area_mm2.push_back(pressed.area_mm2);
    }
  }
  const calibration::ClothCalibration found = calibration::calibrateCloth(samples, indentation, {});
  if (!found.result.verdict.accepted) return out;
  pipeline::Parameters calibrated = out;
  const auto applied = calibration::applyChanges(bindParameters(calibrated), found.result.changes);
  return applied ? calibrated : out;
}

}  // namespace fyd::bench
