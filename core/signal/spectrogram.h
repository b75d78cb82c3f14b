// Which frequencies a signal holds, and when: Hann-weighted transforms of short segments, half overlapped. For
// display; allocates. A level is the amplitude of the sine that would read so, in the signal's own unit:
//
//   A(k) = 2·|X(k)| / Σ w(n)      (DC and Nyquist: half of that)      x: the segment less its mean
//
// A sine between two bins reads up to 15 % (1.4 dB) low, which is the Hann window's scalloping.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace fyd::signal {

struct Spectrogram {
  double first_time_s = 0.0;  ///< middle of the first segment
  double step_s = 0.0;        ///< between the middles of two segments
  double resolution_Hz = 0.0;
  std::size_t bins = 0;           ///< DC to half the rate
  std::vector<double> amplitude;  ///< segment after segment, `bins` each; NaN in one with a hole or inside of one

  [[nodiscard]] std::size_t segments() const { return bins == 0 ? 0 : amplitude.size() / bins; }
  [[nodiscard]] std::span<const double> segment(std::size_t index) const {
    return std::span(amplitude).subspan(index * bins, bins);
  }
  /// Root of the mean square of each bin over all segments without a hole; NaN when there is none.
  [[nodiscard]] std::vector<double> mean() const;
};

/// @param time_s of the samples, rising; the answer takes memory for all of their span. A segment that is `tolerance`
///               longer or shorter than its samples at `rate_Hz` has a hole, and so has one with a value that is not
///               finite
/// @param segment samples, ≥ 8. Fewer samples than that, or spans of unequal length, give no segments
[[nodiscard]] Spectrogram spectrogram(std::span<const double> time_s, std::span<const float> signal, double rate_Hz,
                                      int segment, double tolerance = 0.05);

}  // namespace fyd::signal
