// The texture report's curve: spectral match against delay, for every method and frame.
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "app/bench/parts/bench_options.h"
#include "app/bench/parts/table.h"
#include "core/base/whole_file.h"
#include "core/texture/dft321.h"
#include "core/texture/method_bank.h"
#include "core/texture/recording.h"
#include "core/texture/spectral_match.h"
#include "core/texture/test_signals.h"

namespace fyd::bench {
namespace {

using namespace texture;

std::size_t samples() { return wholeOrQuick<std::size_t>(32768, 4096); }
constexpr double kRate_Hz = 1000.0;
constexpr std::array<const char*, 2> kRecordings = {"fabric", "wood"};
constexpr const char* kFolder = "tests/data/texture_100hz";

struct Signal {
  std::string name;
  double rate_Hz;
  ThreeAxes axes;
};

ThreeAxes highPassed(const ThreeAxes& in, double corner_Hz, double rate_Hz) {
  signal::HighPass3 filter(signal::highPass(corner_Hz, rate_Hz));
  ThreeAxes out = in;
  for (std::size_t n = 0; n < in.x.size(); ++n) {
    const Vec3 a = {in.x[n], in.y[n], in.z[n]};
    if (n == 0) filter.settleAt(a);
    const Vec3 h = filter.step(a);
    out.x[n] = h.x;
    out.y[n] = h.y;
    out.z[n] = h.z;
  }
  return out;
}

/// The recordings at their own rate, or nothing when the program does not run from the project's folder.
std::vector<Signal> recorded() {
  std::vector<Signal> out;
  for (const std::string name : kRecordings) {
    const std::string path = fmt::format("{}/{}.csv", kFolder, name);
    const auto text = readWholeFile(path);
    if (!text) continue;
    const auto recording = parseRecording(*text, path, 0.0);
    if (!recording) continue;
    ThreeAxes axes;
    for (const AccelerationSample& s : recording->samples) {
      axes.x.push_back(s.acceleration_g.x);
      axes.y.push_back(s.acceleration_g.y);
      axes.z.push_back(s.acceleration_g.z);
    }
    out.push_back({name + ", recorded at 100 Hz", recording->rate_Hz, highPassed(axes, 10.0, recording->rate_Hz)});
  }
  return out;
}

std::vector<Signal> signals() {
  const auto noise = bandNoise(samples(), 30.0, 300.0, kRate_Hz, 2);
  std::vector<Signal> out;
  out.push_back({"one noise, three paths", kRate_Hz, spread(noise, {{{0.0, 1.0}, {3.0, 0.7}, {7.0, 0.5}}})});
  out.push_back({"equal gains, long paths", kRate_Hz,
                 spread(bandNoise(samples(), 20.0, 450.0, kRate_Hz, 4), {{{0.0, 1.0}, {5.0, 1.0}, {11.0, 1.0}}})});
  out.push_back({"a band on each axis",
                 kRate_Hz,
                 {bandNoise(samples(), 60.0, 150.0, kRate_Hz, 9), bandNoise(samples(), 150.0, 300.0, kRate_Hz, 10),
                  bandNoise(samples(), 250.0, 420.0, kRate_Hz, 11)}});
  out.push_back({"a chirp on each axis", kRate_Hz, chirps(samples(), 30.0, 450.0, kRate_Hz)});
  for (Signal& s : recorded()) out.push_back(std::move(s));
  return out;
}

struct Setting {
  MethodChoice method;
  int frame;
  int hop;
};

std::vector<Setting> settings() {
  std::vector<Setting> out;
  for (const MethodChoice m : {MethodChoice::soc, MethodChoice::single, MethodChoice::magnitude,
                               MethodChoice::principal, MethodChoice::recolour}) {
    out.push_back({m, 0, 0});
  }
  for (int frame = 8; frame <= 512; frame *= 2) {
    out.push_back({MethodChoice::dft321_thesis, frame, frame});
    for (const int parts : {1, 2, 4}) out.push_back({MethodChoice::dft321, frame, frame / parts});
  }
  return out;
}

int impulseDelay(const Setting& s, double rate_Hz) {
  auto method = std::move(*makeMethod(s.method, rate_Hz, std::max(s.frame, 2), std::max(s.hop, 1)));
  constexpr int kAt = 1001;
  int loudest = 0;
  double peak = 0.0;
  for (int n = 0; n < kAt + 1200; ++n) {
    const double out = std::abs(method->step({0.0, 0.0, n == kAt ? 1.0 : 0.0}));
    if (out > peak) {
      peak = out;
      loudest = n;
    }
  }
  return loudest - kAt;
}

struct Rendering {
  MatchFigures figures;
  double edge_jump = 0.0;
  int delay = 0;
  double ns_per_sample = 0.0;
};

Rendering run(const Setting& s, const Signal& signal) {
  auto method = std::move(*makeMethod(s.method, signal.rate_Hz, std::max(s.frame, 2), std::max(s.hop, 1)));
  const ThreeAxes& in = signal.axes;
  std::vector<double> out(in.x.size());
  // Runs of 64 samples, because one is shorter than reading the clock, and of a frame at least, because it is processed
  // at once.
  const auto length = static_cast<std::size_t>(std::max(64, s.frame));
  std::size_t n = 0;
  std::vector<double> times = timeEach(static_cast<int>(in.x.size() / length), [&] {
    for (const std::size_t end = n + length; n < end; ++n) out[n] = method->step({in.x[n], in.y[n], in.z[n]});
  });
  for (; n < out.size(); ++n) out[n] = method->step({in.x[n], in.y[n], in.z[n]});
  Rendering result;
  result.delay = method->delaySamples();
  result.figures = compareSpectra(in.x, in.y, in.z, out, result.delay, signal.rate_Hz);
  result.edge_jump = edgeJumpRatio(out, s.hop, result.delay);
  result.ns_per_sample = quantiles(times).p50 / static_cast<double>(length);
  return result;
}

/// The thesis' transform of a block, sines and cosines inside its loops [thesis §4.1.4], per sample.
double printedLoops_ns(int length) {
  const auto n = static_cast<std::size_t>(length);
  const auto source = bandNoise(n * 8, 30.0, 300.0, kRate_Hz, 5);
  std::vector<std::complex<double>> bins(n);
  double sink = 0.0;
  const double step = 2.0 * std::numbers::pi / length;
  auto times = timeEach(20, [&] {
    for (std::size_t k = 0; k < n; ++k) {
      std::complex<double> sum;
      double squares = 0.0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double re = 0.0;
        double im = 0.0;
        for (std::size_t i = 0; i < n; ++i) {
          const double angle = step * static_cast<double>(k * i);
          re += source[axis * n + i] * std::cos(angle);
          im -= source[axis * n + i] * std::sin(angle);
        }
        sum += std::complex<double>(re, im);
        squares += re * re + im * im;
      }
      bins[k] = std::polar(std::sqrt(squares), std::arg(sum));
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k < n; ++k) {
        const double angle = step * static_cast<double>(k * i);
        sink += bins[k].real() * std::cos(angle) - bins[k].imag() * std::sin(angle);
      }
    }
  });
  return quantiles(times).p50 / length + 0.0 * sink;
}

