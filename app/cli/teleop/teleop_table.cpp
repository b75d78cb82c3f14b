// fyd teleop table [--data FOLDER] [--seconds S] [--seed I] [--out PICTURE.svg] [--json]: the tele-gesture paper's
// Table 2 in numbers.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>

#include "app/cli/parts/output_file.h"
#include "app/cli/parts/trace_file.h"
#include "app/cli/teleop/teleop_cli.h"
#include "app/cli/teleop/teleop_picture.h"
#include "core/base/write_target.h"
#include "core/teleop/prediction/predictor_choice.h"

namespace fyd::cli {
namespace {

struct TableOptions {
  std::string data = "tests/data";
  double seconds = 10.0;
  std::uint64_t seed = 1;
  std::string out;
  bool json = false;
};

constexpr std::array<double, 4> kPeriods_ms = {10.0, 100.0, 250.0, 500.0};
constexpr double kWall_N_per_m = 500.0;

struct Network {
  std::string name;
  sim::NetworkProfile path;
};

std::vector<std::filesystem::path> csvFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> out;
  std::error_code none;
  for (const auto& each : std::filesystem::directory_iterator(folder, none)) {
    if (each.path().extension() == ".csv") out.push_back(each.path());
  }
  std::ranges::sort(out);
  return out;
}

std::vector<std::filesystem::path> networkFiles(const TableOptions& options) {
  return csvFiles(std::filesystem::path(options.data) / "network");
}

std::vector<Network> networks(const TableOptions& options) {
  std::vector<Network> out;
  for (const char* name : {"lan", "isdn", "adsl"}) out.push_back({name, networkPath(name, options.seed)});
  for (const auto& file : networkFiles(options)) {
    out.push_back({"5g " + file.stem().string(), networkPath(file, options.seed)});
  }
  return out;
}

/// The first seconds of it.
NamedTrace beginning(NamedTrace named, double seconds) {
  teleop::Trace& trace = named.trace;
  const auto rows = static_cast<std::size_t>(std::ranges::upper_bound(trace.time_s, trace.time_s.front() + seconds) -
                                             trace.time_s.begin());
  trace.time_s.resize(std::max<std::size_t>(rows, 2));
  trace.position_mm.resize(trace.time_s.size());
  return named;
}

void runTable(const TableOptions& options) {
  if (!(options.seconds >= 1.0 && options.seconds <= 3600.0)) {
    throw UsageError(say("--seconds {}: expected 1 … 3600", options.seconds));
  }
  std::vector<std::filesystem::path> files;
  for (const char* folder : {"", "teleop_1dof", "hand_motion"}) {
    std::ranges::move(csvFiles(std::filesystem::path(options.data) / folder), std::back_inserter(files));
  }
  if (files.empty()) {
    throw Failure(say("{}: no recordings (CSV files here, in teleop_1dof or in hand_motion)", options.data));
  }
  if (!options.out.empty()) {  // judged before the long work
    std::vector<std::string> inputs;
    inputs.reserve(files.size());
    for (const auto& file : files) inputs.push_back(file.string());
    for (const auto& file : networkFiles(options)) inputs.push_back(file.string());
    refuseToDestroy(options.out, inputs);
    if (!isOwnDescriptor(options.out)) static_cast<void>(valueOrFail(writeTargetOf(options.out)));
  }
  std::vector<NamedTrace> traces;
  traces.reserve(files.size());
  for (const auto& file : files) {
    traces.push_back(beginning(readTrace(file, {}), options.seconds));
    if (auto good = teleop::checkTrace(traces.back().trace); !good) {  // it may begin with a long gap
      throw Failure(about(file.string(), std::move(good.error().message)));
    }
  }
  const std::vector<Network> all = networks(options);
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  std::vector<TeleopPanel> panels;
  if (!options.json) {
    std::cout
        << "| recording | network | period ms | predictor | RMS mm | worst mm | added delay ms | jerk ratio | "
           "vibration ratio | least energy J | packets/s |\n|---|---|---:|---|---:|---:|---:|---:|---:|---:|---:|\n";
  }
  for (const Network& network : all) {
    for (const double period_ms : kPeriods_ms) {
      TeleopPanel panel{.network = network.name, .period_ms = period_ms, .rms_mm = {}};
      for (const std::string_view name : teleop::kPredictorNames) {
        double squares = 0.0, weight = 0.0;
        for (std::size_t i = 0; i < files.size(); ++i) {
          const NamedTrace& named = traces[i];
          sim::TeleopRunSettings settings{
              .period_ms = period_ms, .path = network.path, .predictor = valueOrFail(teleop::predictorNamed(name))};
          const sim::TeleopFigures free = runTeleop(named.trace, settings, nullptr);
          settings.wall_N_per_m = kWall_N_per_m;
          const double least_J = runTeleop(named.trace, settings, nullptr).least_energy_J;
          squares += free.rms_error_mm * free.rms_error_mm * free.seconds;
          weight += free.seconds;
          if (options.json) {
            rows.push_back({{"recording", files[i].stem().string()},
                            {"network", network.name},
                            {"period_ms", period_ms},
                            {"predictor", name},
                            {"rms_error_mm", jsonNumber(free.rms_error_mm)},
                            {"max_error_mm", jsonNumber(free.max_error_mm)},
                            {"added_delay_ms", jsonNumber(free.added_delay_ms)},
                            {"jerk_ratio", jsonNumber(free.jerk_ratio)},
                            {"vibration_ratio", jsonNumber(free.vibration_ratio)},
                            {"least_energy_J", jsonNumber(least_J)},
                            {"packets_per_s", jsonNumber(free.packets_per_s)}});
          } else {
            std::cout << fmt::format(
                             "| {} | {} | {} | {} | {:.3g} | {:.3g} | {} | {:.3g} | {:.3g} | {:.2g} | {:.3g} |\n",
                             files[i].stem().string(), network.name, period_ms, name, free.rms_error_mm,
                             free.max_error_mm, free.added_delay_ms, free.jerk_ratio, free.vibration_ratio, least_J,
                             free.packets_per_s)
                      << std::flush;
          }
        }
        panel.rms_mm.emplace_back(name, std::sqrt(squares / weight));
      }
      panels.push_back(std::move(panel));
    }
  }
  if (options.json) printJson(rows);
  if (!options.out.empty()) writeTextFile(options.out, teleopPicture(panels));
}

}  // namespace

void addTeleopTable(CLI::App& teleop) {
  auto options = std::make_shared<TableOptions>();
  CLI::App* table = teleop.add_subcommand(
      "table", "Periods of messages, networks and predictors over recorded hands: error, delay, vibration, energy");
  table->add_option("--data", options->data, "Folder of recordings; recorded networks in its folder network")
      ->capture_default_str();
  table->add_option("--seconds", options->seconds, "Of each recording")->capture_default_str();
  table->add_option("--seed", options->seed, "Seed of jitter and loss")
      ->transform(wholeNumberFrom(0))
      ->capture_default_str();
  table->add_option("--out", options->out, "Write the table as a picture (SVG)");
  table->add_flag("--json", options->json, "Rows as JSON");
  table->callback([options] { runTable(*options); });
}

}  // namespace fyd::cli
