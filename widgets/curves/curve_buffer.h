// The samples of the curves: a ring buffer on one time axis with a min/max pyramid over every channel.
//
// A drawn curve has one column per pixel; each column shows the smallest and the largest sample in it, so a
// spike of one sample stays visible at every zoom, and nothing is averaged. Level l of the pyramid keeps min, max and
// "is there a gap" of 16^l samples, so a column costs at most a few dozen reads however much time it covers.
//
// A NaN is a gap and stays one: it never enters min or max, and the column that holds it breaks the line.
// A hole in time (samples lost, loop not running) is stored as a gap as well. Time must increase; a sample
// whose time does not is refused. Not thread-safe: it belongs to the window's thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "widgets/curves/curve_source.h"

namespace fyd::widgets {

class CurveBuffer : public CurveSource {
 public:
  /// @param channels values per sample, ≥ 1
  /// @param capacity samples kept, rounded up to a multiple of 65 536
  /// @param longest_step_s a longer time between two samples is a hole
  CurveBuffer(std::size_t channels, std::size_t capacity, double longest_step_s = 0.05);

  /// @param values one per channel; infinite values are taken as gaps
  /// @return false, and nothing stored, when the time is not finite or not after the last one
  bool append(double time_s, std::span<const float> values);
  void clear();

  [[nodiscard]] std::size_t channels() const { return channels_.size(); }
  [[nodiscard]] std::size_t capacity() const { return times_.size(); }
  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(next_ - oldest()); }
  [[nodiscard]] bool empty() const { return next_ == 0; }
  [[nodiscard]] double firstTime_s() const;             ///< NaN when empty
  [[nodiscard]] double lastTime_s() const;              ///< NaN when empty
  [[nodiscard]] float last(std::size_t channel) const;  ///< NaN when empty or a gap

  /// Columns of equal width from `from_s` to `to_s`. Their edges lie on multiples of the width, so that a scrolling
  /// curve does not flicker. @param out one or two more than `columns`; reused without allocating
  void decimate(std::size_t channel, double from_s, double to_s, std::size_t columns,
                std::vector<CurveColumn>& out) const override;
  [[nodiscard]] double valueAt(std::size_t channel, double time_s) const override;
  [[nodiscard]] CurveRows rows(std::span<const std::size_t> channels, double from_s, double to_s) const override;

 private:
  struct Extent {
    float minimum = std::numeric_limits<float>::infinity();
    float maximum = -std::numeric_limits<float>::infinity();
    bool gap = false;
    void add(float value) {  // inline and without a branch: drawing adds some hundred thousand
      const bool finite = std::isfinite(value);
      const float low = finite ? value : std::numeric_limits<float>::infinity();
      const float high = finite ? value : -std::numeric_limits<float>::infinity();
      minimum = low < minimum ? low : minimum;
      maximum = high > maximum ? high : maximum;
      gap |= !finite;
    }
    void add(const Extent& other) {
      minimum = std::min(minimum, other.minimum);
      maximum = std::max(maximum, other.maximum);
      gap |= other.gap;
    }
  };
  struct Channel {
    std::vector<float> values;
    std::vector<std::vector<Extent>> levels;  ///< levels[0] covers 16 samples an entry
  };

  static constexpr unsigned kShift = 4;  ///< radix 16
  static constexpr std::size_t kLevels = 4;

  [[nodiscard]] std::uint64_t oldest() const { return next_ > times_.size() ? next_ - times_.size() : 0; }
  /// Position of a stored sample in the ring; without a division, because drawing needs thousands.
  [[nodiscard]] std::size_t positionOf(std::uint64_t index) const {
    const auto behind = static_cast<std::size_t>(next_ - index);
    return behind <= head_ ? head_ - behind : head_ + times_.size() - behind;
  }
  [[nodiscard]] double timeOf(std::uint64_t index) const { return times_[positionOf(index)]; }
  [[nodiscard]] std::uint64_t firstNotBefore(double time_s, std::uint64_t from) const;
  [[nodiscard]] Extent extent(const Channel& channel, std::uint64_t from, std::uint64_t to) const;
  void store(double time_s, std::span<const float> values);

  std::vector<double> times_;
  std::vector<Channel> channels_;
  std::vector<float> hole_;  ///< one NaN per channel
  std::uint64_t next_ = 0;   ///< counts every sample ever stored
  std::size_t head_ = 0;     ///< where the next one goes in the ring
  double longest_step_s_;
};

}  // namespace fyd::widgets
