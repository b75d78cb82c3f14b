// Textures: the chain from three axes to one signal, stored surfaces, their fit and their rendering, spectra.
#include <fmt/format.h>

#include <cmath>

#include "app/python/parameters.h"
#include "core/signal/high_pass.h"
#include "core/signal/welch.h"
#include "core/texture/method_bank.h"
#include "core/texture/recording.h"
#include "core/texture/spectral_match.h"
#include "core/texture/surface_model.h"
#include "core/texture/virtual_texture.h"

namespace fyd::python {
namespace {

using texture::OfflineChain;
using texture::SurfaceBand;
using texture::SurfaceModel;

/// High-pass and method, and whether the sample before was a gap.
struct Chain {
  explicit Chain(const texture::TextureParameters& p)
      : chain(p.filter, p.corner_Hz, p.sample_rate_Hz,
              valid(texture::makeMethod(p.method, p.sample_rate_Hz, frameLength(p.frame), hopLength(p.frame, p.hop)))) {
  }

  double step(const Vec3& acceleration_g) {
    const bool is_gap = !acceleration_g.finite();
    const texture::UniformStream::Step step{
        .gap = is_gap, .resumed = gap && !is_gap, .acceleration_g = is_gap ? Vec3() : acceleration_g};
    gap = is_gap;
    return chain.step(step);
  }

  OfflineChain chain;
  bool gap = true;  // the first sample resumes
};
using ChainOwner = Shared<Chain>;
using TextureOwner = Shared<texture::VirtualTexture>;

struct Axes {
  std::vector<double> x, y, z;
};
Axes axesOf(std::span<const Vec3> rows, const char* name) {
  Axes out;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (!rows[i].finite())
      throw Refusal{
          fmt::format("{}: row {} is ({}, {}, {}); expected finite numbers", name, i, rows[i].x, rows[i].y, rows[i].z)};
    out.x.push_back(rows[i].x), out.y.push_back(rows[i].y), out.z.push_back(rows[i].z);
  }
  return out;
}

void addSurfaces(py::module_& module) {
  py::class_<SurfaceBand>(module, "SurfaceBand", "A band of noise of a stored surface.")
      .def(py::init([](double wavelength_mm, double frequency_Hz, double quality, double rms_g) {
             return SurfaceBand{wavelength_mm, frequency_Hz, quality, rms_g};
           }),
           py::arg("wavelength_mm") = 0.0, py::arg("frequency_Hz") = 0.0, py::arg("quality") = 1.0,
           py::arg("rms_g") = 0.0, "Exactly one of wavelength_mm [mm] and frequency_Hz [Hz]; rms_g [g].")
      .def_readwrite("wavelength_mm", &SurfaceBand::wavelength_mm, "More than 0: the centre moves with the finger [mm]")
      .def_readwrite("frequency_Hz", &SurfaceBand::frequency_Hz, "More than 0: the centre stays [Hz]")
      .def_readwrite("quality", &SurfaceBand::quality, "Centre over the width at −3 dB [1]")
      .def_readwrite("rms_g", &SurfaceBand::rms_g, "At the reference speed and force [g]");
  py::class_<SurfaceModel>(module, "Surface", "A stored surface: a sum of noise bands.")
      .def(py::init<>(), "Without a name and a band; see from_text. Units: none.")
      .def_readwrite("name", &SurfaceModel::name, "For people [—]")
      .def_readwrite("description", &SurfaceModel::description, "For people [—]")
      .def_readwrite("reference_speed_mm_s", &SurfaceModel::reference_speed_mm_s,
                     "Speed at which the bands hold [mm/s]")
      .def_readwrite("reference_force_N", &SurfaceModel::reference_force_N, "Force at which the bands hold [N]")
      .def_readwrite("speed_exponent", &SurfaceModel::speed_exponent, "How the amplitude grows with speed [1]")
      .def_readwrite("force_exponent", &SurfaceModel::force_exponent, "How the amplitude grows with force [1]")
      .def_property(
          "bands", [](const SurfaceModel& surface) { return py::tuple(py::cast(surface.bands)); },
          [](SurfaceModel& surface, const std::vector<SurfaceBand>& bands) { surface.bands = bands; },
          "A tuple of SurfaceBand, set as a whole [each in its unit]")
      .def_static(
          "from_text",
          [](const std::string& text, const std::string& name) { return valid(texture::parseSurface(text, name)); },
          py::arg("text"), py::arg("name") = "surface",
          "Reads TOML, as resources/textures has it; `name` begins each message. Units: in the keys.")
      .def(
          "text", [](const SurfaceModel& surface) { return texture::formatSurface(surface); },
          "TOML that from_text reads back equal. Units: in the keys.");
  module.def(
      "fit_surface",
      [](const Numbers& accelerations_g, double rate_Hz, double speed_mm_s, double force_N, const std::string& name) {
        const Axes axes = axesOf(vectors(accelerations_g, "accelerations_g"), "accelerations_g");
        auto fit = [&] {
          const OthersGoOn others_go_on;
          return texture::fitSurface(
              axes.x, axes.y, axes.z,
              {.name = name, .sample_rate_Hz = rate_Hz, .speed_mm_s = speed_mm_s, .force_N = force_N});
        }();
        const texture::SurfaceFit fitted = valid(std::move(fit));
        return py::make_tuple(fitted.model, fitted.spectral_match);
      },
      py::arg("accelerations_g"), py::arg("rate_Hz") = 1000.0, py::arg("speed_mm_s") = 0.0, py::arg("force_N") = 1.0,
      py::arg("name") = "fitted",
      "A surface from recorded accelerations_g [g], shape (n, 3), at rate_Hz [Hz]; speed_mm_s [mm/s] and force_N [N] "
      "of the "
      "finger; speed 0: not known, the bands then stay at fixed frequencies. (Surface, spectral match [1: equal]).");
  py::class_<TextureOwner>(module, "VirtualTexture",
                           "A stored surface as it feels under a finger of any speed and force.")
      .def(py::init([](const SurfaceModel& surface, double rate_Hz, std::uint64_t seed) {
             return std::make_unique<TextureOwner>(checkedSurface(surface), checkedRate(rate_Hz), seed);
           }),
           py::arg("surface"), py::arg("rate_Hz") = 1000.0, py::arg("seed") = 1,
           "At rate_Hz [Hz]; the same seed gives the same noise.")
      .def(
          "run",
          [](TextureOwner& texture, const Numbers& speed_mm_s, const Numbers& force_N) {
            const auto speed = vector(speed_mm_s, "speed_mm_s");
            const auto force = vector(force_N, "force_N");
            if (speed.size() != force.size())
              throw Refusal{fmt::format("force_N: {} values for {} of speed_mm_s", force.size(), speed.size())};
            std::vector<double> out(speed.size());
            texture.run([&](texture::VirtualTexture& each) {
              for (std::size_t i = 0; i < out.size(); ++i) out[i] = each.step(speed[i], force[i]);
            });
            return arrayOf(std::move(out));
          },
          py::arg("speed_mm_s"), py::arg("force_N"),
          fmt::format(
              "The signal [g] for a finger of these speeds [mm/s] and forces [N]; what is negative or not finite "
              "counts as 0, more than {} mm/s or {} N as these. Other threads go on meanwhile.",
              texture::VirtualTexture::kFastest_mm_s, texture::VirtualTexture::kHardest_N)
              .c_str())
      .def(
          "reset", [](TextureOwner& texture) { texture.run([](texture::VirtualTexture& each) { each.reset(); }); },
          "Back to silence and the seed. Units: none.");
}

}  // namespace

