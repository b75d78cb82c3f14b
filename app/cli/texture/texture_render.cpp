// fyd texture render: three axes of acceleration to one signal, with figures.
#include <algorithm>
#include <chrono>
#include <iostream>
#include <memory>

#include "app/cli/texture/texture_cli.h"
#include "core/signal/high_pass.h"
#include "core/texture/method_bank.h"
#include "core/texture/spectral_match.h"

namespace fyd::cli {
namespace {

using namespace texture;

struct TextureRenderOptions {
  std::string input;
  std::string output;
  double rate_Hz = 0.0;
  std::string method = "dft321";
  std::string filter = "default";
  double corner_Hz = TextureParameters{}.corner_Hz;
  bool corner_given = false;
  int frame = 32;
  int hop = 0;
  bool json = false;
};

struct Rendered {
  std::vector<double> signal;
  ThreeAxes filtered;
  double ns_per_sample = 0.0;
};

/// Timed in runs of 64 samples, because one is shorter than reading the clock, and of a frame at least, because it is
/// processed at once; the median run counts.
Rendered renderAll(const std::vector<UniformStream::Step>& steps, OfflineChain& chain, int frame) {
  const auto run = static_cast<std::size_t>(std::max(64, frame));
  Rendered out;
  out.signal.resize(steps.size());
  for (auto* axis : {&out.filtered.x, &out.filtered.y, &out.filtered.z}) axis->resize(steps.size());
  std::vector<double> runs_ns;
  for (std::size_t from = 0; from < steps.size(); from += run) {
    const std::size_t to = std::min(from + run, steps.size());
    const auto start = std::chrono::steady_clock::now();
    for (std::size_t n = from; n < to; ++n) {
      out.signal[n] = chain.step(steps[n]);
      out.filtered.x[n] = chain.filtered_g().x;
      out.filtered.y[n] = chain.filtered_g().y;
      out.filtered.z[n] = chain.filtered_g().z;
    }
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - start;
    runs_ns.push_back(took.count() / static_cast<double>(to - from));
  }
  const auto middle = runs_ns.begin() + static_cast<std::ptrdiff_t>(runs_ns.size() / 2);
  std::nth_element(runs_ns.begin(), middle, runs_ns.end());
  out.ns_per_sample = *middle;
  return out;
}

int hopOf(const TextureRenderOptions& options) {
  if (options.hop != 0) return options.hop;
  const bool overlaps = options.method == "dft321" && options.frame % 2 == 0;
  return overlaps ? options.frame / 2 : options.frame;
}

/// Samples from one edge of a frame to the next in the signal; 0: the method has no frames.
int edgePeriodOf(const TextureRenderOptions& options) {
  switch (choiceOf<MethodChoice>(kMethodNames, options.method)) {
    case MethodChoice::dft321: return hopOf(options);
    case MethodChoice::dft321_thesis: return options.frame + 1;  // a silent sample between two blocks
    default: return 0;
  }
}

void render(const TextureRenderOptions& options) {
  const int hop = hopOf(options);
  const auto choice = choiceOf<MethodChoice>(kMethodNames, options.method);
  if (auto good = checkFrame(choice, options.frame, hop); !good) throw UsageError(good.error().message);
  const auto filter = choiceOf<FilterChoice>(kFilterNames, options.filter);
  if (options.corner_given && filter != FilterChoice::standard) {
    throw UsageError(say("--corner {} Hz: filter {} has none to choose; expected --filter default", options.corner_Hz,
                         options.filter));
  }
  const auto [start_s, rate_Hz, uniform] = readInput(options.input, options.rate_Hz);
  const double highest_Hz = signal::kHighestCorner * rate_Hz;
  if (options.corner_given && options.corner_Hz > highest_Hz) {
    throw UsageError(say("--corner {} Hz: expected at most {} Hz, {} of the {} samples a second", options.corner_Hz,
                         highest_Hz, signal::kHighestCorner, rate_Hz));
  }
  OfflineChain chain(filter, options.corner_Hz, rate_Hz, valueOrFail(makeMethod(choice, rate_Hz, options.frame, hop)));
  const Rendered rendered = renderAll(uniform.steps, chain, options.frame);
  if (!options.output.empty()) writeSignal(options.output, start_s, rate_Hz, rendered.signal, options.input);

  const int delay = chain.delaySamples();
  const ThreeAxes& axes = rendered.filtered;
  const MatchFigures figures = compareSpectra(axes.x, axes.y, axes.z, rendered.signal, delay, rate_Hz);
  const nlohmann::ordered_json json = {
      {"method", options.method},
      {"filter", options.filter},
      {"rate_Hz", rate_Hz},
      {"frame", options.frame},
      {"hop", hop},
      {"samples", rendered.signal.size()},
      {"gaps", uniform.gaps},
      {"refused_samples", uniform.refused},
      {"spectral_match", jsonNumber(figures.spectral_match)},
      {"energy_ratio", jsonNumber(figures.energy_ratio)},
      {"delay_ms", 1e3 * delay / rate_Hz},
      {"ns_per_sample", jsonNumber(rendered.ns_per_sample)},
      {"edge_jump_ratio", jsonNumber(edgeJumpRatio(rendered.signal, edgePeriodOf(options), delay))}};
  printValues(json, options.json);
}

}  // namespace

void addTextureRender(CLI::App& parent) {
  auto options = std::make_shared<TextureRenderOptions>();
  CLI::App* command = parent.add_subcommand("render", "Turn three axes of acceleration into one texture signal");
  addInputOptions(*command, options->input, options->rate_Hz);
  command->add_option("-o,--output", options->output, "CSV to write: t_s,signal (before PWM)");
  command->add_option("--method", options->method, "How three axes become one")
      ->check(CLI::IsMember(namesOf(kMethodNames)))
      ->capture_default_str();
  command->add_option("--frame", options->frame, "Samples in a frame of dft321")
      ->transform(wholeNumberFrom(2, kMaximumFrame))
      ->capture_default_str();
  command
      ->add_option("--hop", options->hop,
                   "Advance of a frame: the frame (blocks) or a divisor of it; half when left out")
      ->transform(wholeNumberFrom(1, kMaximumFrame));
  command->add_option("--filter", options->filter, "High-pass; none also skips the removal of the rest acceleration")
      ->check(CLI::IsMember(namesOf(kFilterNames)))
      ->capture_default_str();
  CLI::Option* corner = command->add_option("--corner", options->corner_Hz, "Corner of the default high-pass, Hz")
                            ->check(numberFrom(1.0, 1e5))
                            ->capture_default_str();
  command->add_flag("--json", options->json, "Figures as JSON");
  command->callback([options, corner] {
    options->corner_given = corner->count() > 0;
    render(*options);
  });
}

}  // namespace fyd::cli
