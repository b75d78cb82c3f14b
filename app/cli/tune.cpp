// fyd tune [--recording FILE.csv] [--plant-scale S] [--noise N] [--delay MS] [--friction PERCENT] [--hysteresis H]
//          [--cloth NAME] [--seed I] [--profile P] [--set id=value] [--json]
#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/cli/parts/command.h"
#include "app/cli/parts/trial_options.h"
#include "core/base/csv.h"
#include "core/control/auto_tune.h"
#include "core/control/static_law.h"

namespace fyd::cli {
namespace {

/// A session's telemetry (fyd station --telemetry) in which the stretch was moved while a finger held still.
std::vector<control::TuneSample> readRecording(const std::string& path) {
  std::vector<std::string> columns{"t_s", "stretch_measured_deg", "stiffness_N_per_mm", "stiffness_observable"};
  const std::string text = readCsvText(path);  // once: a pipe cannot be read again
  CsvTable table = valueOrFail(parseCsv(text, path, columns));
  const bool placed = std::ranges::find(table.header, "stiffness_place_factor") != table.header.end();
  if (placed) {
    columns.emplace_back("stiffness_place_factor");
    table = valueOrFail(parseCsv(text, path, columns));
  }
  std::vector<control::TuneSample> recording;
  recording.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (std::isnan(table.values[1][i])) continue;
    const bool observable = table.values[3][i] == 1.0;
    const double factor = placed && std::isfinite(table.values[4][i]) ? table.values[4][i] : 1.0;
    recording.push_back(
        {table.values[0][i], table.values[1][i], observable ? table.values[2][i] / factor : std::nan("")});
  }
  return recording;
}

nlohmann::ordered_json gains(const control::ControlParameters& p) {
  return {{"kp", p.kp},
          {"ki", p.ki_per_s},
          {"kd", p.kd_s},
          {"measurement_delay_s", p.measurement_delay_s},
          {"measurement_lag_s", p.measurement_lag_s},
          {"noise_correlation_s", p.noise_correlation_s}};
}

nlohmann::ordered_json predicted(const control::LoopPrediction& loop) {
  return {{"overshoot_pct", jsonNumber(loop.overshoot_percent)},
          {"settling_s", jsonNumber(loop.settling_s)},
          {"gain_margin", jsonNumber(loop.margins.gain_margin)},
          {"phase_margin_deg", jsonNumber(loop.margins.phase_margin_deg)},
          {"stable", loop.stable()}};
}

nlohmann::ordered_json simulated(sim::StiffnessTrial trial, const control::ControlParameters& parameters,
                                 double target_N_per_mm) {
  trial.parameters.control = parameters;
  trial.target_N_per_mm = target_N_per_mm;
  const sim::TrialResult result = sim::runTrial(trial);
  return {{"target_N_per_mm", target_N_per_mm},
          {"overshoot_pct", jsonNumber(result.overshoot_percent)},
          {"settling_s", jsonNumber(result.settling_s)},
          {"steady_error_pct", jsonNumber(result.steady_error_percent)},
          {"stable", result.stable}};
}

nlohmann::ordered_json side(const control::ControlParameters& parameters, const control::LoopPrediction& loop) {
  nlohmann::ordered_json json = gains(parameters);
  json["predicted"] = predicted(loop);
  return json;
}

void printTune(const nlohmann::ordered_json& json) {
  const auto row = [](const std::string& name, const nlohmann::ordered_json& before,
                      const nlohmann::ordered_json& after) {
    std::cout << fmt::format("{:<28}{:>14}{:>14}\n", name, before.dump(), after.dump());
  };
  std::cout << "Cloth and sensors\n";
  for (const auto& [key, value] : json["cloth"].items()) std::cout << fmt::format("{:<28}{:>14}\n", key, value.dump());
  std::cout << fmt::format("\n{:<28}{:>14}{:>14}\n", "", "before", "after");
  for (const char* group : {"predicted", "simulated"}) {
    if (!json["before"].contains(group)) continue;
    for (const auto& [key, value] : json["before"][group].items()) {
      row(fmt::format("{} {}", group, key), value, json["after"][group][key]);
    }
  }
  for (const auto& [key, value] : json["before"].items()) {
    if (!value.is_object()) row("control." + key, value, json["after"][key]);
  }
  std::cout << "\nNothing was changed. To use the proposal, set these values in the profile.\n";
}

/// Four significant digits; the recording does not support more.
void roundNumbers(nlohmann::ordered_json& json) {
  if (json.is_number_float()) json = std::stod(fmt::format("{:.4g}", json.get<double>()));
  if (json.is_structured()) {
    for (auto& item : json) roundNumbers(item);
  }
}

}  // namespace

void add_tune(CLI::App& app) {
  struct Options {
    TrialOptions trial;
    std::string recording;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("tune", "Identify the cloth from a safe excitation and propose PID gains; changes nothing");
  const auto of_the_simulation = options->trial.addTo(*command);
  auto* from_file = command->add_option("--recording", options->recording,
                                        "Telemetry of a session to identify from (CSV); the simulation when left out");
  for (CLI::Option* option : of_the_simulation) from_file->excludes(option);
  command->add_flag("--json", options->json, "As JSON");
  command->callback([options] {
    const sim::StiffnessTrial trial = options->trial.load();
    const control::ControlParameters& present = trial.parameters.control;
    const bool simulate = options->recording.empty();
    const auto recording = simulate ? sim::recordExcitation(trial) : readRecording(options->recording);
    const control::TuneProposal proposal = valueOrFail(control::proposeGains(recording, present));

    const control::IdentifiedCloth& cloth = proposal.cloth;
    nlohmann::ordered_json json;
    json["cloth"] = {{"scale", cloth.scale},
                     {"shape_gain", cloth.shape_gain},
                     {"gain_N_per_mm_per_deg", cloth.slope_N_per_mm_deg},
                     {"delay_s", cloth.delay_s},
                     {"lag_s", cloth.lag_s},
                     {"noise_relative", cloth.residual_rms_relative},
                     {"noise_correlation_s", cloth.noise_correlation_s}};
    json["before"] = side(present, proposal.before);
    json["after"] = side(proposal.proposed, proposal.after);
    if (simulate) {
      const control::StaticLaw law(present);
      const double target = cloth.scale * std::sqrt(law.minimumStiffness_N_per_mm() * law.maximumStiffness_N_per_mm());
      json["before"]["simulated"] = simulated(trial, present, target);
      json["after"]["simulated"] = simulated(trial, proposal.proposed, target);
    }
    json["applied"] = false;
    roundNumbers(json);
    if (options->json) {
      printJson(json);
    } else {
      printTune(json);
    }
  });
}

}  // namespace fyd::cli