void addTextures(py::module_& module) {
  addSurfaces(module);
  py::class_<ChainOwner>(module, "TextureChain",
                         "From three axes of acceleration to one signal: removal of rest, high-pass and method.")
      .def(py::init([](const ParameterSet* parameters) {
             return std::make_unique<ChainOwner>(orDefaults(parameters).texture);
           }),
           py::arg("parameters") = py::none(),
           "By texture.method, texture.filter, texture.corner_Hz, texture.sample_rate_Hz, texture.frame and "
           "texture.hop. "
           "Units: their own.")
      .def(
          "run",
          [](ChainOwner& chain, const Numbers& accelerations_g) {
            const auto rows = vectors(accelerations_g, "accelerations_g");
            for (std::size_t i = 0; i < rows.size(); ++i) {
              const Vec3& row = rows[i];
              const bool is_gap = std::isnan(row.x) || std::isnan(row.y) || std::isnan(row.z);
              if (!is_gap && !texture::plausible(row))
                throw Refusal{fmt::format(
                    "accelerations_g: row {} is ({}, {}, {}); expected {} to {}, or NaN for a gap", i, row.x, row.y,
                    row.z, -texture::kLargestAcceleration_g, texture::kLargestAcceleration_g)};
            }
            std::vector<double> out(rows.size());
            chain.run([&](Chain& each) {
              for (std::size_t i = 0; i < out.size(); ++i) out[i] = each.step(rows[i]);
            });
            return arrayOf(std::move(out));
          },
          py::arg("accelerations_g"),
          "The signal [g], as long as accelerations_g [g] of shape (n, 3), and delay_samples later; a row with NaN is "
          "a gap. "
          "Goes on where the last call ended. Other threads go on meanwhile.")
      .def_property_readonly(
          "delay_samples",
          [](ChainOwner& chain) { return chain.run([](Chain& each) { return each.chain.delaySamples(); }); },
          "How much later the signal comes [sample]");
  module.def(
      "high_pass",
      [](double corner_Hz, double rate_Hz) {
        texture::TextureParameters parameters;
        const auto bound = bindParameters(parameters);
        const double corner = valid(checkParameter(*findParameter(bound, "texture.corner_Hz"), corner_Hz));
        const double highest_Hz = signal::kHighestCorner * checkedRate(rate_Hz);
        if (corner > highest_Hz)
          throw Refusal{fmt::format("corner_Hz: {}; expected at most {}, {} of rate_Hz = {}", corner, highest_Hz,
                                    signal::kHighestCorner, rate_Hz)};
        const auto c = signal::highPass(corner, rate_Hz);
        return py::make_tuple(py::make_tuple(c.b0, c.b1, c.b2), py::make_tuple(1.0, c.a1, c.a2));
      },
      py::arg("corner_Hz"), py::arg("rate_Hz") = 1000.0,
      fmt::format(
          "Coefficients (b, a) of the default filter, a Butterworth high-pass of second order with its corner at "
          "corner_Hz [Hz], as texture.corner_Hz may be and at most {} of rate_Hz [Hz], as texture.sample_rate_Hz may "
          "be.",
          signal::kHighestCorner)
          .c_str());
  module.def(
      "welch",
      [](const Numbers& signal, double rate_Hz, int segment) {
        const auto values = vector(signal, "signal");
        if (segment < 2) throw Refusal{fmt::format("segment: {}; expected 2 samples or more", segment)};
        const double rate = checkedRate(rate_Hz);
        signal::Spectrum spectrum = [&] {
          const OthersGoOn others_go_on;
          return signal::welch(values, rate, segment);
        }();
        std::vector<double> at_Hz(spectrum.density.size());
        for (std::size_t i = 0; i < at_Hz.size(); ++i) at_Hz[i] = spectrum.frequency_Hz(i);
        return py::make_tuple(arrayOf(std::move(at_Hz)), arrayOf(std::move(spectrum.density)));
      },
      py::arg("signal"), py::arg("rate_Hz") = 1000.0, py::arg("segment") = 512,
      "(Frequencies [Hz], one-sided density [unit²/Hz]) by Welch's method: Hann, half overlapped, no detrending. "
      "rate_Hz "
      "[Hz] as texture.sample_rate_Hz may be.");
  module.def(
      "spectral_match",
      [](const Numbers& accelerations_g, const Numbers& signal_g, int delay_samples, double rate_Hz) {
        const Axes axes = axesOf(vectors(accelerations_g, "accelerations_g"), "accelerations_g");
        const auto signal = vector(signal_g, "signal_g");
        if (signal.size() != axes.x.size())
          throw Refusal{
              fmt::format("signal_g: {} values for {} rows of accelerations_g", signal.size(), axes.x.size())};
        for (std::size_t i = 0; i < signal.size(); ++i)  // one of them would make both figures NaN or 0
          if (!std::isfinite(signal[i]))
            throw Refusal{fmt::format("signal_g: row {} is {}; expected finite numbers", i, signal[i])};
        if (delay_samples < 0) throw Refusal{fmt::format("delay_samples: {}; expected 0 or more", delay_samples)};
        const double rate = checkedRate(rate_Hz);
        const texture::MatchFigures figures = [&] {
          const OthersGoOn others_go_on;
          return texture::compareSpectra(axes.x, axes.y, axes.z, signal, delay_samples, rate);
        }();
        return py::make_tuple(figures.spectral_match, figures.energy_ratio);
      },
      py::arg("accelerations_g"), py::arg("signal_g"), py::arg("delay_samples") = 0, py::arg("rate_Hz") = 1000.0,
      "How well one signal [g] stands for three axes [g], shape (n, 3): (spectral match [1: equal], its energy over "
      "theirs [1]). NaN: the axes hold nothing to compare with, from 20 Hz on for the match, or fewer than 8 rows are "
      "left after delay_samples. A figure about spectra, never about what a person feels.");
}

}  // namespace fyd::python
