// The vibration felt by the finger: the mappings of texture to motor duty on a simulated plant that none of them knows.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <span>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/table.h"
#include "core/base/whole_file.h"
#include "core/signal/high_pass.h"
#include "core/sim/material.h"
#include "core/sim/resources.h"
#include "core/sim/touchpad/finger_vibration.h"
#include "core/texture/felt/felt_figures.h"
#include "core/texture/felt/felt_mapping.h"
#include "core/texture/pwm.h"
#include "core/texture/surface_model.h"
#include "core/texture/test_signals.h"
#include "core/texture/virtual_texture.h"

namespace fyd::bench {
namespace finger_rows {
namespace {

using namespace texture;

constexpr std::size_t kSamples = 4000;
constexpr double kRate_Hz = 1000.0;
constexpr double kCorner_Hz = 78.0;
constexpr double kSensed_Hz = 200.0;  // the materials' broadband part ends there
constexpr std::array<double, 3> kBreakaway_percent = {5.0, 15.0, 25.0};
constexpr std::array<double, 3> kResonance_Hz = {40.0, 70.0, 110.0};
constexpr std::array<const char*, 5> kSurfaces = {"fabric", "glass", "ribbed_plastic", "sandpaper", "wood"};

struct Stroke {
  double speed_mm_s;
  double force_N;
};
constexpr std::array<Stroke, 3> kStrokes = {{{20.0, 0.5}, {40.0, 1.0}, {60.0, 3.0}}};

using Signal = std::vector<double>;

Signal highPassed(const Signal& in) {
  signal::HighPass3 filter(signal::highPass(kCorner_Hz, kRate_Hz));
  Signal out;
  for (const double v : in) out.push_back(filter.step({v, 0.0, 0.0}).x);
  return out;
}

double rms(std::span<const double> x) {
  double sum = 0.0;
  for (const double v : x) sum += v * v;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(x.size(), 1)));
}

Signal scaled(Signal x, double to_g) {
  const double by = to_g / rms(x);
  for (double& v : x) v *= by;
  return x;
}

/// The texture signal of a simulated material along one axis, with speed and force varying like a hand's.
Signal materialSignal(sim::Material material, const Stroke& stroke, std::uint64_t seed) {
  const sim::MaterialProperties& properties = sim::propertiesOf(material);
  const Signal rough = bandNoise(kSamples, 0.5, kSensed_Hz, kRate_Hz, seed);
  Signal out;
  double travelled_mm = 0.0;
  for (std::size_t n = 0; n < kSamples; ++n) {
    const double t = static_cast<double>(n) / kRate_Hz;
    const double speed = stroke.speed_mm_s * (1.0 + 0.3 * std::sin(4.4 * t + 1.0));
    const double force = stroke.force_N * (1.0 + 0.3 * std::sin(2.8 * t + 0.3));
    travelled_mm += speed / kRate_Hz;
    double sum = properties.broadband_g * rough[n];
    for (const sim::SurfaceWave& wave : properties.waves) {
      sum += wave.amplitude_g.z * std::sin(2.0 * std::numbers::pi * travelled_mm / wave.length_mm + wave.phase_rad.z);
    }
    out.push_back(sum * speed / (speed + 30.0) * std::sqrt(force));
  }
  return highPassed(out);
}

std::vector<Signal> materials() {
  std::vector<Signal> out;
  std::uint64_t seed = 40;
  for (const sim::Material m :
       {sim::Material::foam, sim::Material::rubber, sim::Material::leather, sim::Material::wood}) {
    for (const Stroke& stroke : kStrokes) {
      Signal signal = materialSignal(m, stroke, ++seed);
      if (rms(signal) > 0.015) out.push_back(std::move(signal));
    }
  }
  return out;
}

std::vector<Signal> surfaces() {
  std::vector<Signal> out;
  for (const std::string name : kSurfaces) {
    const std::string path = sim::findResource(name, "textures");
    const auto text = readWholeFile(path);
    if (!text) continue;
    const auto model = parseSurface(*text, path);
    if (!model) continue;
    for (const Stroke& stroke : kStrokes) {
      VirtualTexture texture(*model, kRate_Hz, 77);
      Signal signal(kSamples);
      for (double& v : signal) v = texture.step(stroke.speed_mm_s, stroke.force_N);
      out.push_back(highPassed(signal));
    }
  }
  return out;
}

std::vector<Signal> noises() {
  std::vector<Signal> out;
  out.push_back(scaled(bandNoise(kSamples, 40.0, 120.0, kRate_Hz, 21), 0.1));
  out.push_back(scaled(bandNoise(kSamples, 80.0, 200.0, kRate_Hz, 22), 0.3));
  out.push_back(scaled(bandNoise(kSamples, 60.0, 250.0, kRate_Hz, 23), 1.0));
  return out;
}

Signal tap(double peak_g) {
  Signal out(kSamples, 0.0);
  for (std::size_t n = 0; n < 60; ++n) {
    const double t = static_cast<double>(n) / kRate_Hz;
    out[2000 + n] = peak_g * std::cos(2.0 * std::numbers::pi * 120.0 * t) * std::exp(-t / 0.01);
  }
  return out;
}

enum class Kind { symmetric, felt, stored, wrong_high, wrong_low };
constexpr std::array<const char*, 5> kKinds = {"symmetric (baseline)", "felt", "felt, level stored",
                                               "felt, constants 30 % high", "felt, constants 30 % low"};

struct Plant {
  double breakaway_percent = 0.0;
  double resonance_Hz = 0.0;
  sim::FingerVibrationParameters simulated{};
};

struct Result {
  FeltFigures figures;
  double duty_rms_percent = 0.0;
  double moved_deg = 0.0;
  double peak_g = 0.0;
  double ns = 0.0;
};

Result judge(Kind kind, const Signal& signal, const Plant& plant) {
  std::vector<std::array<double, kFeltMotors>> duties(signal.size());
  const double factor = kind == Kind::wrong_high ? 1.3 : kind == Kind::wrong_low ? 0.7 : 1.0;
  FeltPlant known;
  known.breakaway_percent.fill(plant.breakaway_percent * factor);
  known.resonance_Hz = plant.resonance_Hz * factor;
  FeltMapping mapping({.plant = known, .surface_level_g = kind == Kind::stored ? rms(signal) : 0.0}, kRate_Hz);
  const auto begin = std::chrono::steady_clock::now();
  for (std::size_t n = 0; n < signal.size(); ++n) {
    if (kind == Kind::symmetric) {
      duties[n].fill(symmetricDuty(signal[n], {}).percent);
    } else {
      duties[n] = mapping.step(signal[n], std::numeric_limits<double>::quiet_NaN()).percent;
    }
  }
  const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;

  sim::FingerVibrationParameters p = plant.simulated;
  p.breakaway_percent = plant.breakaway_percent;
  p.resonance_Hz = plant.resonance_Hz;
  sim::FingerVibration finger(p, 45.0);
  Result out;
  Signal felt;
  double heat = 0.0;
  for (const auto& duty : duties) {
    felt.push_back(finger.step(duty));
    heat += duty[0] * duty[0];
    out.moved_deg = std::max(out.moved_deg, std::abs(finger.stretch_deg() - 45.0));
    out.peak_g = std::max(out.peak_g, std::abs(felt.back()));
  }
  constexpr std::size_t kBegin = 500;  // the gain is learned
  out.figures = compareFelt(std::span(signal).subspan(kBegin), std::span<const double>(felt).subspan(kBegin));
  out.duty_rms_percent = std::sqrt(heat / static_cast<double>(duties.size()));
  out.ns = took.count() / static_cast<double>(signal.size());
  return out;
}

struct Mean {
  std::vector<Result> runs;

