#include "core/calibration/texture_calibration.h"

#include <algorithm>

namespace fyd::calibration {
namespace {

/// Changes of the constants that identification finds; the plant's other constants are kept.
std::vector<ParameterChange> changesTo(texture::FeltPlant found, texture::FeltPlant profile) {
  std::vector<ParameterChange> out;
  const std::vector<Parameter> before = bindParameters(profile);
  const std::vector<Parameter> after = bindParameters(found);
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (const std::string value = formatParameter(after[i]); value != formatParameter(before[i])) {
      out.push_back({std::string(after[i].id), value});
    }
  }
  return out;
}

}  // namespace

TextureCalibration calibrateTexture(const std::vector<texture::SweepRow>& sweep, const texture::FeltPlant& profile) {
  TextureCalibration out;
  CalibrationResult& result = out.result;
  const std::vector<texture::SweepPart> parts = partsOf(sweep);
  result = {.procedure = "texture",
            .curve = say("breakaway of each motor; resonance of the cloth under a finger"),
            .unit = "1",
            .points = parts.size(),
            .valid_unit = "°"};
  const auto found = texture::identifyPlant(sweep, profile);
  if (!found) {
    result.verdict = {.reason = found.error().message};
    return out;
  }
  out.identified = *found;
  const texture::FeltPlant& plant = found->plant;
  double damping_error = 0.0;
  result.valid_from = result.valid_to = found->cloths.front().stretch_deg;
  for (const texture::FoundCloth& cloth : found->cloths) {
    damping_error = std::max(damping_error, cloth.sigma_damping);
    result.valid_from = std::min(result.valid_from, cloth.stretch_deg);
    result.valid_to = std::max(result.valid_to, cloth.stretch_deg);
    result.residuals.push_back(cloth.resonance_Hz - plant.resonanceAt_Hz(cloth.stretch_deg));
  }
  result.coefficients = {{std::string(sentence("resonance")), "Hz", plant.resonance_Hz, found->sigma_resonance_Hz},
                         {std::string(sentence("damping")), "1", plant.damping, damping_error}};
  for (const texture::FoundBreakaway& motor : found->breakaway) {
    result.coefficients.push_back({std::string(sentence("breakaway")), "%", motor.percent, motor.sigma_percent});
  }
  result.held_out_rmse = found->held_out_error;
  result.changes = changesTo(plant, profile);
  result.verdict = {
      .accepted = true,
      .reason =
          say("{}: {:.0f} % of the acceleration held out is left; breakaway {:.1f} ± {:.1f} % and {:.1f} ± {:.1f} "
              "%, resonance {:.1f} ± {:.1f} Hz at {:.0f}°, damping {:.2f}",
              phrase(found->verdict), 100.0 * found->held_out_error, found->breakaway[0].percent,
              found->breakaway[0].sigma_percent, found->breakaway[1].percent, found->breakaway[1].sigma_percent,
              plant.resonance_Hz, found->sigma_resonance_Hz, plant.stretch_deg, plant.damping)};
  return out;
}

}  // namespace fyd::calibration
