// fyd texture render | fit | play | contact | felt | identify
#include <iostream>
#include <iterator>

#include "app/cli/texture/texture_cli.h"

namespace fyd::cli {

void writeSignal(const std::string& path, double start_s, double rate_Hz, std::span<const double> signal,
                 const std::string& input) {
  std::string text = "t_s,signal\n";
  for (std::size_t n = 0; n < signal.size(); ++n) {
    fmt::format_to(std::back_inserter(text), "{},{}\n", start_s + static_cast<double>(n) / rate_Hz, signal[n]);
  }
  writeTextFile(path, text, {input});
}

Input readInput(const std::string& path, double rate_Hz) {
  const texture::Recording recording = valueOrFail(texture::parseRecording(readTextFile(path), path, rate_Hz));
  if (!(rate_Hz > 0.0)) rate_Hz = recording.rate_Hz;
  auto uniform = texture::makeUniform(recording, rate_Hz);
  if (!uniform) throw Failure(about(path, std::move(uniform.error().message)));
  return {recording.start_s, rate_Hz, std::move(*uniform)};
}

texture::FeltPlant readPlant(const std::string& path) {
  if (path.empty()) return {};
  std::vector<std::string> unknown;
  const texture::FeltPlant plant = valueOrFail(texture::parsePlant(readTextFile(path), path, &unknown));
  for (const std::string& key : unknown) std::cerr << key << ": not known; it counts for nothing\n";
  return plant;
}

void addInputOptions(CLI::App& command, std::string& path, double& rate_Hz) {
  command.add_option("input", path, "CSV: t_s,ax,ay,az in s and g, or three columns and --rate")->required();
  command.add_option("--rate", rate_Hz, "Sample rate to work at, Hz; the recording's own when left out")
      ->check(numberFrom(1.0, 1e6));
}

void add_texture(CLI::App& app) {
  CLI::App* command = app.add_subcommand("texture", "Vibration: render, fit, play, find contacts, felt, identify");
  command->require_subcommand(1);
  addTextureRender(*command);
  addTextureFit(*command);
  addTexturePlay(*command);
  addTextureContact(*command);
  addTextureFelt(*command);
  addTextureIdentify(*command);
}

}  // namespace fyd::cli