  template <class Get>
  [[nodiscard]] double of(Get get) const {
    double sum = 0.0;
    for (const Result& r : runs) sum += get(r);
    return sum / static_cast<double>(runs.size());
  }
  template <class Get>
  [[nodiscard]] double most(Get get) const {
    double out = get(runs.front());
    for (const Result& r : runs) out = std::max(out, get(r));
    return out;
  }
};

std::vector<std::string> row(const char* name, const std::string& what, const Plant& plant, const Mean& mean) {
  const auto felt = [](const Result& r) { return r.figures.level_g >= kFeltThreshold_g ? 100.0 : 0.0; };
  return {name,
          what,
          number(plant.breakaway_percent),
          number(plant.resonance_Hz),
          number(mean.of([](const Result& r) { return r.figures.spectral_match; }), 2),
          number(-mean.most([](const Result& r) { return -r.figures.spectral_match; }), 2),
          number(mean.of([](const Result& r) { return r.figures.third_octave_error_dB; }), 2),
          number(mean.of([](const Result& r) { return r.figures.envelope; }), 2),
          number(mean.of(felt)),
          number(1e3 * mean.of([](const Result& r) { return r.figures.level_g; })),
          number(1e3 * mean.most([](const Result& r) { return r.peak_g; })),
          number(mean.most([](const Result& r) { return r.figures.lag_ms; })),
          number(mean.most([](const Result& r) { return r.duty_rms_percent; })),
          number(mean.most([](const Result& r) { return r.moved_deg; }), 2),
          number(mean.of([](const Result& r) { return r.ns; }))};
}

}  // namespace

