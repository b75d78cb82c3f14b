// Recorded motions as CSV, for the commands that send them over a simulated network.
#pragma once

#include <string>
#include <vector>

#include "app/cli/parts/command.h"
#include "core/teleop/prediction/prediction_trial.h"

namespace fyd::cli {

struct NamedTrace {
  std::vector<std::string> columns;
  teleop::Trace trace;
};

/// --columns, for readTrace.
void addColumnsOption(CLI::App& command, std::vector<std::string>& columns);

/// @param columns one to three; when empty `master_mm` if there is one, otherwise all that end in _mm
/// @param most_s from the first row to the last
/// @throws Failure that names the file, the row or the column
[[nodiscard]] NamedTrace readTrace(const std::string& path, std::vector<std::string> columns,
                                   double most_s = teleop::kLongestTrace_s);

}  // namespace fyd::cli
