// The options of a simulated trial of the stiffness loop, the same for `fyd stiffness` and `fyd tune`.
#pragma once

#include <optional>

#include "app/cli/parts/profile_options.h"
#include "core/sim/trial/stiffness_trial.h"

namespace fyd::cli {

struct TrialOptions {
  ProfileOptions profile;
  std::optional<std::string> cloth;
  std::optional<double> plant_scale;
  double noise = 1.0;
  std::optional<double> delay_ms;
  std::optional<double> friction_percent;
  std::optional<double> hysteresis;
  std::optional<int> seed;

  /// @return those of the simulation, without the profile's
  std::vector<CLI::Option*> addTo(CLI::App& command);
  /// Throws Failure (profile) or UsageError (a value that is not a number or out of range).
  [[nodiscard]] sim::StiffnessTrial load() const;
};

/// Throws UsageError, naming option, value and range, unless `value` is a number from `minimum` to `maximum`.
void requireRange(const char* option, double value, double minimum, double maximum);

}  // namespace fyd::cli
