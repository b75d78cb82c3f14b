#include "app/cli/parts/program.h"

#include <algorithm>
#include <csignal>
#include <iostream>
#include <string_view>

#include "app/cli/parts/command.h"
#include "app/cli/parts/terminal_text.h"
#include "core/base/end_signals.h"

namespace fyd::cli {

int runProgram(CLI::App& app, int argc, char** argv) {
  const bool json = std::any_of(argv, argv + argc, [](std::string_view each) { return each == "--json"; });
  const auto failed = [json](const Message& message, int code) {
    if (json) printErrorJson(message);
    static_cast<void>(flushOutput());
    return code;
  };
  const auto complain = [&failed](const Message& message, int code) {
    const int out = failed(message, code);
    std::cerr << "fyd: " << forTerminal(message.text()) << '\n';
    return out;
  };
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int code = app.exit(error);
    Message message = verbatim(error.what());
    message.kind = MessageKind::command;
    return code == 0 ? 0 : failed(message, 2);
  } catch (const Failure& error) {
    return complain(error.message, error.code);
  } catch (const std::exception& error) {
    return complain(verbatim(error.what()), 1);
  }
  const bool written = flushOutput();
  if (endSignal() == SIGHUP) return exitCodeOf(SIGHUP);
  if (written) return 0;
  std::cerr << "fyd: standard output: not all that was to be printed could be written\n";
  return 1;
}

}  // namespace fyd::cli
