// fyd texture felt: accelerations to the duty of each motor, and what a simulated finger feels of it.
#include <chrono>
#include <cmath>
#include <iostream>
#include <iterator>
#include <memory>

#include "app/cli/texture/texture_cli.h"
#include "core/sim/touchpad/finger_vibration.h"
#include "core/texture/felt/felt_figures.h"
#include "core/texture/felt/felt_mapping.h"
#include "core/texture/felt/finger_prediction.h"
#include "core/texture/method_bank.h"
#include "core/texture/pwm.h"

namespace fyd::cli {
namespace {

using namespace texture;

constexpr double kRate_Hz = 1000.0;  // of the motors' duties

struct FeltOptions {
  std::string input;
  std::string output;
  std::string mapping = "felt";
  std::string plant;
  std::string method = "recolour";
  double stretch_deg = FeltPlant{}.stretch_deg;
  double level_g = 0.0;
  double k_vib = 1.0;
  bool stretch_given = false;
  bool json = false;
};

struct FeltRow {
  double signal_g = 0.0;
  double wanted_g = 0.0;
  std::array<double, kFeltMotors> duty_percent{};
  bool limited = false;
};

/// Applies the chosen mapping as TextureRenderer does, without its transitions between mappings.
class Mapping {
 public:
  Mapping(const FeltOptions& options, const FeltPlant& plant)
      : choice_(choiceOf<PwmChoice>(kPwmNames, options.mapping)),
        pwm_{.k_vib = options.k_vib},
        felt_({.plant = plant, .gain = options.k_vib, .surface_level_g = options.level_g}, kRate_Hz) {
    felt_.setStretch(options.stretch_deg);
    felt_.reset();
  }

  FeltRow step(double signal_g, bool silent) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    if (choice_ == PwmChoice::felt) {
      const FeltDuty duty = felt_.step(signal_g, kUnknown);
      return {signal_g, duty.wanted_g, duty.percent, duty.clipped};
    }
    const bool thesis = choice_ == PwmChoice::thesis;
    const Duty wanted = thesis && silent ? Duty{} : thesis ? thesisDuty(signal_g, pwm_) : symmetricDuty(signal_g, pwm_);
    const Duty sent = limitDuty(wanted, pwm_.maximum_percent, kUnknown);
    return {signal_g, signal_g, {sent.percent, sent.percent}, sent.clipped};
  }

 private:
  PwmChoice choice_;
  PwmSettings pwm_;
  FeltMapping felt_;
};

sim::FingerVibrationParameters simulated(const FeltPlant& plant) {
  sim::FingerVibrationParameters out;
  out.breakaway_percent = plant.breakaway_percent[0];
  out.second_friction *= plant.breakaway_percent[1] / plant.breakaway_percent[0];
  out.free_speed_deg_s = plant.free_speed_deg_s;
  out.time_constant_ms = plant.time_constant_ms;
  out.position_gain = plant.position_gain_percent_per_deg;
  out.roller_radius_mm = plant.roller_radius_mm;
  // The simulation's own resonance is the one at the stretch at which its cloth's tension is given.
  out.resonance_Hz = plant.resonance_Hz +
                     plant.resonance_Hz_per_deg * (sim::FingerVibration::kReferenceStretch_deg - plant.stretch_deg);
  out.damping = plant.damping;
  out.resonance_Hz_per_deg = plant.resonance_Hz_per_deg;
  return out;
}

void write(const FeltOptions& options, double start_s, const std::vector<FeltRow>& rows) {
  std::string text = "t_s,signal_g,wanted_g,duty1_percent,duty2_percent,limited\n";
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const FeltRow& row = rows[n];
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", start_s + static_cast<double>(n) / kRate_Hz,
                   row.signal_g, row.wanted_g, row.duty_percent[0], row.duty_percent[1], row.limited ? 1 : 0);
  }
  writeTextFile(options.output, text, {options.input, options.plant});
}

