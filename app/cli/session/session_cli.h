// The subcommands of `fyd session`, and what they share.
#pragma once

#include <memory>
#include <string>

#include "app/cli/parts/command.h"
#include "core/recording/file/recording_place.h"
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

/// Of something that is made of a recording: an error that names neither it nor `out`, the file it goes to, gets the
/// recording's name. Those of reading it have that already, perhaps that of FILE.partial.
template <class T>
[[nodiscard]] Result<T> naming(const std::string& file, Result<T> result, const std::string& out = {}) {
  if (result) return result;
  const std::string text = result.error().text();
  const auto named = [&](const std::string& name) { return text.find(name + ":") != std::string::npos; };
  if (named(file) || named(recording::partialOf(file)) || (!out.empty() && text.find(out) != std::string::npos)) {
    return result;
  }
  return fail(about(file, std::move(result.error().message)));
}

/// Failure when it cannot be read.
[[nodiscard]] std::unique_ptr<recording::Recording> openRecording(const std::string& path);

}  // namespace fyd::cli
