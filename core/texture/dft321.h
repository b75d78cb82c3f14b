// DFT321: one signal with the energy of three axes in every band [thesis §5.3] [Landin 2010].
//
//   frame of N samples → DFT of each axis → Â(k) by the phase rule → inverse DFT
//
// Blocks (hop = N): rectangular frames, as the thesis has them. The energy of a block equals the three axes' exactly
// (Parseval); the edges of blocks show.
// Overlapped (hop a smaller divisor of N, usually N/2): √Hann before and after, scaled so that the overlapping windows
// add up to 1 everywhere. Neighbouring frames disagree about phases and so cancel a little (2–15 % of the energy); a
// spectral equaliser behind it restores that (spectral_equaliser.h).
//
// The delay is N − 1 samples, constant: a frame's oldest output is ready when its newest sample has arrived.
// Stability: stable since 0.1
#pragma once

#include <array>
#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "core/base/api.h"
#include "core/base/state.h"
#include "core/signal/fft.h"
#include "core/texture/method.h"
#include "core/texture/spectral_equaliser.h"

namespace fyd::texture {

/// The transform of one frame; also the reference for tests and benchmarks.
class FYD_API Dft321Frame {
 public:
  /// @param length ≥ 1, any value
  explicit Dft321Frame(int length);

  /// x, y, z of `length` samples → length samples, valid until the next call.
  [[nodiscard]] std::span<const double> transform(std::span<const double> x, std::span<const double> y,
                                                  std::span<const double> z);

 private:
  std::span<const std::complex<double>> spectrumOf(std::span<const double> axis, std::size_t index);

  signal::RealFft fft_;
  std::array<std::vector<std::complex<double>>, 3> spectra_;
};

class FYD_API Dft321 final : public Method {
 public:
  /// @param frame 2…kMaximumFrame; @param hop frame or a divisor of it
  Dft321(int frame, int hop, double sample_rate_Hz);

  [[nodiscard]] double step(const Vec3& filtered_g) override;
  void reset() override;
  [[nodiscard]] int delaySamples() const override { return frame_ - 1; }

  template <class Archive>
  void serialize(Archive& archive) {
    for (auto& axis : history_) archive(contents(axis));
    archive(contents(output_), contents(delayed_), within(filled_, hop_ - 1), within(oldest_, frame_ - 1));
    if (equaliser_) archive(*equaliser_);
  }

 private:
  void process();

  int frame_;
  int hop_;
  Dft321Frame transform_;
  std::optional<SpectralEqualiser> equaliser_;  // overlapped frames only
  std::vector<double> window_;                  // overlapped frames only
  std::array<std::vector<double>, 3> history_;  // the last frame, oldest first
  std::array<std::vector<double>, 3> windowed_;
  std::vector<double> output_;  // overlap-add; its first hop samples are finished
  std::vector<Vec3> delayed_;   // ring: the axes as late as the output
  int filled_ = 0;              // of the present hop
  int oldest_ = 0;              // of delayed_
};

/// DFT321 as the thesis' program did it [thesis §4.1.4], for comparison: its buffer takes N + 1 samples and drops the
/// last, each block is followed by one sample of silence (the cycle in which it computes), and the phase is 0 where the
/// sum of the axes vanishes. Delay N + 1 samples; one sample in N + 1 is lost.
class FYD_API ThesisDft321 final : public Method {
 public:
  explicit ThesisDft321(int frame);

  [[nodiscard]] double step(const Vec3& filtered_g) override;
  void reset() override;
  [[nodiscard]] int delaySamples() const override { return frame_ + 1; }

  template <class Archive>
  void serialize(Archive& archive) {
    for (auto& axis : stored_) archive(contents(axis));
    archive(contents(playing_), within(index_, frame_));
  }

 private:
  int frame_;
  signal::RealFft fft_;
  std::array<std::vector<double>, 3> stored_;
  std::vector<double> playing_;
  std::vector<double> energy_;
  std::vector<std::complex<double>> sum_;
  int index_ = 0;
};

}  // namespace fyd::texture
