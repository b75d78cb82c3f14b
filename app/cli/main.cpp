// fyd: every capability of the library without a window.
// Exit codes: 0 success (also when Ctrl+C or SIGTERM ended what runs until then), 1 the operation failed, 2 wrong
// usage, 129 its terminal went away (SIGHUP).
#include <algorithm>
#include <csignal>
#include <iostream>
#include <string_view>

#include "app/cli/command.h"
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
  const bool json = std::any_of(argv, argv + argc, [](std::string_view each) { return each == "--json"; });
  const auto failed = [json](const fyd::Message& message, int code) {
    if (json) fyd::cli::printErrorJson(message);
    static_cast<void>(fyd::cli::flushOutput());
    return code;
  };
  const auto complain = [&failed](const fyd::Message& message, int code) {
    const int out = failed(message, code);
    std::cerr << "fyd: " << message.text() << '\n';
    return out;
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    fyd::Message message = fyd::verbatim(error.what());
    message.kind = fyd::MessageKind::command;
    return code == 0 ? 0 : failed(message, 2);
  } catch (const fyd::cli::Failure& error) {
    return complain(error.message, error.code);
  } catch (const std::exception& error) {
    return complain(fyd::verbatim(error.what()), 1);
  }
  const bool written = fyd::cli::flushOutput();
  if (fyd::endSignal() == SIGHUP) return fyd::exitCodeOf(SIGHUP);
  if (written) return 0;
  std::cerr << "fyd: standard output: not all that was to be printed could be written\n";
  return 1;
}
