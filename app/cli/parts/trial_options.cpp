#include "app/cli/parts/trial_options.h"

#include "app/cli/parts/cloth_name.h"
#include "app/cli/parts/command.h"

namespace fyd::cli {

void requireRange(const char* option, double value, double minimum, double maximum) {
  if (value >= minimum && value <= maximum) return;
  throw UsageError(say("{} {}: expected {} … {}", option, value, minimum, maximum));
}

std::vector<CLI::Option*> TrialOptions::addTo(CLI::App& command) {
  profile.addTo(command);
  return {
      command.add_option("--cloth", cloth, "Which cloth is simulated; the profile's when left out")
          ->check(CLI::IsMember(std::vector<std::string>(sim::kClothNames.begin(), sim::kClothNames.end()))),
      command.add_option("--plant-scale", plant_scale, "Stiffness of the simulated cloth over that of the nominal one"),
      command.add_option("--noise", noise, "Factor on the noise of the simulated sensors (1)"),
      command.add_option("--delay", delay_ms, "Dead time of every simulated sensor, ms"),
      command.add_option("--friction", friction_percent, "Duty cycle the simulated motors need before they turn, %"),
      command.add_option("--hysteresis", hysteresis, "Share of the force that lags in the simulated cloth"),
      command.add_option("--seed", seed, "Seed of the simulation's random numbers")
          ->transform(wholeNumberFrom(0, 1'000'000'000))};
}

sim::StiffnessTrial TrialOptions::load() const {
  // Before the file is opened.
  if (plant_scale) requireRange("--plant-scale", *plant_scale, 0.5, 2.0);
  requireRange("--noise", noise, 0.0, 20.0);
  if (delay_ms) requireRange("--delay", *delay_ms, 0.0, 500.0);
  if (friction_percent) requireRange("--friction", *friction_percent, 0.0, 40.0);
  if (hysteresis) requireRange("--hysteresis", *hysteresis, 0.0, 0.3);

  const station::Profile loaded = profile.load();
  sim::StiffnessTrial trial;
  trial.parameters = loaded.step;
  trial.sim = loaded.sim;
  if (auto checked = control::checkControlParameters(trial.parameters.control); !checked) {
    throw Failure(checked.error().message);
  }
  if (cloth) trial.sim.cloth = clothOf(*cloth);
  if (plant_scale) trial.sim.cloth_stiffness_scale = *plant_scale;
  sim::scaleNoise(trial.sim, noise);
  if (delay_ms) sim::delaySensors(trial.sim, *delay_ms);
  if (friction_percent) trial.sim.motor_friction_percent = *friction_percent;
  if (hysteresis) trial.sim.cloth_hysteresis = *hysteresis;
  if (seed) trial.sim.seed = *seed;
  return trial;
}

}  // namespace fyd::cli
