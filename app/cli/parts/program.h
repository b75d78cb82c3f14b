// Runs a program with subcommands: errors on standard error, the JSON document on standard output, the exit code.
#pragma once

#include <CLI/CLI.hpp>

namespace fyd::cli {

/// Runs the command line.
/// @return 0 success (also when Ctrl+C or SIGTERM ended an endless run), 1 the operation failed, 2 wrong usage,
///         129 its terminal went away (SIGHUP)
[[nodiscard]] int runProgram(CLI::App& app, int argc, char** argv);

}  // namespace fyd::cli
