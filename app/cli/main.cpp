// fyd: every capability of the library without a window.
#include "app/cli/parts/program.h"
#include "core/base/end_signals.h"

namespace fyd::cli {
#define FYD_COMMAND(name) void add_##name(CLI::App&);
#include "commands.inc"
#undef FYD_COMMAND
}  // namespace fyd::cli

// NOLINTNEXTLINE(bugprone-exception-escape): declaring the options throws only for a mistake in their declaration
int main(int argc, char** argv) {
  fyd::makeFailedWritesErrors();
  CLI::App app("FYD Console's command line: the touchpad, its algorithms and its protocol without a window", "fyd");
  app.set_version_flag("--version", "fyd " FYD_VERSION);
  app.require_subcommand(1);
#define FYD_COMMAND(name) fyd::cli::add_##name(app);
#include "commands.inc"
#undef FYD_COMMAND
  return fyd::cli::runProgram(app, argc, argv);
}
