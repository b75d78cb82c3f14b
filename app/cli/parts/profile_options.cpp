#include "app/cli/parts/profile_options.h"

#include <iostream>

#include "app/cli/parts/command.h"
#include "core/control/control_parameters.h"
#include "core/station/profile/calibrated_values.h"
#include "core/station/profile/calibration_file.h"

namespace fyd::cli {

const Parameter* parameterNamed(std::span<const Parameter> parameters, std::string_view id) {
  const Parameter* found = findParameter(parameters, id);
  if (found != nullptr && found->id != id) std::cerr << fmt::format("{} is called {} now\n", id, found->id);
  return found;
}

void ProfileOptions::addTo(CLI::App& command) {
  command.add_option("--profile", file, "Profile to load (TOML)");
  command.add_option("--set", settings, "A parameter as id=value, over the profile's; may be repeated")
      ->allow_extra_args(false);
}

station::Profile ProfileOptions::load(Together together) const {
  station::Profile profile;
  if (!file.empty()) profile = valueOrFail(station::loadProfile(file));
  assign(profile, together);
  return profile;
}

station::Profile ProfileOptions::loadFor(const std::string& touchpad) const {
  if (file.empty()) return load();
  station::TouchpadProfile loaded = valueOrFail(station::loadProfileFor(file, touchpad));
  if (!loaded.notice.empty()) std::cerr << fmt::format("warning: {}\n", loaded.notice.text());
  assign(loaded.profile, Together::checked);
  return std::move(loaded.profile);
}

void ProfileOptions::assign(station::Profile& profile, Together together) const {
  const auto parameters = bindParameters(profile);
  const bool fitted = control::checkControlParameters(profile.step.control).has_value();
  for (const std::string& setting : settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos) throw UsageError(say("--set {}: expected id=value", setting));
    const Parameter* parameter = parameterNamed(parameters, setting.substr(0, equals));
    if (parameter == nullptr) throw UsageError(say("--set {}: unknown parameter; 'fyd params' lists them", setting));
    if (auto assigned = assignParameter(*parameter, setting.substr(equals + 1)); !assigned) {
      throw UsageError(say("--set {}", assigned.error().message));
    }
  }
  if (together == Together::not_yet) return;
  // Those of the file alone are no wrong usage; who uses them says so.
  if (auto checked = control::checkControlParameters(profile.step.control); fitted && !checked) {
    throw UsageError(about("--set", checked.error().message));
  }
}

void ProfileOptions::warnOfOutdatedParts(const station::Profile& profile) const {
  if (file.empty()) return;
  const auto outdated = station::outdatedParts(file, profile);
  if (!outdated) {
    std::cerr << fmt::format("warning: {}\n", outdated.error().text());
    return;
  }
  for (const station::OutdatedPart& each : *outdated) {
    std::cerr << fmt::format("warning: {}: {}: {}\n", file, each.part, each.why);
  }
}

}  // namespace fyd::cli
