// The options --profile and --set, the same for every subcommand that works with a profile.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/station/profile/profile.h"

namespace fyd::cli {

/// The parameter of that id, or null. Says on standard error when the id is a former one.
[[nodiscard]] const Parameter* parameterNamed(std::span<const Parameter> parameters, std::string_view id);

struct ProfileOptions {
  std::string file;                   ///< empty: defaults
  std::vector<std::string> settings;  ///< "id=value"

  void addTo(CLI::App& command);
  /// Whether a setting must agree with the profile's other values.
  enum class Together { checked, not_yet };

  /// The profile with the settings over it. Throws Failure (file) or UsageError (settings).
  /// @param together not_yet: its calibrated values are not those that are used; loadFor() follows
  [[nodiscard]] station::Profile load(Together together = Together::checked) const;
  /// The same with the calibrated values of a touchpad (calibrated_values.h); warns on standard error when they are not
  /// those of the file. @param touchpad as in touchpad_name.h
  [[nodiscard]] station::Profile loadFor(const std::string& touchpad) const;
  /// Warns on standard error, in commands that measure, of calibrations of the profile that rest on an older one.
  void warnOfOutdatedParts(const station::Profile& profile) const;

 private:
  void assign(station::Profile& profile, Together together) const;
};

}  // namespace fyd::cli
