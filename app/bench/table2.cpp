// The tele-gesture paper's Table 2 in numbers: periods of messages, networks and predictors over recorded hands.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/table.h"
#include "app/cli/parts/command.h"
#include "app/cli/parts/trace_file.h"
#include "core/sim/teleop/teleop_run.h"

namespace fyd::bench {
namespace table2_rows {
namespace {

constexpr double kWall_N_per_m = 500.0;

std::vector<teleop::Trace> handTraces() {
  const std::filesystem::path data = benchOptions().data.empty() ? "tests/data" : benchOptions().data;
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"teleop_1dof", "hand_motion"}) {
    std::error_code none;
    for (const auto& each : std::filesystem::directory_iterator(data / folder, none)) {
      if (each.path().extension() == ".csv") files.push_back(each.path());
    }
  }
  if (files.empty()) throw cli::Failure(say("{}: no recordings in teleop_1dof or hand_motion", data.string()));
  std::ranges::sort(files);
  std::vector<teleop::Trace> out;
  for (const auto& file : wholeOrFirst(files, 1)) {
    teleop::Trace trace = cli::readTrace(file, {}).trace;
    const auto end = std::ranges::upper_bound(trace.time_s, trace.time_s.front() + wholeOrQuick(10.0, 3.0));
    trace.time_s.erase(end, trace.time_s.end());
    trace.position_mm.resize(trace.time_s.size());
    out.push_back(std::move(trace));
  }
  return out;
}

}  // namespace
}  // namespace table2_rows

Table bench_table2() {
  using namespace table2_rows;
  Table table{.subject = "table2",
              .title = "The tele-gesture paper's Table 2: periods, networks, predictors",
              .columns = {{"network", Role::group},
                          {"period", "ms", Role::group},
                          {"predictor", Role::method},
                          {"added delay", "ms", Role::cost},
                          {"RMS", "mm", Role::error},
                          {"worst", "mm"},
                          "vibration ratio",
                          {"least energy", "J"},
                          {"packets", "1/s"}},
              .rows = {},
              .notes = {}};
  const std::vector<teleop::Trace> traces = handTraces();
  for (const std::string& network : wholeOrFirst(std::vector<std::string>{"lan", "isdn", "adsl"}, 1)) {
    for (const double period_ms : wholeOrFirst(std::vector<double>{10.0, 100.0, 250.0, 500.0}, 1)) {
      for (const std::string_view name : teleop::kPredictorNames) {
        sim::TeleopRunSettings settings{.period_ms = period_ms,
                                        .path = cli::valueOrFail(sim::networkProfile(network)),
                                        .predictor = cli::valueOrFail(teleop::predictorNamed(name))};
        settings.path.forward.seed = 2 * benchOptions().seed;
        settings.path.backward.seed = 2 * benchOptions().seed + 1;
        double squares = 0.0, seconds = 0.0, worst_mm = 0.0, packets = 0.0, least_J = 0.0;
        std::vector<double> delays_ms, vibrations;
        for (const teleop::Trace& trace : traces) {
          settings.wall_N_per_m = 0.0;
          const sim::TeleopFigures free = runTeleop(trace, settings, nullptr);
          settings.wall_N_per_m = kWall_N_per_m;
          least_J = std::min(least_J, runTeleop(trace, settings, nullptr).least_energy_J);
          squares += free.rms_error_mm * free.rms_error_mm * free.seconds;
          seconds += free.seconds;
          packets += free.packets_per_s / static_cast<double>(traces.size());
          worst_mm = std::max(worst_mm, free.max_error_mm);
          delays_ms.push_back(free.added_delay_ms);
          vibrations.push_back(free.vibration_ratio);
        }
        table.rows.push_back({network, number(period_ms), std::string(name) + (name == "order0" ? " (baseline)" : ""),
                              number(quantiles(delays_ms).p50), number(std::sqrt(squares / seconds)), number(worst_mm),
                              number(quantiles(vibrations).p50), number(least_J), number(packets)});
      }
    }
  }
  table.notes = {fmt::format(
      "{} recorded hands, the first 10 s of each, two simulated arms, seed {}; the baseline holds the last message "
      "(order 0). Added delay and vibration: medians over the hands; RMS: pooled; least energy: of the hand with a "
      "wall of {:g} N/m, the worst hand's. `fyd teleop table` has a row for each hand, and recorded networks.",
      traces.size(), benchOptions().seed, kWall_N_per_m)};
  return table;
}

}  // namespace fyd::bench
