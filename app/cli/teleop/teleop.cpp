// fyd teleop run --trace CSV --period MS --delay MS [--jitter MS] [--loss PCT] [--profile NAME] --predictor NAME
//                --coupling NAME [--smooth MS] [--deadband PCT] [--wall N_PER_M] [--columns A,B,C] [--seed I]
//                [--out FILE] [--json]
#include "app/cli/teleop/teleop_cli.h"

#include "app/cli/parts/command.h"
#include "app/cli/parts/output_file.h"
#include "app/cli/parts/trace_file.h"
#include "core/base/csv.h"
#include "core/teleop/coupling/coupling_choice.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::cli {
namespace {

struct RunOptions {
  std::string trace;
  std::vector<std::string> columns;
  std::string profile, predictor = "default", coupling = "model", out;
  std::optional<double> delay_ms, jitter_ms, loss_percent;
  std::uint64_t seed = 1;
  sim::TeleopRunSettings settings;
  bool json = false;
};

constexpr double kUsualDelay_ms = 50.0;

void writeRows(const RunOptions& options, const std::vector<sim::TeleopRow>& rows) {
  std::string text =
      "t_s,hand_x_mm,hand_y_mm,hand_z_mm,far_x_mm,far_y_mm,far_z_mm,hand_force_N,far_force_N,told_x_mm,told_x_mm_per_s,"
      "told_force_N\n";
  for (const sim::TeleopRow& row : rows) {
    text += fmt::format("{:.3f}", row.t_s);
    for (const auto& at : {row.hand_mm, row.far_mm}) text += fmt::format(",{},{},{}", at[0], at[1], at[2]);
    text += fmt::format(",{},{},{},{},{}\n", row.hand_force_N, row.far_force_N, row.told_x_mm, row.told_x_mm_per_s,
                        row.told_force_N);
  }
  writeTextFile(options.out, text, {options.trace, options.profile});
}

void runRun(RunOptions options) {
  const auto predictor = teleop::predictorNamed(options.predictor);
  if (!predictor) throw UsageError(predictor.error().message);
  const auto coupling = teleop::couplingNamed(options.coupling);
  if (!coupling) throw UsageError(coupling.error().message);
  sim::TeleopRunSettings& settings = options.settings;
  settings.predictor = *predictor;
  settings.coupling = *coupling;
  if (!options.profile.empty() && options.delay_ms) {
    throw UsageError(say("--delay: a recorded profile has its own"));
  }
  const auto takeOptions = [&] {
    for (sim::NetworkSettings* way : {&settings.path.forward, &settings.path.backward}) {
      if (options.profile.empty()) way->delay_ms = options.delay_ms.value_or(kUsualDelay_ms);
      way->jitter_ms = options.jitter_ms.value_or(way->jitter_ms);
      way->loss_percent = options.loss_percent.value_or(way->loss_percent);
    }
    if (auto good = sim::checkTeleopRun(settings); !good) throw UsageError(good.error().message);
  };
  takeOptions();  // before files are opened
  if (!options.profile.empty()) {
    settings.path = networkPath(options.profile, options.seed);
    takeOptions();
  }
  settings.path.forward.seed = 2 * options.seed;
  settings.path.backward.seed = 2 * options.seed + 1;
  const NamedTrace named = readTrace(options.trace, options.columns, sim::kLongestRun_s);
  std::vector<sim::TeleopRow> rows;
  const sim::TeleopFigures f = runTeleop(named.trace, settings, options.out.empty() ? nullptr : &rows);
  if (!options.out.empty()) writeRows(options, rows);
  const nlohmann::ordered_json json{{"predictor", options.predictor},
                                    {"coupling", options.coupling},
                                    {"columns", named.columns},
                                    {"seconds", f.seconds},
                                    {"scale", jsonNumber(f.scale)},
                                    {"linked_percent", jsonNumber(100.0 * f.linked_share)},
                                    {"rms_error_mm", jsonNumber(f.rms_error_mm)},
                                    {"max_error_mm", jsonNumber(f.max_error_mm)},
                                    {"believed_rms_mm", jsonNumber(f.believed_rms_mm)},
                                    {"believed_max_mm", jsonNumber(f.believed_max_mm)},
                                    {"added_delay_ms", jsonNumber(f.added_delay_ms)},
                                    {"jerk_ratio", jsonNumber(f.jerk_ratio)},
                                    {"vibration_ratio", jsonNumber(f.vibration_ratio)},
                                    {"largest_step_mm", jsonNumber(f.largest_step_mm)},
                                    {"orientation_rms_deg", jsonNumber(f.orientation_rms_deg)},
                                    {"orientation_held_rms_deg", jsonNumber(f.orientation_held_rms_deg)},
                                    {"least_energy_J", jsonNumber(f.least_energy_J)},
                                    {"energy_J", jsonNumber(f.energy_J)},
                                    {"dissipated_J", jsonNumber(f.dissipated_J)},
                                    {"drag_N", jsonNumber(f.drag_N)},
                                    {"packets_per_s", jsonNumber(f.packets_per_s)},
                                    {"back_packets_per_s", jsonNumber(f.back_packets_per_s)},
                                    {"packets_without_per_s", jsonNumber(f.packets_without_per_s)},
                                    {"datagram_bits", f.message_bits},
                                    {"deadband_percent", settings.deadband_percent},
                                    {"told_percent", jsonNumber(100.0 * f.told_share)},
                                    {"told_force_percent", jsonNumber(100.0 * f.told_force_share)},
                                    {"deadband_worst", jsonNumber(f.deadband_worst)},
                                    {"deadband_force_worst", jsonNumber(f.deadband_force_worst)}};
  printValues(json, options.json);
}

sim::DelayTrace recordedRoundTrips(const std::string& text, const std::string& path) {
  const CsvTable table = valueOrFail(parseCsv(text, path, {"sent_ms", "rtt_ms"}));
  sim::DelayTrace out;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double t_s = 1e-3 * (table.values[0][row] - table.values[0][0]);
    const double delay_ms = 0.5 * table.values[1][row];
    if (!(delay_ms >= 0.0 && delay_ms <= 30'000.0)) {
      throw Failure(say("{}:{}: round trip {} ms: expected 0 … 60000", path, table.lines[row], table.values[1][row]));
    }
    if (!out.t_s.empty() && !(t_s > out.t_s.back())) continue;  // two in one millisecond: the first counts
    out.t_s.push_back(t_s);
    out.delay_ms.push_back(delay_ms);
  }
  if (out.t_s.empty()) throw Failure(say("{}: no rows; expected sent_ms,rtt_ms", path));
  return out;
}

}  // namespace

