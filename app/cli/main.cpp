// fyd: every capability of the library without a window.
// Exit codes: 0 success (also when Ctrl+C or SIGTERM ended what runs until then), 1 the operation failed, 2 wrong
// usage, 129 its terminal went away (SIGHUP).
#include <csignal>
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/exit_code.h"
#include "core/base/end_signals.h"

namespace fyd::cli {
#define FYD_COMMAND(name) void add_##name(CLI::App&);
#include "commands.inc"
#undef FYD_COMMAND
}  // namespace fyd::cli

int main(int argc, char** argv) {
  fyd::makeFailedWritesErrors();
  CLI::App app("FYD Console's command line: the touchpad, its algorithms and its protocol without a window", "fyd");
  app.set_version_flag("--version", "fyd " FYD_VERSION);
  app.require_subcommand(1);
#define FYD_COMMAND(name) fyd::cli::add_##name(app);
#include "commands.inc"
#undef FYD_COMMAND
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    return code == 0 ? 0 : 2;
  } catch (const fyd::cli::UsageError& error) {
    std::cerr << "fyd: " << error.what() << '\n';
    return 2;
  } catch (const fyd::cli::ExitCode& error) {
    std::cerr << "fyd: " << error.what() << '\n';
    return error.code;
  } catch (const std::exception& error) {
    std::cerr << "fyd: " << error.what() << '\n';
    return 1;
  }
  if (fyd::endSignal() == SIGHUP) return fyd::exitCodeOf(SIGHUP);
  if (std::cout.flush()) return 0;
  std::cerr << "fyd: standard output: not all that was to be printed could be written\n";
  return 1;
}
