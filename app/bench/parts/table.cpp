#include "app/bench/parts/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace fyd::bench {
namespace {

constexpr std::string_view kNothing = "—";

}  // namespace

std::string toMarkdown(const Table& table) {
  std::string out = fmt::format("# {}\n\n| {} |\n|", table.title, fmt::join(table.columns, " | "));
  for (std::size_t i = 0; i < table.columns.size(); ++i) out += i == 0 ? "---|" : "---:|";
  out += '\n';
  for (const auto& row : table.rows) out += fmt::format("| {} |\n", fmt::join(row, " | "));
  for (const auto& note : table.notes) out += fmt::format("\n{}\n", note);
  return out;
}

std::string toCsv(const Table& table) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string out;
    for (const std::string& cell : cells) {
      if (!out.empty()) out += ',';
      out += cell.find_first_of(",\"") == std::string::npos ? cell : fmt::format("\"{}\"", cell);
    }
    return out + '\n';
  };
  std::string out = line(table.columns);
  for (const auto& row : table.rows) out += line(row);
  return out;
}

nlohmann::ordered_json toJson(const Table& table) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    nlohmann::ordered_json object;
    for (std::size_t i = 0; i < row.size(); ++i) {
      double value = 0.0;
      const auto [end, problem] = std::from_chars(row[i].data(), row[i].data() + row[i].size(), value);
      const bool whole = problem == std::errc() && end == row[i].data() + row[i].size();
      if (whole) {
        object[table.columns[i]] = value;
      } else if (row[i] == kNothing) {
        object[table.columns[i]] = nullptr;
      } else {
        object[table.columns[i]] = row[i];
      }
    }
    rows.push_back(std::move(object));
  }
  return {{"subject", table.subject}, {"title", table.title}, {"rows", std::move(rows)}, {"notes", table.notes}};
}

std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : std::string(kNothing);
}

}  // namespace fyd::bench
