// fyd sense --adc A,B,C --at X,Y [--bridge V] [--profile P] [--set id=value] [--json]
#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>

#include "app/cli/command.h"
#include "app/cli/profile_options.h"
#include "core/sensing/indentation.h"
#include "core/sensing/load_cell.h"
#include "core/sensing/stiffness_estimator.h"

namespace fyd::cli {
namespace {

double parseNumber(std::string_view option, std::string_view text) {
  double value = 0.0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem == std::errc::result_out_of_range) return std::numeric_limits<double>::quiet_NaN();
  if (problem != std::errc() || end != text.data() + text.size()) {
    throw UsageError(say("{}: \"{}\" is not a number", option, text));
  }
  return value;
}

std::vector<double> parseNumbers(std::string_view option, std::string_view text, std::size_t expected) {
  std::vector<double> out;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    out.push_back(parseNumber(option, text.substr(begin, end - begin)));
    begin = end + 1;
  }
  if (out.size() != expected) {
    throw UsageError(say("{}: {} numbers, expected {} with commas between", option, out.size(), expected));
  }
  return out;
}

/// What is no 12-bit code becomes one that no sensor's span holds: invalid, like any other.
std::uint16_t toCode(double value) {
  constexpr std::uint16_t kNoCode = std::numeric_limits<std::uint16_t>::max();
  const double rounded = std::round(value);
  return rounded >= 0.0 && rounded <= 4095.0 ? static_cast<std::uint16_t>(rounded) : kNoCode;
}

struct Sensed {
  sensing::IndentationEstimate indentation;
  double force_N = std::numeric_limits<double>::quiet_NaN();
  sensing::StiffnessEstimate stiffness;
};

Sensed sense(const sensing::SensingParameters& parameters, const std::vector<double>& adc,
             const std::vector<double>& at, double bridge_mV_per_V) {
  Sensed out;
  sensing::IrCounts counts;
  for (const double value : adc) {
    if (!counts.push(toCode(value))) break;
  }
  out.indentation = sensing::IndentationEstimator(parameters.indentation).once(counts, at[0], at[1]);
  out.force_N = sensing::LoadCell(parameters.load_cell).force_N(bridge_mV_per_V);
  // One reading knows no slope: the ratio, under the same conditions.
  sensing::StiffnessParameters ratio = parameters.stiffness;
  ratio.mode = sensing::StiffnessMode::thesis;
  const Instant now = instantAt(1.0);
  out.stiffness =
      sensing::StiffnessEstimator(ratio).step(now, {.value = out.force_N, .taken = now, .count = 1}, out.indentation);
  return out;
}

}  // namespace

void add_sense(CLI::App& app) {
  struct Options {
    std::string adc;
    std::string at;
    std::string bridge;
    ProfileOptions profile;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command =
      app.add_subcommand("sense", "Distances, indentation, force and stiffness from one set of raw readings");
  command->add_option("--adc", options->adc, "12-bit codes of the distance sensors, A,B,C")->required();
  command->add_option("--at", options->at, "Finger's position X,Y, mm")->required();
  command->add_option("--bridge", options->bridge, "Load cell's bridge value, mV/V");
  options->profile.addTo(*command);
  command->add_flag("--json", options->json, "As JSON; null stands for what is invalid");
  command->callback([options] {
    const station::Profile profile = options->profile.load();
    options->profile.sayWhatIsOutdated(profile);
    const sensing::SensingParameters& parameters = profile.step.sensing;
    const std::size_t sensors = std::min(parameters.indentation.ir_x_mm.size(), parameters.indentation.ir_y_mm.size());
    const Sensed out = sense(
        parameters, parseNumbers("--adc", options->adc, sensors), parseNumbers("--at", options->at, 2),
        options->bridge.empty() ? std::numeric_limits<double>::quiet_NaN() : parseNumber("--bridge", options->bridge));
    nlohmann::ordered_json distances = nlohmann::ordered_json::array();
    nlohmann::ordered_json valid = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < sensors; ++i) {
      distances.push_back(jsonNumber(out.indentation.distance_mm[i]));
      valid.push_back(out.indentation.valid[i]);
    }
    const auto orNull = [](bool known, double value) { return jsonNumber(known ? value : std::nan("")); };
    const nlohmann::ordered_json json = {
        {"distance_mm", distances},
        {"valid", valid},
        {"indentation_mm", orNull(out.indentation.available, out.indentation.indentation_mm)},
        {"sigma_mm", orNull(out.indentation.available, out.indentation.sigma_mm)},
        {"force_N", jsonNumber(out.force_N)},
        {"stiffness_N_per_mm", orNull(out.stiffness.observable, out.stiffness.stiffness_N_per_mm)},
        {"indentation_reason", sensing::toString(out.indentation.reason)},
        {"stiffness_reason", sensing::toString(out.stiffness.reason)}};
    if (options->json) {
      printJson(json);
    } else {
      for (const auto& [key, value] : json.items()) std::cout << fmt::format("{}: {}\n", key, value.dump());
    }
  });
}

}  // namespace fyd::cli
