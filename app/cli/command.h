// What every subcommand shares. A subcommand's file defines `void add_NAME(CLI::App&)`, which adds its
// options and a callback; the callback writes results to standard output and throws Failure when it failed.
#pragma once

#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace fyd::cli {

/// The operation failed: exit 1, the message on standard error.
struct Failure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Wrong usage that only the callback can see: exit 2, the message on standard error.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The value, or Failure with the error's message.
template <class T>
T valueOrFail(Result<T> result) {
  if (!result) throw Failure(result.error().message);
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

/// Doubles that are not finite become null, as JSON has no NaN.
[[nodiscard]] nlohmann::ordered_json jsonNumber(double value);

/// Writes `json` and a line end to standard output.
void printJson(const nlohmann::ordered_json& json);

/// Whole file as bytes; Failure when it cannot be read.
[[nodiscard]] std::string readTextFile(const std::string& path);

}  // namespace fyd::cli
