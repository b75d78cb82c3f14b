// The source of a curve's samples: the live buffer, or a recording.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace fyd::widgets {

/// Samples of one pixel column.
struct CurveColumn {
  double time_s = 0.0;                                      ///< middle of the column
  float minimum = std::numeric_limits<float>::quiet_NaN();  ///< NaN: no value in it
  float maximum = std::numeric_limits<float>::quiet_NaN();  ///< NaN: no value in it
  bool gap = false;                                         ///< it contains a NaN: the line breaks here
  bool empty = true;                                        ///< no sample in it at all, also no NaN
};

/// Samples as they are.
struct CurveRows {
  std::vector<double> time_s;
  std::vector<std::vector<float>> values;  ///< one vector per channel asked for; NaN: no value
};

class CurveSource {
 public:
  virtual ~CurveSource() = default;

  /// Columns of equal width from `from_s` to `to_s`; no spike is lost, nothing is averaged.
  /// @param out one or two more than `columns`; reused without allocating
  virtual void decimate(std::size_t channel, double from_s, double to_s, std::size_t columns,
                        std::vector<CurveColumn>& out) const = 0;
  /// Of the last sample at or before `time_s`; NaN where there is none.
  [[nodiscard]] virtual double valueAt(std::size_t channel, double time_s) const = 0;
  /// Every sample from `from_s` to `to_s`, both included.
  [[nodiscard]] virtual CurveRows rows(std::span<const std::size_t> channels, double from_s, double to_s) const = 0;

 protected:
  CurveSource() = default;
  CurveSource(const CurveSource&) = default;
  CurveSource& operator=(const CurveSource&) = default;
};

}  // namespace fyd::widgets