std::string label(const Setting& s) {
  const std::string name(kMethodNames[static_cast<std::size_t>(s.method)]);
  return s.method == MethodChoice::soc ? name + " (baseline)" : name;
}

}  // namespace

Table bench_texture() {
  Table table;
  table.subject = "texture";
  table.title = "Texture: what each millisecond of delay buys";
  table.columns = {{"method", Role::method},
                   {"signal", Role::group},
                   {"frame", Role::method},
                   {"hop", Role::method},
                   {"delay", "ms"},
                   {"impulse delay", "ms"},
                   "spectral match",
                   {"spectral mismatch", "", Role::error},
                   "energy ratio",
                   "edge jump",
                   {"a sample", "ns", Role::cost},
                   "× soc"};
  bool has_recording = false;
  for (const Signal& signal : wholeOrFirst(signals(), 1)) {
    has_recording = has_recording || signal.rate_Hz != kRate_Hz;
    double baseline_ns = 0.0;
    for (const Setting& s : settings()) {
      const Rendering r = run(s, signal);
      if (s.method == MethodChoice::soc) baseline_ns = r.ns_per_sample;
      const double ms = 1e3 / signal.rate_Hz;
      table.rows.push_back({label(s), signal.name, s.frame > 0 ? std::to_string(s.frame) : "—",
                            s.hop > 0 ? std::to_string(s.hop) : "—", number(r.delay * ms, 4),
                            number(impulseDelay(s, signal.rate_Hz) * ms, 4), number(r.figures.spectral_match),
                            number(1.0 - r.figures.spectral_match), number(r.figures.energy_ratio, 4),
                            number(r.edge_jump), number(r.ns_per_sample), number(r.ns_per_sample / baseline_ns)});
    }
  }
  const Rendering ours = run({MethodChoice::dft321, 64, 64}, signals().front());
  const double printed_ns = printedLoops_ns(64);
  table.notes = {
      fmt::format(
          "The thesis' printed loops at 64 samples take {} ns a sample, dft321 in blocks of 64 {}: {} times less.",
          number(printed_ns), number(ours.ns_per_sample), number(printed_ns / ours.ns_per_sample)),
      "Spectral match: 1 − Σ|√P − √Pref| / Σ√Pref over 20 Hz to Nyquist, Welch spectra (Hann, 512 samples), Pref the "
      "sum of "
      "the three axes' spectra. It says nothing about what a person feels.",
      "Time of the method alone, median of runs of 64 samples or a frame. Edge jump: mean step at frame edges over "
      "mean step "
      "elsewhere; "
      "with overlapped frames the edges of hops."};
  if (!has_recording) {
    table.notes.push_back(fmt::format("{}: not found; run from the project's folder to include it.", kFolder));
  }
  return table;
}

}  // namespace fyd::bench