sim::NetworkProfile networkPath(const std::string& name, std::uint64_t seed) {
  sim::NetworkProfile path;
  if (name.ends_with(".csv")) {
    const std::string text = readCsvText(name);  // once: a pipe cannot be read again
    const CsvTable head = valueOrFail(parseCsv(text, name, {}));
    const bool round_trips = std::ranges::find(head.header, "rtt_ms") != head.header.end();
    path.forward.trace = round_trips ? recordedRoundTrips(text, name) : valueOrFail(sim::parseDelayTrace(text, name));
    path.backward.trace = path.forward.trace;
  } else {
    auto known = sim::networkProfile(name);
    if (!known) throw UsageError(known.error().message);
    path = *known;
  }
  path.forward.seed = 2 * seed;
  path.backward.seed = 2 * seed + 1;
  return path;
}

void add_teleop(CLI::App& app) {
  CLI::App* teleop = app.add_subcommand("teleop", "Two linked devices over a bad network");
  teleop->require_subcommand(1);
  auto options = std::make_shared<RunOptions>();
  CLI::App* run = teleop->add_subcommand("run", "A recorded hand moves one simulated desktop arm, another one follows");
  run->add_option("--trace", options->trace, "CSV with t_s and one to three columns in mm; gaps are crossed straight")
      ->required();
  addColumnsOption(*run, options->columns);
  run->add_option("--period", options->settings.period_ms, "Between two messages, both ways, ms")
      ->capture_default_str();
  run->add_option("--delay", options->delay_ms, "One way, ms; 50 when neither this nor a profile is given");
  run->add_option("--jitter", options->jitter_ms, "Standard deviation of the delay, ms; nothing overtakes");
  run->add_option("--loss", options->loss_percent, "Share of the messages lost, %");
  run->add_option("--profile", options->profile,
                  "isdn, adsl, lan, or a CSV with delay_ms, t_s,delay_ms or sent_ms,rtt_ms (half of it is one way)");
  run->add_option("--predictor", options->predictor, "order0, order1, hybrid, kalman, ar or default")
      ->capture_default_str();
  run->add_option("--coupling", options->coupling, "spring, tdpa or model")->capture_default_str();
  run->add_option("--smooth", options->settings.smooth_ms,
                  "Time constant with which a correction decays, ms; by period and delay when not given");
  run->add_option("--deadband", options->settings.deadband_percent,
                  "Send only what differs by so much, % of speed or force; 0: a message each period");
  run->add_option("--wall", options->settings.wall_N_per_m,
                  "Stiffness of a wall across the middle of the far device's first axis, N/m; 0: none");
  run->add_option("--seed", options->seed, "Seed of jitter and loss")
      ->transform(wholeNumberFrom(0))
      ->capture_default_str();
  run->add_option("--out", options->out, "Write both devices and forces as CSV, a row a millisecond");
  run->add_flag("--json", options->json, "Result as JSON");
  run->callback([options] { runRun(*options); });
  addTeleopTable(*teleop);
}

}  // namespace fyd::cli
