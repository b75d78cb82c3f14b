// fyd sense --table FILE.csv [--profile P] [--set id=value] [--json]
#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "app/cli/parts/command.h"
#include "app/cli/parts/profile_options.h"
#include "app/cli/sense_table.h"
#include "core/sensing/load_cell.h"
#include "core/sensing/stiffness_estimator.h"

namespace fyd::cli {
namespace {

constexpr double kLeastIndentation_mm = 0.5;  // a row may be a mean, which resolves smaller depths

struct Sensed {
  sensing::IndentationEstimate indentation;
  double force_N = std::numeric_limits<double>::quiet_NaN();
  sensing::StiffnessEstimate stiffness;
};

Sensed sense(const sensing::SensingParameters& parameters, const sensing::PressReading& press, double bridge_mV_per_V) {
  Sensed out;
  out.indentation = sensing::IndentationEstimator(parameters.indentation).once(press);
  out.force_N = sensing::LoadCell(parameters.load_cell).force_N(bridge_mV_per_V);
  // A single reading has no slope: stiffness is the ratio, under the same conditions.
  sensing::StiffnessParameters ratio = parameters.stiffness;
  ratio.mode = sensing::StiffnessMode::thesis;
  ratio.minimum_indentation_mm = std::min(ratio.minimum_indentation_mm, kLeastIndentation_mm);
  const Instant now = instantAt(1.0);
  out.stiffness =
      sensing::StiffnessEstimator(ratio).step(now, {.value = out.force_N, .taken = now, .count = 1}, out.indentation);
  return out;
}

nlohmann::ordered_json describe(const Sensed& sensed) {
  nlohmann::ordered_json distances = nlohmann::ordered_json::array();
  nlohmann::ordered_json valid = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < sensed.indentation.sensors; ++i) {
    distances.push_back(jsonNumber(sensed.indentation.distance_mm[i]));
    valid.push_back(sensed.indentation.valid[i]);
  }
  const auto orNull = [](bool known, double value) { return jsonNumber(known ? value : std::nan("")); };
  return {{"indentation_mm", orNull(sensed.indentation.available, sensed.indentation.indentation_mm)},
          {"indentation_sigma_mm", orNull(sensed.indentation.available, sensed.indentation.sigma_mm)},
          {"force_N", jsonNumber(sensed.force_N)},
          {"stiffness_N_per_mm", orNull(sensed.stiffness.observable, sensed.stiffness.stiffness_N_per_mm)},
          {"distance_mm", distances},
          {"valid", valid},
          {"indentation_reason", sensing::toString(sensed.indentation.reason)},
          {"stiffness_reason", sensing::toString(sensed.stiffness.reason)}};
}

}  // namespace

void add_sense(CLI::App& app) {
  struct Options {
    std::string table;
    ProfileOptions profile;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("sense", "Distances, indentation, force and stiffness of each row of a table of raw readings");
  command
      ->add_option("--table", options->table,
                   "CSV with the columns adc1,adc2,adc3,x_mm,y_mm,area_mm2,bridge_mV_per_V; an empty field means none")
      ->required();
  options->profile.addTo(*command);
  command->add_flag("--json", options->json, "As JSON; null stands for what is invalid");
  command->callback([options] {
    const station::Profile profile = options->profile.load();
    options->profile.warnOfOutdatedParts(profile);
    const sensing::SensingParameters& parameters = profile.step.sensing;
    const SenseTable table = readSenseTable(options->table, parameters.indentation);
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (std::size_t row = 0; row < table.rows(); ++row) {
      json.push_back(describe(sense(parameters, table.press(row), table.bridge_mV_per_V[row])));
    }
    if (options->json) {
      printJson(json);
      return;
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
      std::cout << fmt::format("{}:{}\n", options->table, table.lines[row]);
      for (const auto& [key, value] : json[row].items()) std::cout << fmt::format("  {}: {}\n", key, value.dump());
    }
  });
}

}  // namespace fyd::cli
