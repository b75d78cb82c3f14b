// The inverse of the cloth under a finger, as a causal filter.
//
//   |E(f)| = min(14 dB, 1/(|H(f)|·sinc(f/rate))),   H(s) = (2ζω₀s + ω₀²)/(s² + 2ζω₀s + ω₀²)
//
// H is how the finger follows a roller that pulls the cloth; sinc is the loss of a duty that is held for one sample
// (zero-order hold). E is of minimum phase (real cepstrum folded to its causal half), so its first tap answers at once.
// A new tuning glides in over 32 samples. Allocation-free after construction; tuning takes some microseconds.
#pragma once

#include <array>

#include "core/base/state.h"
#include "core/signal/fft.h"

namespace fyd::texture {

class InverseCloth {
 public:
  explicit InverseCloth(double sample_rate_Hz);

  /// @param resonance_Hz f₀ > 0; @param damping ζ > 0
  void tune(double resonance_Hz, double damping);
  [[nodiscard]] double step(double wanted);
  /// Whether the last tuning has not quite taken over yet.
  [[nodiscard]] bool gliding() const { return gliding_ > 0; }
  /// Forgets the signal; the last tuning holds at once.
  void reset();

  template <class Archive>
  void serialize(Archive& archive) {
    archive(taps_, goal_, recent_, within(newest_, kTaps - 1), within(gliding_, kGlide));
  }

 private:
  static constexpr int kFrame = 512;
  static constexpr int kTaps = 64;
  static constexpr int kGlide = 32;

  double rate_Hz_;
  signal::RealFft fft_;
  std::array<double, kTaps> taps_{};
  std::array<double, kTaps> goal_{};
  std::array<double, 2 * kTaps> recent_{};  // newest first from newest_; stored twice, so that they are contiguous
  int newest_ = 0;
  int gliding_ = 0;  // samples left until the taps are the goal
};

}  // namespace fyd::texture
