// Ends a subcommand with an exit code of its own; the message goes to standard error.
#pragma once

#include <stdexcept>
#include <string>

namespace fyd::cli {

struct ExitCode : std::runtime_error {
  ExitCode(int with, const std::string& message) : std::runtime_error(message), code(with) {}
  int code;
};

}  // namespace fyd::cli
