#include "core/texture/felt/plant_sweep.h"

#include <cmath>

#include "core/base/csv.h"

namespace fyd::texture {

Result<std::vector<SweepRow>> parseSweep(std::string_view text, std::string_view source_name) {
  const auto table = parseCsv(text, source_name,
                              {"t_s", "part", "stretch_deg", "duty1_percent", "duty2_percent", "encoder1_counts",
                               "encoder2_counts", "acceleration_g"},
                              EmptyField::nan);
  if (!table) return tl::unexpected(table.error());
  std::vector<SweepRow> out;
  for (std::size_t n = 0; n < table->rows(); ++n) {
    const auto at = [&](std::size_t column) { return table->values[column][n]; };
    for (std::size_t column = 0; column < 7; ++column) {
      const bool encoder = column == 5 || column == 6;
      const double most = encoder ? kSweepCountsPerTurn - 1 : column == 0 ? 1e9 : column == 1 ? 1e6 : 180.0;
      const double least = encoder || column == 1 ? 0.0 : -most;
      const bool whole = encoder || column == 1;
      if (!(at(column) >= least && at(column) <= most) || (whole && at(column) != std::floor(at(column)))) {
        return fail("{}:{}: {} = {}: expected a number from {} to {}", source_name, table->lines[n],
                    table->columns[column], at(column), least, most);
      }
    }
    if (n > 0) {
      const double step_ms = 1e3 * (at(0) - out.back().t_s);
      if (static_cast<int>(at(1)) == out.back().part && !(std::abs(step_ms - 1e3 / kSweepRate_Hz) < 0.2)) {
        return fail("{}:{}: {} ms after the row before; expected a row each millisecond", source_name, table->lines[n],
                    step_ms);
      }
    }
    out.push_back({.t_s = at(0),
                   .part = static_cast<int>(at(1)),
                   .stretch_deg = at(2),
                   .duty_percent = {at(3), at(4)},
                   .encoder_counts = {static_cast<int>(at(5)), static_cast<int>(at(6))},
                   .acceleration_g = at(7)});
  }
  return out;
}

std::vector<SweepPart> partsOf(const std::vector<SweepRow>& sweep) {
  std::vector<SweepPart> out;
  for (const SweepRow& row : sweep) {
    if (out.empty() || out.back().back().part != row.part) out.emplace_back();
    out.back().push_back(row);
  }
  return out;
}

}  // namespace fyd::texture
