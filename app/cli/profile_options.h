// The options --profile and --set, the same for every subcommand that works with a profile.
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "core/station/profile.h"

namespace fyd::cli {

struct ProfileOptions {
  std::string file;                   ///< empty: defaults
  std::vector<std::string> settings;  ///< "id=value"

  void addTo(CLI::App& command);
  /// The profile with the settings over it. Throws Failure (file) or UsageError (settings).
  [[nodiscard]] station::Profile load() const;
  /// On standard error, for those that measure with the profile: which of its calibrations rest on an older one.
  void sayWhatIsOutdated(const station::Profile& profile) const;
};

}  // namespace fyd::cli
