// Gives a signal the spectrum of three axes together, without delay: the energy correction of the methods.
//
// A method that mixes axes loses energy where they cancel and gains it where they agree. This filter measures both
// sides,
//
//   Pref(k) = smoothed Σ|Aᵢ(k)|²,   P(k) = smoothed |B(k)|²      (Hann frames of 128, every 32 samples, 0.3 s)
//   G(k)    = √( (Pref(k) + ε) / (P(k) + ε) ),  held within ±18 dB,  ε = 10⁻⁴ · max(Pref, energy of the frame)
//
// and filters B with the minimum-phase filter of magnitude G (real cepstrum folded to its causal half), 64 taps,
// gliding from one set to the next. Minimum phase: the first tap answers at once, so an impulse is not delayed; what G
// adds is ringing of at most 63 samples. A slow gain (0.5 s, within ±3 dB) on top takes out the bias that a ratio of
// two noisy estimates has. With axes that need no correction G is 1 and the filter changes nothing.
//
// Costs about 0.1 µs a sample; the work of a frame is divided over two steps. Allocation-free after construction.
// Stability: may change
#pragma once

#include <array>

#include "core/base/api.h"
#include "core/base/state.h"
#include "core/base/vec3.h"
#include "core/signal/fft.h"

namespace fyd::texture {

class FYD_API SpectralEqualiser {
 public:
  explicit SpectralEqualiser(double sample_rate_Hz);

  /// @param signal what the method made; @param axes the accelerations it was made of, equally late
  [[nodiscard]] double step(double signal, const Vec3& axes);
  void reset();

  template <class Archive>
  void serialize(Archive& archive) {
    archive(history_, reference_, power_, taps_, tap_steps_, next_taps_, recent_, frame_energy_,
            within(newest_, kTaps - 1), within(filled_, kHop - 1), counter(frames_), energy_in_, energy_out_);
  }

 private:
  static constexpr int kFrame = 128;
  static constexpr int kHop = 32;
  static constexpr int kTaps = 64;
  static constexpr int kBins = kFrame / 2 + 1;

  void measure();
  void design();
  [[nodiscard]] double filtered(double signal);
  [[nodiscard]] double trimmed(double equalised, const Vec3& axes);

  signal::RealFft fft_;
  double frame_share_;  // of a new frame in the smoothed spectra
  double trim_share_;   // of a new sample in the smoothed energies
  std::array<double, kFrame> window_{};
  std::array<std::array<double, kFrame>, 4> history_{};  // x, y, z, signal; oldest first
  std::array<double, kBins> reference_{};
  std::array<double, kBins> power_{};
  std::array<double, kTaps> taps_{};
  std::array<double, kTaps> tap_steps_{};
  std::array<double, kTaps> next_taps_{};
  std::array<double, std::size_t{2} * kTaps> recent_{};  // the signal, newest first from newest_
  double frame_energy_ = 0.0;                            // of the three axes, smoothed like their spectra
  int newest_ = 0;
  int filled_ = 0;
  int frames_ = 0;
  double energy_in_ = 0.0;
  double energy_out_ = 0.0;
};

}  // namespace fyd::texture