Table table() {
  Table out;
  out.subject = "texture_felt";
  out.title = "Texture: what arrives at a finger";
  out.columns = {{"mapping", Role::method},
                 {"signals", Role::group},
                 {"breakaway", "%", Role::group},
                 {"resonance", "Hz", Role::group},
                 "match",
                 "worst match",
                 {"third octaves", "dB", Role::error},
                 "envelope",
                 {"felt", "%"},
                 {"level", "mg"},
                 {"peak", "mg"},
                 {"lag", "ms"},
                 {"duty RMS", "%"},
                 {"stretch moved", "°"},
                 {"a sample", "ns", Role::cost}};
  const std::vector<Signal> of_materials = materials();
  const std::vector<Signal> of_surfaces = surfaces();
  const std::vector<Signal> of_noises = noises();
  const auto some = [](const std::array<double, 3>& all) {
    return std::span(all).first(wholeOrQuick<std::size_t>(all.size(), 1));
  };
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    for (const double breakaway : some(kBreakaway_percent)) {
      for (const double resonance : some(kResonance_Hz)) {
        const Plant plant{breakaway, resonance};
        const auto add = [&](const std::string& what, const std::vector<Signal>& signals) {
          if (signals.empty()) return;
          Mean mean;
          for (const Signal& signal : signals) mean.runs.push_back(judge(static_cast<Kind>(kind), signal, plant));
          out.rows.push_back(row(kKinds[kind], what, plant, mean));
        };
        add("materials", of_materials);
        add("stored surfaces", of_surfaces);
        add("noise bands", of_noises);
      }
    }
  }
  for (const double level : {0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0}) {
    const Plant plant{15.0, 70.0};
    out.rows.push_back(row("felt", fmt::format("noise 60–200 Hz of {} g", level), plant,
                           {{judge(Kind::felt, scaled(bandNoise(kSamples, 60.0, 200.0, kRate_Hz, 5), level), plant)}}));
  }
  for (const double resonance : kResonance_Hz) {
    const Plant plant{15.0, resonance};
    out.rows.push_back(row("felt", "a tap of 0.1 g", plant, {{judge(Kind::felt, tap(0.1), plant)}}));
  }
  const auto hard = [&](const char* what, const Plant& plant, const Signal& signal) {
    out.rows.push_back(row("felt", what, plant, {{judge(Kind::felt, signal, plant)}}));
  };
  const Signal middle = materialSignal(sim::Material::leather, kStrokes[1], 3);
  hard("leather; second motor with 50 % more friction", {25.0, 70.0, {.second_friction = 1.5}}, middle);
  hard("leather; pre-sliding of 0.008°", {15.0, 70.0, {.presliding_deg = 0.008}}, middle);
  hard("leather; pre-sliding of 0.03°", {25.0, 70.0, {.presliding_deg = 0.03}}, middle);
  hard("leather; slack cloth with play", {15.0, 70.0, {.tension_percent = 0.0}}, middle);
  hard("leather; second motor dead", {15.0, 70.0, {.second_strength = 0.0}}, middle);
  hard("wood at 20 mm/s", {15.0, 40.0}, materialSignal(sim::Material::wood, kStrokes[0], 4));
  hard("noise of 150–350 Hz", {15.0, 40.0}, scaled(bandNoise(kSamples, 150.0, 350.0, kRate_Hz, 6), 0.3));
  out.notes = {
      "The plant is core/sim/touchpad/finger_vibration.h with its defaults (second motor 7 % weaker with 15 % more "
      "friction), "
      "which "
      "the mapping does not know; breakaway and resonance are told to it, 30 % wrong where the row says so.",
      "Match: 1 − Σ|√P − √Pref| / Σ√Pref over 20 Hz to Nyquist, both spectra scaled to the same sum; third octaves: "
      "mean "
      "distance weighted by the wanted amplitude. Felt: RMS at the finger of 0.02 g and more, in % of the runs. Worst, "
      "peak, lag, duty and stretch are the worst of the runs. The first half second is left out.",
      "The simulated materials' broadband part ends at 200 Hz here. Nothing was tried on hardware."};
  if (of_surfaces.empty()) {
    out.notes.push_back(fmt::format("{}/textures: not found, so nothing of it is included.", sim::resourceFolder()));
  }
  return out;
}

}  // namespace finger_rows

Table bench_texture_felt() { return finger_rows::table(); }

}  // namespace fyd::bench
