// fyd texture fit, fyd texture play: surface models from recordings, and signals from models.
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "app/cli/texture/texture_cli.h"
#include "core/sim/resources.h"
#include "core/texture/recording.h"
#include "core/texture/surface_model.h"
#include "core/texture/virtual_texture.h"

namespace fyd::cli {
namespace {

using namespace texture;

struct FitOptions {
  std::string input;
  std::string output;
  std::string name;
  double rate_Hz = 0.0;
  double speed_mm_s = 0.0;
  double force_N = 1.0;
  bool json = false;
};

ThreeAxes axesOf(const UniformRecording& uniform) {
  ThreeAxes out;
  for (const UniformStream::Step& step : uniform.steps) {
    if (step.gap) continue;
    out.x.push_back(step.acceleration_g.x);
    out.y.push_back(step.acceleration_g.y);
    out.z.push_back(step.acceleration_g.z);
  }
  return out;
}

void fit(const FitOptions& options) {
  const Input input = readInput(options.input, options.rate_Hz);
  const ThreeAxes axes = axesOf(input.uniform);
  const std::string stem = std::filesystem::path(options.input).stem().string();
  const auto result = fitSurface(axes.x, axes.y, axes.z,
                                 {.name = options.name.empty() ? stem : options.name,
                                  .sample_rate_Hz = input.rate_Hz,
                                  .speed_mm_s = options.speed_mm_s,
                                  .force_N = options.force_N});
  if (!result) throw Failure(about(options.input, result.error().message));
  const std::string text = formatSurface(result->model);
  if (!options.output.empty()) writeTextFile(options.output, text, {options.input});
  if (options.json) {
    printJson({{"name", result->model.name},
               {"bands", result->model.bands.size()},
               {"rate_Hz", input.rate_Hz},
               {"spectral_match", jsonNumber(result->spectral_match)}});
  } else if (options.output.empty()) {
    std::cout << text;
  } else {
    std::cout << fmt::format("{}: {} bands, spectral match {:.3f}\n", options.output, result->model.bands.size(),
                             result->spectral_match);
  }
}

struct PlayOptions {
  std::string model;
  std::string output;
  double speed_mm_s = 0.0;
  double force_N = 0.0;
  double rate_Hz = 1000.0;
  double duration_s = 5.0;
  std::uint64_t seed = 1;
  bool json = false;
};

void play(const PlayOptions& options) {
  valueOrFail(texture::checkSamples(options.duration_s * options.rate_Hz, options.duration_s, options.rate_Hz));
  const std::string file = sim::findResource(options.model, "textures");
  const SurfaceModel model = valueOrFail(parseSurface(readTextFile(file), file));
  VirtualTexture surface(model, options.rate_Hz, options.seed);
  std::vector<double> signal(static_cast<std::size_t>(std::llround(options.duration_s * options.rate_Hz)));
  double energy = 0.0;
  for (double& sample : signal) {
    sample = surface.step(options.speed_mm_s, options.force_N);
    energy += sample * sample;
  }
  const double rms_g = signal.empty() ? 0.0 : std::sqrt(energy / static_cast<double>(signal.size()));
  writeSignal(options.output, 0.0, options.rate_Hz, signal, file);
  if (options.json) {
    printJson({{"name", model.name}, {"samples", signal.size()}, {"rms_g", rms_g}});
  } else {
    std::cout << fmt::format("{}: {} samples of {}, RMS {:.4g} g\n", options.output, signal.size(), model.name, rms_g);
  }
}

}  // namespace

void addTextureFit(CLI::App& parent) {
  auto options = std::make_shared<FitOptions>();
  CLI::App* command = parent.add_subcommand("fit", "Make a surface model from a recording");
  addInputOptions(*command, options->input, options->rate_Hz);
  command->add_option("-o,--output", options->output, "Model to write (TOML); standard output when left out");
  command->add_option("--name", options->name, "Name of the surface; the file's when left out");
  command
      ->add_option("--speed", options->speed_mm_s,
                   "Speed of the stroke, mm/s: the bands then move with the finger; they stay when it is left out")
      ->check(numberFrom(texture::FitConditions::kSlowest_mm_s, texture::FitConditions::kFastest_mm_s));
  command->add_option("--force", options->force_N, "Force of the stroke, N")
      ->check(numberFrom(texture::FitConditions::kLeastForce_N, texture::FitConditions::kLargestForce_N))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Figures as JSON");
  command->callback([options] { fit(*options); });
}

void addTexturePlay(CLI::App& parent) {
  auto options = std::make_shared<PlayOptions>();
  CLI::App* command = parent.add_subcommand("play", "Render a stored surface at one speed and force");
  command->add_option("model", options->model, "Surface model: a file (TOML), or the name of one that comes along")
      ->required();
  command->add_option("--speed", options->speed_mm_s, "Finger speed, mm/s")->required()->check(numberFrom(0.0, 1000.0));
  command->add_option("--force", options->force_N, "Normal force, N")->required()->check(numberFrom(0.0, 20.0));
  command->add_option("-o,--output", options->output, "CSV to write: t_s,signal")->required();
  command->add_option("--rate", options->rate_Hz, "Sample rate, Hz")
      ->check(numberFrom(50.0, 1e5))
      ->capture_default_str();
  command->add_option("--duration", options->duration_s, "Length, s")
      ->check(numberFrom(0.0, 3600.0))
      ->capture_default_str();
  command->add_option("--seed", options->seed, "Seed of the surface's noise")
      ->transform(wholeNumberFrom(0))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Figures as JSON");
  command->callback([options] { play(*options); });
}

}  // namespace fyd::cli
