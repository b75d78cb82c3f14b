// The subcommands of `fyd session`, and what they share.
#pragma once

#include <memory>
#include <string>

#include "app/cli/parts/command.h"
#include "core/recording/reader/recording.h"

namespace fyd::cli {

void addSessionInfo(CLI::App& parent);
void addSessionColumns(CLI::App& parent);
void addSessionVerify(CLI::App& parent);
void addSessionRecover(CLI::App& parent);
void addSessionReplay(CLI::App& parent);
void addSessionTrials(CLI::App& parent);
void addSessionExport(CLI::App& parent);
void addSessionReport(CLI::App& parent);
void addSessionList(CLI::App& parent);

/// The positional argument FILE and --json, the same for each.
struct SessionOptions {
  std::string file;
  bool json = false;
};
void addSessionOptions(CLI::App& command, SessionOptions& options);

/// Failure when it cannot be read.
[[nodiscard]] std::unique_ptr<recording::Recording> openRecording(const std::string& path);

}  // namespace fyd::cli