nlohmann::ordered_json figuresOf(const std::vector<FeltRow>& rows, const FeltPlant& plant, double stretch_deg) {
  sim::FingerVibration simulation(simulated(plant), stretch_deg);
  std::vector<double> signal;
  std::vector<double> finger;
  std::array<double, kFeltMotors> heat{};
  double dead = 0.0;
  double limited = 0.0;
  double moved_deg = 0.0;
  double wanted = 0.0;
  for (const FeltRow& row : rows) {
    signal.push_back(row.signal_g);
    finger.push_back(plant.cloth_gain * simulation.step(row.duty_percent));
    wanted += row.signal_g * row.signal_g;
    for (std::size_t i = 0; i < kFeltMotors; ++i) heat[i] += row.duty_percent[i] * row.duty_percent[i];
    dead += inDeadZone(row.duty_percent, plant) ? 1.0 : 0.0;
    limited += row.limited ? 1.0 : 0.0;
    moved_deg = std::max(moved_deg, std::abs(simulation.stretch_deg() - stretch_deg));
  }
  const auto count = static_cast<double>(std::max<std::size_t>(rows.size(), 1));
  const FeltFigures f = compareFelt(signal, finger);
  const bool felt = f.level_g >= kFeltThreshold_g;
  return {{"spectral_match", jsonNumber(f.spectral_match)},
          {"third_octave_error_dB", jsonNumber(f.third_octave_error_dB)},
          {"envelope", jsonNumber(f.envelope)},
          {"level_g", jsonNumber(f.level_g)},
          {"level_dB", jsonNumber(f.level_dB)},
          {"felt", felt},
          {"out_of_reach", !felt && std::sqrt(wanted / count) > kWantedThreshold_g},
          {"lag_ms", jsonNumber(f.lag_ms)},
          {"dead_share", dead / count},
          {"limited_share", limited / count},
          {"duty_rms_percent", {std::sqrt(heat[0] / count), std::sqrt(heat[1] / count)}},
          {"stretch_moved_deg", moved_deg}};
}

void felt(const FeltOptions& options) {
  const FeltPlant plant = readPlant(options.plant);
  const double stretch_deg = options.stretch_given ? options.stretch_deg : plant.stretch_deg;
  const Input input = readInput(options.input, kRate_Hz);
  const UniformRecording& uniform = input.uniform;
  const TextureParameters defaults;
  auto method = valueOrFail(makeMethod(choiceOf<MethodChoice>(kMethodNames, options.method), kRate_Hz,
                                       frameLength(defaults.frame), hopLength(defaults.frame, defaults.hop)));
  OfflineChain chain(defaults.filter, defaults.corner_Hz, kRate_Hz, std::move(method));
  FeltOptions used = options;
  used.stretch_deg = stretch_deg;
  Mapping mapping(used, plant);

  std::vector<FeltRow> rows(uniform.steps.size());
  std::vector<double> signal(rows.size());
  for (std::size_t n = 0; n < rows.size(); ++n) signal[n] = chain.step(uniform.steps[n]);
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t n = 0; n < rows.size(); ++n) {
    const UniformStream::Step& in = uniform.steps[n];
    rows[n] = mapping.step(signal[n], in.gap || in.acceleration_g == Vec3{});
  }
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
  write(options, input.start_s, rows);

  nlohmann::ordered_json json = {
      {"mapping", options.mapping},
      {"method", options.method},
      {"plant", plant.identified ? "identified" : "not identified"},
      {"stretch_deg", stretch_deg},
      {"resonance_Hz", plant.resonanceAt_Hz(stretch_deg)},
      {"samples", rows.size()},
      {"gaps", uniform.gaps},
      {"refused_samples", uniform.refused},
      {"delay_ms", 1e3 * chain.delaySamples() / kRate_Hz},
      {"ns_per_sample", took.count() / static_cast<double>(std::max<std::size_t>(rows.size(), 1))}};
  json.update(figuresOf(rows, plant, stretch_deg));
  printValues(json, options.json);
}

}  // namespace

void addTextureFelt(CLI::App& parent) {
  auto options = std::make_shared<FeltOptions>();
  CLI::App* command =
      parent.add_subcommand("felt", "Accelerations at 1 kHz to the duty of both motors, and what a finger feels of it");
  command->add_option("input", options->input, "CSV: t_s,ax,ay,az in s and g, at 1 kHz")->required();
  command
      ->add_option("-o,--output", options->output,
                   "CSV to write: t_s,signal_g,wanted_g,duty1_percent,duty2_percent,limited; a row a millisecond")
      ->required();
  command->add_option("--mapping", options->mapping, "From signal to duty")
      ->check(CLI::IsMember({"thesis", "symmetric", "felt"}))
      ->capture_default_str();
  command->add_option("--plant", options->plant, "The way to the finger (plant.toml); not identified when left out");
  CLI::Option* stretch =
      command->add_option("--stretch", options->stretch_deg, "Stretch of the cloth, °; the plant's when left out")
          ->check(numberFrom(0.0, 120.0));
  command->add_option("--method", options->method, "How three axes become one; recolour has no delay")
      ->check(CLI::IsMember(namesOf(kMethodNames)))
      ->capture_default_str();
  command->add_option("--k-vib", options->k_vib, "Gain")->check(numberFrom(0.0, 10.0))->capture_default_str();
  command->add_option("--level", options->level_g, "Stored RMS of this surface, g; 0: learned")
      ->check(numberFrom(0.0, 100.0))
      ->capture_default_str();
  command->add_flag("--json", options->json, "Figures as JSON");
  command->callback([options, stretch] {
    options->stretch_given = stretch->count() > 0;
    felt(*options);
  });
}

}  // namespace fyd::cli
