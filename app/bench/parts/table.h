// One table per subject of `fyd bench`: speed beside error, against a named baseline in the same run. A column says
// what it is and in which unit, so that one table is written as text, Markdown, CSV and JSON and compared with its
// baseline (comparison.h) without any number being written twice.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/cli/parts/quantiles.h"

namespace fyd::bench {

/// What a column is in a comparison.
enum class Role : std::uint8_t {
  figure,  ///< shown only
  group,   ///< rows with the same groups are compared with each other
  method,  ///< what was measured; its name holds "baseline" where it is what the others of its group are compared with
  cost,    ///< time as a rule; less is better
  unit,    ///< of this row's cost, where rows differ
  error,   ///< less is better
  error_unit,
};

struct Column {
  // Implicit, so that a list of columns may hold bare names.
  Column(const char* name_, Role role_ = Role::figure) : name(name_), role(role_) {}
  Column(std::string name_, std::string unit_, Role role_ = Role::figure)
      : name(std::move(name_)), unit(std::move(unit_)), role(role_) {}

  /// "name (unit)".
  [[nodiscard]] std::string heading() const;

  std::string name;
  std::string unit;
  Role role;
};

/// A cell without a figure.
inline const std::string kNothing = "—";
/// A cell of what was waited for and did not come: worse than any figure.
inline const std::string kNever = "never";

struct Table {
  std::string subject;  ///< file name stem
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  ///< the baseline's row says so in its method
  std::vector<std::string> notes;              ///< what was measured, on what, and what the figures do not show
};

/// Headings and rows without the title and the notes.
[[nodiscard]] std::string markdownRows(const Table& table);
[[nodiscard]] std::string toMarkdown(const Table& table);
/// Columns below each other, for a terminal.
[[nodiscard]] std::string toText(const Table& table);
[[nodiscard]] std::string toCsv(const Table& table);
[[nodiscard]] nlohmann::ordered_json toJson(const Table& table);

/// A row's method with why it failed, so that its figures are not taken for good ones; empty `why`: as it is.
[[nodiscard]] inline std::string orFailed(const std::string& method, const std::string& why) {
  return why.empty() ? method : method + " (FAILED: " + why + ")";
}

/// "0.123": `digits` significant digits, "—" when not finite.
[[nodiscard]] std::string number(double value, int digits = 3);
/// NaN for a cell that holds no number, infinity for kNever.
[[nodiscard]] double valueOf(const std::string& cell);

using cli::Quantiles;
using cli::quantiles;

/// Nanoseconds of each of `runs` calls.
template <class Call>
[[nodiscard]] std::vector<double> timeEach(int runs, Call&& call) {
  std::vector<double> out;
  out.reserve(static_cast<std::size_t>(runs));
  for (int i = 0; i < runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    call();
    out.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  return out;
}

/// What two looks at the clock take by themselves, ns.
[[nodiscard]] inline double clockTime_ns() {
  auto times = timeEach(10'000, [] {});
  return quantiles(times).p50;
}

}  // namespace fyd::bench
