#include "app/bench/parts/comparison.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "app/bench/parts/cost_picture.h"
#include "core/base/median.h"

namespace fyd::bench {
namespace {

struct Entry {
  std::string group;
  std::string method;
  std::string baseline;  ///< the method that it is compared with; empty: none
  std::string cost = kNothing, cost_unit, error = kNothing, error_unit;
  double cost_ratio = std::nan(""), error_ratio = std::nan("");
  bool never = false;  ///< this row or its baseline
};

/// "∞" is a multiple of nothing: the baseline has no error.
std::string multiple(double ratio) { return std::isinf(ratio) ? "∞" : number(ratio); }

const Column* columnOf(const Table& table, Role role) {
  const auto found = std::ranges::find(table.columns, role, &Column::role);
  return found == table.columns.end() ? nullptr : &*found;
}

/// The first of a row's methods, or groups, by its value alone; the others with their names.
void append(std::string& to, const Column& column, const std::string& cell) {
  if (cell.empty() || cell == kNothing) return;
  const std::string value = column.unit.empty() ? cell : fmt::format("{} {}", cell, column.unit);
  if (to.empty() && std::isnan(valueOf(cell))) {
    to = value;
  } else {
    to += fmt::format("{}{} {}", to.empty() ? "" : ", ", column.name, value);
  }
}

bool isBaseline(const std::string& method) { return method.find("baseline") != std::string::npos; }

std::vector<Entry> entriesOf(const Table& table) {
  std::vector<Entry> out;
  for (const auto& row : table.rows) {
    Entry& entry = out.emplace_back();
    for (std::size_t i = 0; i < std::min(row.size(), table.columns.size()); ++i) {
      const Column& column = table.columns[i];
      switch (column.role) {
        case Role::group: append(entry.group, column, row[i]); break;
        case Role::method: append(entry.method, column, row[i]); break;
        case Role::cost: entry.cost = row[i]; break;
        case Role::unit: entry.cost_unit = row[i]; break;
        case Role::error: entry.error = row[i]; break;
        case Role::error_unit: entry.error_unit = row[i]; break;
        case Role::figure: break;
      }
      if (column.role == Role::cost && !column.unit.empty()) entry.cost_unit = column.unit;
      if (column.role == Role::error && !column.unit.empty()) entry.error_unit = column.unit;
    }
  }
  const auto ratio = [](double value, double base) {
    return std::isinf(value) || std::isinf(base) ? std::nan("") : value / base;
  };
  for (Entry& entry : out) {
    const auto base = std::ranges::find_if(
        out, [&](const Entry& each) { return each.group == entry.group && isBaseline(each.method); });
    if (base == out.end()) continue;
    entry.baseline = base->method;
    if (base->cost_unit == entry.cost_unit) {
      entry.cost_ratio = ratio(valueOf(entry.cost), valueOf(base->cost));
      entry.never = std::isinf(valueOf(entry.cost)) || std::isinf(valueOf(base->cost));
    }
    entry.error_ratio = ratio(valueOf(entry.error), valueOf(base->error));
  }
  return out;
}

struct Method {
  std::string name, cost_unit;
  std::size_t rows = 0;
  std::string only_cost, only_error;  ///< as they stand, of the first row
  std::vector<double> cost, cost_ratio, error, error_ratio;
  bool never = false;  ///< in one of its rows
};

std::string medianCell(const std::vector<double>& values) {
  const double found = median(values);
  return std::isinf(found) ? kNever : number(found);
}

std::vector<Method> methodsOf(const Table& table) {
  std::vector<Method> out;
  for (const Entry& entry : entriesOf(table)) {
    auto found = std::ranges::find_if(
        out, [&](const Method& each) { return each.name == entry.method && each.cost_unit == entry.cost_unit; });
    if (found == out.end()) {
      out.push_back({.name = entry.method, .cost_unit = entry.cost_unit});
      out.back().only_cost = entry.cost;
      out.back().only_error = entry.error;
      found = std::prev(out.end());
    }
    ++found->rows;
    const auto keep = [](std::vector<double>& list, double value) {
      if (!std::isnan(value)) list.push_back(value);
    };
    keep(found->cost, valueOf(entry.cost));
    keep(found->cost_ratio, entry.cost_ratio);
    keep(found->error, valueOf(entry.error));
    keep(found->error_ratio, entry.error_ratio);
    found->never = found->never || entry.never;
  }
  return out;
}

}  // namespace

Table comparisonOf(const std::vector<Table>& tables) {
  Table out{.subject = "numbers",
            .title = "Every subject",
            .columns = {{"subject", Role::group},
                        {"case", Role::group},
                        {"what", Role::method},
                        "baseline",
                        {"cost", Role::cost},
                        {"unit of cost", Role::unit},
                        "cost / baseline",
                        {"error", Role::error},
                        {"unit of error", Role::error_unit},
                        "error / baseline"},
            .rows = {},
            .notes = {}};
  for (const Table& table : tables) {
    for (const Entry& entry : entriesOf(table)) {
      out.rows.push_back({table.subject, entry.group.empty() ? kNothing : entry.group, entry.method,
                          entry.baseline.empty() ? kNothing : entry.baseline, entry.cost, entry.cost_unit,
                          multiple(entry.cost_ratio), entry.error, entry.error_unit, multiple(entry.error_ratio)});
    }
  }
  return out;
}

Table summaryOf(const Table& table) {
  Table out{.subject = table.subject,
            .title = table.title,
            .columns = {{"what", Role::method}, "rows"},
            .rows = {},
            .notes = table.notes};
  const Column* cost = columnOf(table, Role::cost);
  const Column* error = columnOf(table, Role::error);
  const bool mixed = columnOf(table, Role::error_unit) != nullptr;
  const bool own_units = columnOf(table, Role::unit) != nullptr;
  if (cost != nullptr) {
    out.columns.push_back(*cost);
    if (own_units) out.columns.emplace_back("unit", Role::unit);
    out.columns.emplace_back("× baseline");
  }
  if (error != nullptr) {
    out.columns.push_back(*error);
    out.columns.emplace_back("error × baseline");
  }
  for (const Method& method : methodsOf(table)) {
    std::vector<std::string> row = {method.name, std::to_string(method.rows)};
    if (cost != nullptr) {
      row.push_back(method.rows == 1 ? method.only_cost : medianCell(method.cost));
      if (own_units) row.push_back(method.cost_unit);
      row.push_back(method.never ? kNothing : multiple(median(method.cost_ratio)));
    }
    if (error != nullptr) {
      // A median over rows of different units is none.
      row.push_back(method.rows == 1 ? method.only_error : mixed ? kNothing : medianCell(method.error));
      row.push_back(multiple(median(method.error_ratio)));
    }
    out.rows.push_back(std::move(row));
  }
  return out;
}

std::string pictureOf(const std::vector<Table>& tables) {
  std::vector<CostPanel> panels;
  for (const Table& table : tables) {
    CostPanel panel{.title = table.subject, .points = {}};
    for (const Method& method : methodsOf(table)) {
      if (method.never || method.cost_ratio.empty() || method.error_ratio.empty()) continue;
      const bool baseline = isBaseline(method.name);
      const double cost = median(method.cost_ratio), error = median(method.error_ratio);
      if (std::isinf(cost) || std::isinf(error)) continue;  // no place on the axes
      panel.points.push_back({baseline ? "baseline" : method.name, cost, error});
    }
    if (panel.points.size() > 1) panels.push_back(std::move(panel));
  }
  if (panels.empty()) return {};
  return errorAgainstCost(panels, {.least = 1e-3,
                                   .most = 1e3,
                                   .ratio = true,
                                   .errors = {1e-3, 0.01, 0.1, 1.0, 10.0, 100.0, 1e3},
                                   .marked_error = 1.0,
                                   .logarithmic = true,
                                   .unit = " ×",
                                   .marked = "baseline"});
}

}  // namespace fyd::bench
