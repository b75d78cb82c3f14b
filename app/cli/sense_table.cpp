#include "app/cli/sense_table.h"

#include <algorithm>
#include <cmath>

#include "app/cli/parts/command.h"

namespace fyd::cli {

SenseTable readSenseTable(const std::string& path, const sensing::IndentationParameters& parameters) {
  const std::size_t sensors = parameters.sensors();
  std::vector<std::string> columns;
  for (std::size_t i = 1; i <= sensors; ++i) columns.push_back(fmt::format("adc{}", i));
  for (const char* name : {"x_mm", "y_mm", "area_mm2", "bridge_mV_per_V"}) columns.emplace_back(name);
  SenseTable out;
  out.csv = valueOrFail(readCsv(path, columns, EmptyField::nan));
  out.lines = out.csv.lines;
  const auto& values = out.csv.values;
  out.x_mm = values[sensors];
  out.y_mm = values[sensors + 1];
  out.area_mm2 = values[sensors + 2];
  out.bridge_mV_per_V = values[sensors + 3];
  for (std::size_t row = 0; row < out.rows(); ++row) {
    const double area = out.area_mm2[row];
    if (area < 0.0 || std::isinf(area)) {
      throw Failure(say("{}:{}: area_mm2 = {}: expected 0 or more, or an empty field", path, out.lines[row], area));
    }
    std::vector<double>& codes = out.codes.emplace_back();
    for (std::size_t i = 0; i < sensors; ++i) codes.push_back(values[i][row]);
  }
  return out;
}

}  // namespace fyd::cli
