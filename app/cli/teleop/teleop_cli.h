// What the parts of fyd teleop share.
#pragma once

#include <string>

#include "app/cli/parts/command.h"
#include "core/sim/teleop/teleop_run.h"

namespace fyd::cli {

/// isdn, adsl or lan, or a CSV file of one-way delays (as of fyd sim network) or of round trips (sent_ms,rtt_ms).
/// @throws UsageError, Failure naming file and line
[[nodiscard]] sim::NetworkProfile networkPath(const std::string& name, std::uint64_t seed);

void addTeleopTable(CLI::App& teleop);

}  // namespace fyd::cli
