// Where a curve's picture comes from: the live buffer, or a recording.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace fyd::widgets {

/// Samples of one pixel column.
struct CurveColumn {
  double time_s = 0.0;                                      ///< middle of the column
  float minimum = std::numeric_limits<float>::quiet_NaN();  ///< NaN: no value in it
  float maximum = std::numeric_limits<float>::quiet_NaN();  ///< NaN: no value in it
  bool gap = false;                                         ///< a NaN stands in it: the line breaks here
  bool empty = true;                                        ///< no sample in it at all, also no NaN
};

class CurveSource {
 public:
  virtual ~CurveSource() = default;

  /// Columns of equal width from `from_s` to `to_s`; no spike is lost, nothing is averaged.
  /// @param out one or two more than `columns`; reused without allocating
  virtual void decimate(std::size_t channel, double from_s, double to_s, std::size_t columns,
                        std::vector<CurveColumn>& out) const = 0;

 protected:
  CurveSource() = default;
  CurveSource(const CurveSource&) = default;
  CurveSource& operator=(const CurveSource&) = default;
};

}  // namespace fyd::widgets
