#include "app/cli/parts/program.h"

#include <algorithm>
#include <csignal>
#include <iostream>
#include <optional>
#include <string_view>
#include <vector>

#include "app/cli/parts/command.h"
#include "app/cli/parts/terminal_text.h"
#include "core/base/end_signals.h"

namespace fyd::cli {

namespace {

/// Texts that may be empty.
bool isFreeText(const CLI::Option& option) {
  const std::string& name = option.get_single_name();
  return name == "notes" || name == "text" || name == "operator" || name == "subject";
}

/// An empty value is a variable of a script that was not set: it never means that the option was left out.
void refuseEmptyValues(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    if (option->get_items_expected_max() == 0 || isFreeText(*option)) continue;
    option->check([](const std::string& value) {
      return value.empty() ? std::string("empty; leave the option out, or give it a value") : std::string();
    });
  }
  for (CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; })) refuseEmptyValues(*below);
}

/// What was asked for in place of a command, when that is why parsing failed; else nothing.
std::optional<Message> unknownCommand(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App* parent = &app;
  std::string path;
  while (!parent->get_subcommands().empty()) {
    parent = parent->get_subcommands().front();
    path += (path.empty() ? "" : " ") + parent->get_name();
  }
  const auto words = parent->remaining();
  if (error.get_name() != "RequiredError" || parent->get_require_subcommand_min() == 0 || words.empty()) return {};
  std::vector<std::string> known;
  for (const CLI::App* each : parent->get_subcommands([](const CLI::App*) { return true; })) {
    if (!each->get_name().empty()) known.push_back(each->get_name());
  }
  const std::string all = fmt::format("{}", fmt::join(known, ", "));
  if (path.empty()) return say("\"{}\" is no command; expected one of {}", words.front(), all);
  return say("{}: \"{}\" is none of its commands; expected one of {}", path, words.front(), all);
}

}  // namespace

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
  refuseEmptyValues(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (auto unknown = unknownCommand(app, error)) {
      unknown->kind = MessageKind::command;
      return complain(*unknown, 2);
    }
    const int code = app.exit(error);
    Message message = verbatim(error.what());
    message.kind = MessageKind::command;
    if (code != 0) return failed(message, 2);  // 0: help or version was asked for, and is written as any other output
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
