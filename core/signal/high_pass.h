// Second-order high-pass filters for acceleration.
// Stability: may change
#pragma once

#include "core/base/api.h"
#include "core/base/vec3.h"
#include "core/signal/biquad.h"

namespace fyd::signal {

inline constexpr double kHighestCorner = 0.49;  ///< of the sample rate

/// Butterworth (maximally flat), by the bilinear transform with the corner prewarped: −3 dB exactly at `corner_Hz`,
/// b = g·(1, −2, 1), so a constant gives exactly zero once settled; no inversion (+1 at Nyquist).
/// With K = tan(π·corner/rate): g = 1/(1 + √2·K + K²), a1 = 2·(K² − 1)·g, a2 = (1 − √2·K + K²)·g.
/// @param corner_Hz is brought into 1e-6 … kHighestCorner of `sample_rate_Hz`
[[nodiscard]] FYD_API BiquadCoefficients highPass(double corner_Hz, double sample_rate_Hz);

/// As printed for 1 kHz [thesis §4.1.4]: Σb = 5e-4 leaves gravity a gain of +0.0039 (−48 dB); the passband
/// is inverted (−0.998 at Nyquist); −3 dB at 0.0783 of the sample rate whatever that is.
[[nodiscard]] constexpr BiquadCoefficients thesisHighPass() {
  return {.b0 = -0.7162, .b1 = 1.433, .b2 = -0.7163, .a1 = -1.372, .a2 = 0.4998};
}

/// The same filter on three axes.
class HighPass3 {
 public:
  HighPass3() = default;
  explicit HighPass3(const BiquadCoefficients& c) { setCoefficients(c); }

  void setCoefficients(const BiquadCoefficients& c) {
    x_.setCoefficients(c);
    y_.setCoefficients(c);
    z_.setCoefficients(c);
  }
  [[nodiscard]] Vec3 step(const Vec3& v) { return {x_.step(v.x), y_.step(v.y), z_.step(v.z)}; }
  void reset() {
    x_.reset();
    y_.reset();
    z_.reset();
  }
  void settleAt(const Vec3& v) {
    x_.settleAt(v.x);
    y_.settleAt(v.y);
    z_.settleAt(v.z);
  }

  /// Without the coefficients.
  template <class Archive>
  void serialize(Archive& archive) {
    archive(x_, y_, z_);
  }

 private:
  Biquad<double> x_, y_, z_;
};

}  // namespace fyd::signal
