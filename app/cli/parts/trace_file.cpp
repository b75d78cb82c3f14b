#include "app/cli/parts/trace_file.h"

#include <algorithm>

#include "core/base/csv.h"

namespace fyd::cli {
namespace {

constexpr const char* kTime = "t_s";

}  // namespace

void addColumnsOption(CLI::App& command, std::vector<std::string>& columns) {
  addWords(command, "--columns", columns, "One to three columns, such as x_mm,y_mm");
}

NamedTrace readTrace(const std::string& path, std::vector<std::string> columns, double most_s) {
  if (columns.size() > teleop::kMostAxes) {
    throw UsageError(say("--columns: {} columns; expected one to three", columns.size()));
  }
  if (std::ranges::find(columns, kTime) != columns.end()) {
    throw UsageError(say("--columns: {} is the time; expected columns of positions in mm", kTime));
  }
  std::vector<std::string> sorted = columns;
  std::ranges::sort(sorted);
  if (const auto twice = std::ranges::adjacent_find(sorted); twice != sorted.end()) {
    throw UsageError(say("--columns: {} is named twice", *twice));
  }
  const std::string text = readCsvText(path);  // once: a pipe cannot be read again
  if (columns.empty()) {
    const CsvTable head = valueOrFail(parseCsv(text, path, {kTime}));
    for (const std::string& each : head.header) {
      if (each.ends_with("_mm")) columns.push_back(each);
    }
    if (std::ranges::find(columns, "master_mm") != columns.end()) columns = {"master_mm"};
    if (columns.empty() || columns.size() > teleop::kMostAxes) {
      throw Failure(say("{}: {} columns end in _mm; expected one to three, or --columns", path, columns.size()));
    }
  }
  std::vector<std::string> wanted = {kTime};
  wanted.insert(wanted.end(), columns.begin(), columns.end());
  const CsvTable table = valueOrFail(parseCsv(text, path, wanted));
  NamedTrace out{.columns = std::move(columns), .trace = {}};
  out.trace.axes = out.columns.size();
  out.trace.time_s = table.values[0];
  out.trace.position_mm.resize(table.rows());
  for (std::size_t a = 0; a < out.columns.size(); ++a) {
    for (std::size_t row = 0; row < table.rows(); ++row) out.trace.position_mm[row][a] = table.values[a + 1][row];
  }
  auto good = teleop::checkTrace(out.trace);
  if (good) good = teleop::checkLength(out.trace, most_s);
  if (!good) throw Failure(about(path, std::move(good.error().message)));
  return out;
}

}  // namespace fyd::cli
