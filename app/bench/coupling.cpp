// fyd bench coupling: a press, a release and a second press over many drawn networks, walls and hands, by each
// coupling.
#include <algorithm>
#include <filesystem>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/coupling_run.h"
#include "app/bench/parts/table.h"
#include "app/cli/parts/command.h"
#include "app/cli/parts/output_file.h"
#include "core/base/system_reason.h"
#include "core/teleop/coupling/coupling_choice.h"

namespace fyd::bench {
namespace {

using teleop::CouplingChoice;

constexpr std::array<CouplingChoice, 3> kChoices = {CouplingChoice::spring, CouplingChoice::tdpa,
                                                    CouplingChoice::model};

std::string_view nameOf(CouplingChoice choice) { return teleop::kCouplingNames[static_cast<std::size_t>(choice)]; }

std::string rowsText(const std::vector<CouplingRow>& rows) {
  std::string text = "t_s,hand_x_m,hand_v_m_per_s,hand_force_N,far_x_m,far_force_N\n";
  for (const CouplingRow& row : rows) {
    text += fmt::format("{:.3f},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", row.t_s, row.hand_m, row.hand_m_per_s,
                        row.hand_N, row.far_m, row.far_N);
  }
  return text;
}

std::string runsLine(int number, const CouplingRun& run, CouplingChoice choice, const CouplingFigures& figures) {
  return fmt::format(
      "{},{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{},{}\n",
      number, nameOf(choice), 1e3 * run.delay_s, 1e3 * run.jitter_s, 100.0 * run.loss, run.wall_N_per_m, run.hand_kg,
      run.hand_N_s_per_m, run.hand_N_per_m, figures.least_energy_J, figures.oscillation_mm, figures.rest_difference_mm,
      figures.drag_N, figures.felt_share, figures.dissipated_J, figures.unstable ? 1 : 0, figures.good() ? 1 : 0);
}

/// Least, median and most.
std::string range(std::vector<double> values) {
  if (values.empty()) return "—";
  std::ranges::sort(values);
  return fmt::format("{} / {} / {}", number(values.front()), number(values[values.size() / 2]), number(values.back()));
}

}  // namespace

Table bench_coupling() {
  const BenchOptions& options = benchOptions();
  std::string runs_text =
      "run,coupling,delay_ms,jitter_ms,loss_percent,wall_N_per_m,hand_kg,hand_N_s_per_m,hand_N_per_m,least_energy_J,"
      "oscillation_mm,rest_difference_mm,drag_N,felt_share,dissipated_J,unstable,good\n";
  if (!options.out.empty()) {
    std::error_code problem;
    std::filesystem::create_directories(options.out, problem);
    if (problem) throw cli::Failure(about(options.out, systemReason(problem)));
  }
  std::array<std::vector<CouplingFigures>, 3> figures;
  for (int i = 0; i < options.runs; ++i) {
    const CouplingRun run = drawCouplingRun(options.seed * 1'000'003 + static_cast<std::uint64_t>(i));
    for (std::size_t c = 0; c < kChoices.size(); ++c) {
      const bool written = !options.out.empty() && kChoices[c] == CouplingChoice::model;
      std::vector<CouplingRow> rows;
      figures[c].push_back(simulate(run, kChoices[c], written ? &rows : nullptr));
      runs_text += runsLine(i, run, kChoices[c], figures[c].back());
      if (written) {
        cli::writeTextFile(std::filesystem::path(options.out) / fmt::format("run_{:03}.csv", i), rowsText(rows));
      }
    }
  }
  if (!options.out.empty()) cli::writeTextFile(std::filesystem::path(options.out) / "runs.csv", runs_text);
  Table table;
  table.subject = "coupling";
  table.title = "Couplings: press, release and second press over drawn networks, walls and hands";
  table.columns = {{"coupling", Role::method},
                   "all goals met",
                   {"missed a goal", "%", Role::error},
                   "unstable",
                   {"least energy at the hand", "J"},
                   {"oscillation", "mm"},
                   {"difference at rest", "mm"},
                   {"drag in free motion", "N"},
                   "felt stiffness / wall's"};
  for (std::size_t c = 0; c < kChoices.size(); ++c) {
    const auto all = [&](auto part) {
      std::vector<double> out;
      out.reserve(figures[c].size());
      for (const CouplingFigures& each : figures[c]) out.push_back(each.*part);
      return range(std::move(out));
    };
    const auto count = [&](auto holds) { return std::ranges::count_if(figures[c], holds); };
    const auto good = count([](const auto& f) { return f.good(); });
    table.rows.push_back(
        {std::string(nameOf(kChoices[c])) + (c == 0 ? " (baseline)" : ""), fmt::format("{} of {}", good, options.runs),
         number(100.0 * static_cast<double>(options.runs - good) / options.runs),
         std::to_string(count([](const auto& f) { return f.unstable; })), all(&CouplingFigures::least_energy_J),
         all(&CouplingFigures::oscillation_mm), all(&CouplingFigures::rest_difference_mm),
         all(&CouplingFigures::drag_N), all(&CouplingFigures::felt_share)});
  }
  table.notes = {
      fmt::format(
          "{} runs, seed {}: delay 0–700 ms one way, jitter up to 50 ms, 20 % lost, a message each 10 ms; walls "
          "50–5000 N/m, hands 0.5–1.5 kg, 2–10 N·s/m, 100–500 N/m. Least / median / most.",
          options.runs, options.seed),
      "Goals: energy ≥ −1 mJ, oscillation ≤ 0.5 mm (peak to peak, last second of the first press), difference of both "
      "ends ≤ 0.5 mm, drag ≤ 0.3 N, felt stiffness of the second press within 10 %.",
      "Unstable: swings by more than 20 mm, or gave back more than 0.1 J. Simulated hands and walls, nobody felt it."};
  return table;
}

}  // namespace fyd::bench
