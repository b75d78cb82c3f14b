// One table per subject of `fyd bench`: speed beside error, against a named baseline in the same run.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/cli/parts/quantiles.h"

namespace fyd::bench {

struct Table {
  std::string subject;  ///< file name stem
  std::string title;
  std::vector<std::string> columns;            ///< with units
  std::vector<std::vector<std::string>> rows;  ///< the baseline's row says so in its first cell
  std::vector<std::string> notes;              ///< what was measured, on what, and what the figures do not show
};

[[nodiscard]] std::string toMarkdown(const Table& table);
[[nodiscard]] std::string toCsv(const Table& table);
[[nodiscard]] nlohmann::ordered_json toJson(const Table& table);

/// "0.123": `digits` significant digits, "—" when not finite.
[[nodiscard]] std::string number(double value, int digits = 3);

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

}  // namespace fyd::bench
