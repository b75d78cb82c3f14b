// Helpers of all subcommands. A subcommand's file defines `void add_NAME(CLI::App&)`, which adds its
// options and a callback; the callback writes results to standard output and throws Failure when it failed.
#pragma once

#include <cstdint>
#include <exception>
#include <limits>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "core/base/error.h"

namespace fyd::cli {

/// The operation failed: the message on standard error, and with --json as "error" in what is printed.
struct Failure : std::exception {
  explicit Failure(Message why, int with = 1) : message(std::move(why)), code(with) {}
  Message message;
  int code;  ///< the exit code
};

/// Wrong usage that only the callback can see: exit 2.
struct UsageError : Failure {
  explicit UsageError(Message why) : Failure(std::move(why), 2) {}
};

/// The value, or Failure with the error's message.
template <class T>
T valueOrFail(Result<T> result) {
  if (!result) throw Failure(std::move(result.error().message));
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

/// The value, or UsageError: for what is judged by the words alone.
template <class T>
T valueOrUsage(Result<T> result) {
  if (!result) throw UsageError(std::move(result.error().message));
  if constexpr (!std::is_void_v<T>) return std::move(*result);
}

/// Check of an option: the word is one that `judge`, which gives a Result, finds good. An empty one is refused by every
/// option (program.cpp).
template <class Judge>
[[nodiscard]] CLI::Validator goodFor(Judge judge) {
  return CLI::Validator(
      [judge](const std::string& word) {
        if (word.empty()) return std::string();
        const auto judged = judge(word);
        return judged ? std::string() : judged.error().text();
      },
      "");
}

/// Check of an option: a number from `least` to `most`. CLI::Range takes NaN for one in any range.
[[nodiscard]] CLI::Validator numberFrom(double least, double most);
/// For `transform` of an option: a whole number from `least` to `most`, in decimal digits whatever they begin with.
/// CLI11 by itself reads 010 as 8, and takes −1 for the largest unsigned number.
[[nodiscard]] CLI::Validator wholeNumberFrom(std::int64_t least,
                                             std::int64_t most = std::numeric_limits<std::int64_t>::max());

/// An option whose value is one or more words with commas between them; none of them may be empty.
CLI::Option* addWords(CLI::App& command, const std::string& name, std::vector<std::string>& into,
                      const std::string& help);

/// Doubles that are not finite become null, as JSON has no NaN.
[[nodiscard]] nlohmann::ordered_json jsonNumber(double value);

/// A value in text: a string as it is, else as JSON; bytes that are no UTF-8, as names of files may hold, are replaced.
[[nodiscard]] std::string textOf(const nlohmann::ordered_json& value);
/// Sets the one JSON document that this program prints on standard output; `printErrorJson` may still add to it.
void printJson(const nlohmann::ordered_json& json);
/// That document with --json, else a line for each value, as a terminal may be shown it; those of an object within are
/// called "object.value".
void printValues(const nlohmann::ordered_json& object, bool as_json);
/// Adds "error" with its kind, format, values and text: to the object that was printed; beside an array ("result");
/// alone when nothing was printed.
void printErrorJson(const Message& message);
/// Writes the document. @return false when it could not be written
[[nodiscard]] bool flushOutput();

/// Whole file as bytes; Failure when it cannot be read.
[[nodiscard]] std::string readTextFile(const std::string& path);
/// The same of a table, which may be larger (kLargestCsv_bytes).
[[nodiscard]] std::string readCsvText(const std::string& path);

}  // namespace fyd::cli

namespace fyd {

/// A message is printed as its English text; `printErrorJson` also prints its parts.
template <class Json>
void to_json(Json& json, const Message& message) {
  json = message.text();
}

}  // namespace fyd

template <>
struct fmt::formatter<fyd::Message> : fmt::formatter<std::string_view> {
  template <class Context>
  auto format(const fyd::Message& message, Context& context) const {
    return fmt::formatter<std::string_view>::format(message.text(), context);
  }
};
