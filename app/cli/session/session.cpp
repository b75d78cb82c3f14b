// fyd session …: its subcommands are in the other session_*.cpp files of this folder.
#include "app/cli/session/session_cli.h"

#include <iostream>

namespace fyd::cli {

void addSessionOptions(CLI::App& command, SessionOptions& options) {
  command.add_option("file", options.file, "Recording (.h5)")->required();
  command.add_flag("--json", options.json, "As JSON");
}

std::unique_ptr<recording::Recording> openRecording(const std::string& path) {
  return valueOrFail(recording::Recording::open(path));
}

void add_session(CLI::App& app) {
  CLI::App* command = app.add_subcommand("session", "Recordings: what is in them, recover, replay; lists of trials");
  command->require_subcommand(1);
  addSessionInfo(*command);
  addSessionColumns(*command);
  addSessionVerify(*command);
  addSessionRecover(*command);
  addSessionReplay(*command);
  addSessionTrials(*command);
  addSessionExport(*command);
  addSessionReport(*command);
  addSessionList(*command);
}

}  // namespace fyd::cli
