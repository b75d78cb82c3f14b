#include "app/cli/bench/table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace fyd::bench {

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

std::string number(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "—";
}

Quantiles quantiles(std::vector<double>& samples) {
  if (samples.empty()) return {};
  std::sort(samples.begin(), samples.end());
  const auto at = [&](double q) {
    return samples[std::min(samples.size() - 1, static_cast<std::size_t>(q * static_cast<double>(samples.size())))];
  };
  return {at(0.5), at(0.99), at(0.999), samples.back()};
}

}  // namespace fyd::bench
