// Inverse filter of the cloth with a finger on it: causal FIR, minimum phase.
//
//   |E(f)| = min(14 dB, 1/(|H(f)|·sinc(f/rate))),   H(s) = (2ζω₀s + ω₀²)/(s² + 2ζω₀s + ω₀²)
//
// H: transfer function from the roller's acceleration to the finger's. sinc: gain of the zero-order hold of the duty.
// E is made minimum-phase by folding its real cepstrum, so its energy is in the first taps and it adds no delay.
// After tune() the taps move linearly to the new ones over 32 samples. Allocation-free after construction; tune() takes
// some microseconds.
#pragma once

#include <array>

#include "core/base/state.h"
#include "core/signal/fft.h"

namespace fyd::texture {

class InverseCloth {
 public:
  explicit InverseCloth(double sample_rate_Hz);

  /// Designs the filter for another cloth.
  /// @param resonance_Hz f₀ = ω₀/2π > 0; @param damping ζ > 0
  void tune(double resonance_Hz, double damping);
  /// One sample. @param wanted acceleration of the finger @return acceleration of the roller, same unit
  [[nodiscard]] double step(double wanted);
  /// Whether the taps are still moving to those of the last tune().
  [[nodiscard]] bool inTransition() const { return transition_left_ > 0; }
  /// Clears the past samples; the taps of the last tune() apply at once.
  void reset();

  template <class Archive>
  void serialize(Archive& archive) {
    archive(taps_, target_taps_, delay_line_, within(newest_, kTaps - 1), within(transition_left_, kTransitionSamples));
  }

 private:
  static constexpr int kFrame = 512;  // FFT length of the design
  static constexpr int kTaps = 64;
  static constexpr int kTransitionSamples = 32;

  double rate_Hz_;
  signal::RealFft fft_;
  std::array<double, kTaps> taps_{};
  std::array<double, kTaps> target_taps_{};
  std::array<double, std::size_t{2} * kTaps>
      delay_line_{};  // past inputs, newest first from newest_; stored twice to be contiguous
  int newest_ = 0;
  int transition_left_ = 0;  // samples until taps_ equal target_taps_
};

}  // namespace fyd::texture
