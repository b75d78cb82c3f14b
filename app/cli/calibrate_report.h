// What every `fyd calibrate` prints and writes, whichever part was calibrated.
#pragma once

#include <string>

#include "app/cli/command.h"
#include "core/base/csv.h"
#include "core/calibration/calibration_result.h"
#include "core/station/profile.h"

namespace fyd::cli {

struct CalibrateOptions {
  std::string samples;
  std::string profile;
  std::string who;
  std::string conditions;
  std::string report;  ///< PDF or HTML; empty: none
  bool json = false;

  void addTo(CLI::App& command, const std::string& columns);
  /// The profile's, or the defaults when none is named or the named one is not there yet. Throws Failure.
  [[nodiscard]] station::Profile load() const;
};

/// The numbers every calibration has; details are added to it before `finish`.
[[nodiscard]] nlohmann::ordered_json describe(const calibration::CalibrationResult& result, const CsvTable& table);

/// Writes an accepted result into the profile, if one was named, prints everything, and throws Failure when the result
/// is refused.
/// @param sensor 1…8 for a distance sensor, else 0
void finish(const CalibrateOptions& options, const calibration::CalibrationResult& result, const CsvTable& table,
            nlohmann::ordered_json json, int sensor = 0);

}  // namespace fyd::cli
