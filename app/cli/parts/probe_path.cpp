#include "app/cli/parts/probe_path.h"

#include <cmath>

#include "app/cli/parts/command.h"
#include "core/base/csv.h"

namespace fyd::cli {

ProbePath readProbePath(const std::string& file) {
  const CsvTable table = valueOrFail(readCsv(file, {"t_s", "x_mm", "y_mm", "z_mm"}));
  ProbePath path;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double t_s = table.values[0][row];
    const Vec3 at = {table.values[1][row], table.values[2][row], table.values[3][row]};
    if (!std::isfinite(t_s) || (row > 0 && !(t_s > path.time_s.back()))) {
      throw Failure(say("{}:{}: t_s {}: expected a time after the row before", file, table.lines[row], t_s));
    }
    if (!at.finite()) throw Failure(say("{}:{}: expected three finite numbers in mm", file, table.lines[row]));
    path.time_s.push_back(t_s);
    path.probe_mm.push_back(at);
  }
  return path;
}

}  // namespace fyd::cli
