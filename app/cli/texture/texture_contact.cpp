// fyd texture contact: touches and slips in a recording.
#include <array>
#include <iostream>
#include <memory>

#include "app/cli/texture/texture_cli.h"
#include "core/texture/contact_detector.h"

namespace fyd::cli {
namespace {

using namespace texture;

constexpr std::array<const char*, 4> kEventNames = {"none", "touch", "slip", "release"};

struct TextureContactOptions {
  std::string input;
  double rate_Hz = 0.0;
  ContactParameters parameters;
  bool json = false;
};

void contact(const TextureContactOptions& options) {
  const auto [start_s, rate_Hz, uniform] = readInput(options.input, options.rate_Hz);
  ContactDetector detector(options.parameters, rate_Hz);
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  std::array<int, kEventNames.size()> counts{};
  for (std::size_t n = 0; n < uniform.steps.size(); ++n) {
    if (uniform.steps[n].gap) continue;
    const auto event = static_cast<std::size_t>(detector.step(uniform.steps[n].acceleration_g));
    ++counts[event];
    if (event == 0) continue;
    const double t_s = start_s + static_cast<double>(n) / rate_Hz;
    events.push_back({{"t_s", t_s}, {"event", kEventNames[event]}});
    if (!options.json) std::cout << fmt::format("{:.6f} s  {}\n", t_s, kEventNames[event]);
  }
  if (!options.json) {
    std::cout << fmt::format("touches: {}, slips: {}\n", counts[1], counts[2]);
    return;
  }
  printJson({{"rate_Hz", rate_Hz},
             {"samples", uniform.steps.size()},
             {"gaps", uniform.gaps},
             {"touches", counts[1]},
             {"slips", counts[2]},
             {"threshold_g", jsonNumber(detector.threshold_g())},
             {"events", events}});
}

}  // namespace

void addTextureContact(CLI::App& parent) {
  auto options = std::make_shared<TextureContactOptions>();
  CLI::App* command =
      parent.add_subcommand("contact", "Find touches and slip onsets in accelerations (our own method)");
  addInputOptions(*command, options->input, options->rate_Hz);
  command->add_option("--ratio", options->parameters.threshold_ratio, "Threshold, in multiples of the noise floor")
      ->check(numberFrom(1.5, 100.0))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Events as JSON");
  command->callback([options] { contact(*options); });
}

}  // namespace fyd::cli
