// fyd: every capability of the library without a window.
// Exit codes: 0 success, 1 the operation failed, 2 wrong usage.
#include <iostream>

#include "app/cli/command.h"
#include "app/cli/exit_code.h"

namespace fyd::cli {
#define FYD_COMMAND(name) void add_##name(CLI::App&);
#include "commands.inc"
#undef FYD_COMMAND
}  // namespace fyd::cli

int main(int argc, char** argv) {
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
  return std::cout.flush() ? 0 : 1;
}
