// fyd texture identify: the dynamics from motor duty to finger (the plant), from a sweep.
#include <iostream>
#include <memory>

#include "app/cli/texture/texture_cli.h"
#include "core/texture/felt/felt_identification.h"

namespace fyd::cli {
namespace {

struct IdentifyOptions {
  std::string input;
  std::string output;
  std::string base;
  bool json = false;
};

void identify(const IdentifyOptions& options) {
  const texture::FeltPlant base = readPlant(options.base);
  const auto sweep = valueOrFail(texture::parseSweep(readTextFile(options.input), options.input));
  const auto found = texture::identifyPlant(sweep, base);
  if (!found) throw Failure(about(options.input, found.error().message));
  const std::string text = texture::formatPlant(found->plant);
  // Parsed before it is written, to check its ranges.
  (void)valueOrFail(texture::parsePlant(text, options.output));
  writeTextFile(options.output, text, {options.input, options.base});

  nlohmann::ordered_json motors = nlohmann::ordered_json::array();
  for (const texture::FoundBreakaway& b : found->breakaway) {
    motors.push_back({{"breakaway_percent", b.percent},
                      {"sigma_percent", b.sigma_percent},
                      {"asymmetry_percent", b.asymmetry_percent}});
  }
  nlohmann::ordered_json chirps = nlohmann::ordered_json::array();
  for (const texture::FoundCloth& c : found->cloths) {
    chirps.push_back({{"part", c.part},
                      {"stretch_deg", c.stretch_deg},
                      {"resonance_Hz", c.resonance_Hz},
                      {"sigma_Hz", jsonNumber(c.sigma_Hz)},
                      {"damping", c.damping},
                      {"sigma_damping", jsonNumber(c.sigma_damping)},
                      {"gain", c.gain},
                      {"delay_ms", c.delay_ms},
                      {"held_out_error", c.held_out_error}});
  }
  const nlohmann::ordered_json json = {{"verdict", found->verdict},
                                       {"motors", motors},
                                       {"chirps", chirps},
                                       {"sliding_share", found->sliding_share},
                                       {"resonance_Hz", found->plant.resonance_Hz},
                                       {"resonance_Hz_per_deg", found->plant.resonance_Hz_per_deg},
                                       {"damping", found->plant.damping},
                                       {"cloth_gain", found->plant.cloth_gain},
                                       {"sigma_resonance_Hz", jsonNumber(found->sigma_resonance_Hz)},
                                       {"held_out_error", found->held_out_error}};
  printValues(json, options.json);
}

}  // namespace

void addTextureIdentify(CLI::App& parent) {
  auto options = std::make_shared<IdentifyOptions>();
  CLI::App* command = parent.add_subcommand(
      "identify", "The way to the finger from duty ramps and chirps with an accelerometer on the cloth");
  command
      ->add_option("input", options->input,
                   "CSV at 1 kHz: t_s,part,stretch_deg,duty1_percent,duty2_percent,encoder1_counts,encoder2_counts,"
                   "acceleration_g")
      ->required();
  command->add_option("-o,--output", options->output, "plant.toml to write")->required();
  command->add_option(
      "--base", options->base,
      "plant.toml with what the sweep cannot measure: free speed, time constant, position gain, radius");
  command->add_flag("--json", options->json, "Figures as JSON");
  command->callback([options] { identify(*options); });
}

}  // namespace fyd::cli
