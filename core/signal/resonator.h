// A band-pass whose centre may move from sample to sample without clicks or instability.
//
// Topology-preserving state-variable filter (trapezoidal integrators; Zavalishin, "The Art of VA Filter Design", ch.
// 4):
//   g = tan(π·f/rate), k = 1/Q, v1 = (ic1 + g·(x − ic2)) / (1 + g·(g + k)), v2 = ic2 + g·v1, output k·v1,
// unity gain at the centre. Driven by white noise of variance 1 its output has the variance of `noisePower`.
// Stability: may change
#pragma once

#include "core/base/api.h"

namespace fyd::signal {

class FYD_API Resonator {
 public:
  /// @param frequency_Hz is brought into 1e-5 … 0.49 of `sample_rate_Hz`
  /// @param quality centre over −3 dB width; at least 0.1
  void tune(double frequency_Hz, double quality, double sample_rate_Hz);
  [[nodiscard]] double step(double x);
  void reset() { ic1_ = ic2_ = 0.0; }

  /// Variance at the output per unit variance of white noise at the input: g·k / (1 + g·k + g²).
  [[nodiscard]] double noisePower() const { return g_ * k_ / (1.0 + g_ * k_ + g_ * g_); }
  /// |H|² at a frequency, for fits: k²w²/((1 − w²)² + k²w²) with w = tan(π·f/rate)/g.
  [[nodiscard]] double powerGain(double frequency_Hz, double sample_rate_Hz) const;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(g_, k_, normaliser_, ic1_, ic2_);
  }

 private:
  double g_ = 0.1;
  double k_ = 1.0;
  double normaliser_ = 1.0 / (1.0 + 0.1 * 1.1);
  double ic1_ = 0.0;
  double ic2_ = 0.0;
};

}  // namespace fyd::signal
