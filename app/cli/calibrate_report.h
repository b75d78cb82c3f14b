// Options, output and report that all `fyd calibrate` subcommands share.
#pragma once

#include <string>

#include "app/cli/parts/command.h"
#include "core/base/csv.h"
#include "core/calibration/calibration_result.h"
#include "core/station/profile/profile.h"

namespace fyd::cli {

struct CalibrateOptions {
  std::string samples;
  std::string profile;
  std::string touchpad;  ///< that was measured, as in touchpad_name.h; empty: the one the profile belongs to
  std::string who;
  std::string conditions;
  std::string report;  ///< PDF or HTML; empty: none
  bool json = false;

  void addTo(CLI::App& command, const std::string& columns);
  /// The touchpad that was measured; empty: not known.
  [[nodiscard]] std::string touchpadOf() const;
  /// The named profile with that touchpad's values, or the defaults when none is named or the file does not exist yet. Throws Failure.
  [[nodiscard]] station::Profile load() const;
};

/// The numbers every calibration has; details are added to it before `finish`.
[[nodiscard]] nlohmann::ordered_json calibrationJson(const calibration::CalibrationResult& result,
                                                     const CsvTable& table);

/// Writes an accepted result into the profile, if one was named, prints everything, and throws Failure when the result
/// is refused.
/// @param sensor 1…8 for a distance sensor, else 0
void finish(const CalibrateOptions& options, const calibration::CalibrationResult& result, const CsvTable& table,
            nlohmann::ordered_json json, int sensor = 0);

}  // namespace fyd::cli
