// Real discrete Fourier transform of one fixed length, by FFTW (double, FFTW_ESTIMATE: the same plan on every run, so a
// recording replays bit for bit).
//
//   forward:   X(k) = Σ x(n)·exp(−2πi·k·n/N), k = 0…N/2        backward: x(n) = (1/N)·Σ X(k)·exp(+2πi·k·n/N)
// Stability: may change
#pragma once

#include <complex>
#include <memory>
#include <span>

#include "core/base/api.h"

namespace fyd::signal {

/// Owns its buffers and plans; only the constructor allocates. Making one is thread-safe, using one is not.
class FYD_API RealFft {
 public:
  /// @param length ≥ 1, any value
  explicit RealFft(int length);
  ~RealFft();
  RealFft(RealFft&&) noexcept;
  RealFft& operator=(RealFft&&) noexcept;

  [[nodiscard]] int length() const;
  [[nodiscard]] std::span<double> time();                ///< N samples
  [[nodiscard]] std::span<std::complex<double>> bins();  ///< N/2 + 1 bins

  /// time() → bins(); time() keeps its content.
  void forward();
  /// bins() → time(), scaled by 1/N; bins() is overwritten. Imaginary parts of DC and Nyquist count as zero.
  void backward();

 private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

}  // namespace fyd::signal
