#include "app/bench/parts/calibrated_cloth.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "core/base/parameter.h"
#include "core/calibration/cloth_calibration.h"
#include "core/sensing/ir_distance.h"
#include "core/sim/touchpad/cloth_presses.h"

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
  std::mt19937_64 random(11);
  std::normal_distribution<double> noise_V(0.0, 1e-3 * kMeanNoise_mV);
  calibration::ClothSamples samples;
  for (const sim::ClothPress& press : sim::pressesOverSensors(parameters, kAngle_deg, kDepths_mm)) {
    std::vector<double> codes;
    for (std::size_t i = 0; i < press.deflection_mm.size(); ++i) {
      const double volts = curve.voltsAt(indentation.ir_offset_mm[i] - press.deflection_mm[i]) + noise_V(random);
      codes.push_back(volts * sensing::kAdcCodes / sensing::kAdcReference_V);
    }
    samples.codes.push_back(codes);
    samples.x_mm.push_back(press.contact.x_mm);
    samples.y_mm.push_back(press.contact.y_mm);
    samples.area_mm2.push_back(press.contact.area_mm2);
  }
  const calibration::ClothCalibration found = calibration::calibrateCloth(samples, indentation, {});
  if (!found.result.verdict.accepted) throw std::runtime_error("the bench's calibration of the cloth was refused");
  const auto applied = calibration::applyChanges(bindParameters(out), found.result.changes);
  if (!applied) throw std::runtime_error(applied.error().text());
  return out;
}

}  // namespace fyd::bench
