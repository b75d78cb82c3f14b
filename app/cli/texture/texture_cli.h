// What the subcommands of `fyd texture` share.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "app/cli/parts/command.h"
#include "app/cli/parts/output_file.h"
#include "core/texture/felt/felt_plant.h"
#include "core/texture/recording.h"

namespace fyd::cli {

void addTextureRender(CLI::App& parent);
void addTextureFit(CLI::App& parent);
void addTexturePlay(CLI::App& parent);
void addTextureContact(CLI::App& parent);
void addTextureFelt(CLI::App& parent);
void addTextureIdentify(CLI::App& parent);

/// CSV t_s,signal with the digits that round-trip.
void writeSignal(const std::string& path, double start_s, double rate_Hz, std::span<const double> signal,
                 const std::string& input);

/// The recording at the rate to work at: `rate_Hz`, or the recording's own when that is 0.
struct Input {
  double start_s = 0.0;
  double rate_Hz = 0.0;
  texture::UniformRecording uniform;
};
/// @throws Failure that names the file
[[nodiscard]] Input readInput(const std::string& path, double rate_Hz);
/// Constants of motors and cloth; keys that mean nothing are named on standard error. No path: the defaults.
[[nodiscard]] texture::FeltPlant readPlant(const std::string& path);
/// The positional argument and --rate, the same for every subcommand that reads a recording.
void addInputOptions(CLI::App& command, std::string& path, double& rate_Hz);

template <class Names>
std::vector<std::string> namesOf(const Names& names) {
  return {names.begin(), names.end()};
}

template <class Enum, class Names>
Enum choiceOf(const Names& names, const std::string& name) {
  return static_cast<Enum>(std::find(names.begin(), names.end(), name) - names.begin());
}

}  // namespace fyd::cli
