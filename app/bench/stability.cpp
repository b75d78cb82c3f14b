// Numerical stability: a naive implementation and ours on each hard case, both run, against an independent truth.
#include <cmath>

#include "app/bench/parts/hard_case.h"
#include "app/bench/parts/table.h"

namespace fyd::bench {

Table bench_stability() {
  Table table{.subject = "stability",
              .title = "Numerical stability: hard cases, a naive implementation and ours",
              .columns = {{"hard case", Role::group},
                          {"by", Role::method},
                          {"error", "", Role::error},
                          {"unit", Role::error_unit},
                          "ours at most",
                          "how",
                          "truth"},
              .rows = {},
              .notes = {"Both run on the same input in each run of this bench; nothing is drawn at random, so another "
                        "run gives the same figures. ∞: not a finite number."}};
  const auto word = [](double error) { return std::isfinite(error) ? number(error, 2) : std::string("∞"); };
  for (const auto& cases : {hardCasesOfSignals(), hardCasesOfSensing(), hardCasesOfControl(), hardCasesOfScenes(),
                            hardCasesOfTimeAndCodes()}) {
    for (const HardCase& each : cases) {
      const std::string most = number(each.at_most, 2);
      table.rows.push_back(
          {each.name, "naive (baseline)", word(each.naive_error), each.unit, most, each.naive, each.truth});
      table.rows.push_back({each.name, "ours", word(each.our_error), each.unit, most, each.ours, each.truth});
    }
  }
  return table;
}

}  // namespace fyd::bench
