#include "app/bench/parts/table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace fyd::bench {
namespace {

std::vector<std::string> headings(const Table& table) {
  std::vector<std::string> out;
  out.reserve(table.columns.size());
  for (const Column& column : table.columns) out.push_back(column.heading());
  return out;
}

/// `before` in front of each `mark`.
std::string escaped(const std::string& text, char mark, char before) {
  std::string out;
  for (const char c : text) {
    if (c == mark) out += before;
    out += c;
  }
  return out;
}

std::size_t charactersOf(const std::string& utf8) {
  return static_cast<std::size_t>(
      std::ranges::count_if(utf8, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

}  // namespace

std::string Column::heading() const { return unit.empty() ? name : fmt::format("{} ({})", name, unit); }

std::string markdownRows(const Table& table) {
  const auto line = [](std::vector<std::string> cells) {
    for (std::string& cell : cells) cell = escaped(cell, '|', '\\');  // a bar would begin another cell
    return fmt::format("| {} |\n", fmt::join(cells, " | "));
  };
  std::string out = line(headings(table)) + "|";
  for (const Column& column : table.columns) {
    out += column.role == Role::group || column.role == Role::method ? "---|" : "---:|";
  }
  out += '\n';
  for (const auto& row : table.rows) out += line(row);
  return out;
}

std::string toMarkdown(const Table& table) {
  std::string out = fmt::format("# {}\n\n{}", table.title, markdownRows(table));
  for (const auto& note : table.notes) out += fmt::format("\n{}\n", note);
  return out;
}

std::string toText(const Table& table) {
  std::vector<std::vector<std::string>> lines = {headings(table)};
  lines.insert(lines.end(), table.rows.begin(), table.rows.end());
  std::vector<std::size_t> widths(table.columns.size());
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], charactersOf(line[i]));
  }
  std::string out = table.title + "\n";
  for (const auto& line : lines) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
      text += line[i] + std::string(widths[i] - charactersOf(line[i]) + 2, ' ');
    }
    out += text.substr(0, text.find_last_not_of(' ') + 1) + "\n";
  }
  for (const auto& note : table.notes) out += fmt::format("\n{}\n", note);
  return out;
}

std::string toCsv(const Table& table) {
  const auto line = [](const std::vector<std::string>& cells) {
    std::string out;
    for (const std::string& cell : cells) {
      const bool plain = cell.find_first_of(",\"\n") == std::string::npos;
      out += (plain ? cell : fmt::format("\"{}\"", escaped(cell, '"', '"'))) + ',';
    }
    out.back() = '\n';
    return out;
  };
  std::string out = line(headings(table));
  for (const auto& row : table.rows) out += line(row);
  return out;
}

nlohmann::ordered_json toJson(const Table& table) {
  const std::vector<std::string> names = headings(table);
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const auto& row : table.rows) {
    nlohmann::ordered_json object;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const double value = valueOf(row[i]);
      if (std::isfinite(value)) {
        object[names[i]] = value;
      } else if (row[i] == kNothing) {
        object[names[i]] = nullptr;
      } else {
        object[names[i]] = row[i];
      }
    }
    rows.push_back(std::move(object));
  }
  return {{"subject", table.subject}, {"title", table.title}, {"rows", std::move(rows)}, {"notes", table.notes}};
}

std::string number(double value, int digits) {
  if (!std::isfinite(value)) return kNothing;
  constexpr double kLeastWithExponent = 1e6;  // thousands are read more easily in full
  const double size = std::abs(value);
  if (size < std::pow(10.0, digits) || size >= kLeastWithExponent) return fmt::format("{:.{}g}", value, digits);
  const double step = std::pow(10.0, std::floor(std::log10(size)) + 1.0 - digits);
  return fmt::format("{:.0f}", std::round(value / step) * step);
}

double valueOf(const std::string& cell) {
  if (cell == kNever) return std::numeric_limits<double>::infinity();
  double value = 0.0;
  const auto [end, problem] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return problem == std::errc() && end == cell.data() + cell.size() ? value : std::nan("");
}

}  // namespace fyd::bench
