// Load cell to newtons [thesis §4.1.3]: F = (1004.8805·value − 20.2512)/1000 · g, less the tare.
// value is the bridge's mV/V (an API in V/V needs × 1000).
//
// Two bounds: the converter's end, ±7.77 mV/V at gain 128, where a reading means only "out of range" (an open wire, a
// broken bridge), and the configured span of the cell itself. As delivered that is ±2 mV/V, 2.5 times the cell's rated
// 0.8 mV/V (7.65 N): a cell of this kind breaks at 1.5 times its rating, so nothing sound reads more.
// Stability: may change
#pragma once

#include <algorithm>

#include "core/base/api.h"
#include "core/base/message.h"
#include "core/base/parameter.h"

namespace fyd::sensing {

/// Readings beyond lie at the end of the bridge's converter, its noise and rounding included: they measure nothing,
/// whatever span is configured.
inline constexpr double kConverterEnd_mV_per_V = 7.75;

struct LoadCellParameters {
  double slope_g_per_mV_per_V = 1004.8805;
  double offset_g = -20.2512;
  double zero_N = 0.0;
  double limit_mV_per_V = 2.0;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("sensing.force_slope_g", slope_g_per_mV_per_V,
           {.unit = "g/(mV/V)", .minimum = -1e5, .maximum = 1e5, .help = sentence("Load cell: grams per mV/V.")});
    v.real("sensing.force_offset_g", offset_g,
           {.unit = "g", .minimum = -1e4, .maximum = 1e4, .help = sentence("Load cell: grams at 0 mV/V.")});
    v.real("sensing.force_zero_N", zero_N,
           {.name = sentence("Force zero"),
            .unit = "N",
            .minimum = -80,
            .maximum = 80,
            .help = sentence("Load cell: force that is read with nothing on the cloth; the tare sets it."),
            .live = true});
    v.real("sensing.force_limit_mV_per_V", limit_mV_per_V,
           {.unit = "mV/V",
            .minimum = 0.1,
            .maximum = 1000,
            .help = sentence("Load cell: readings beyond it are invalid; those at the converter's end always are.")});
  }
};

class FYD_API LoadCell {
 public:
  explicit LoadCell(const LoadCellParameters& parameters = {}) : parameters_(parameters) {}
  void configure(const LoadCellParameters& parameters) { parameters_ = parameters; }

  /// Force on the cloth, N, downward positive; NaN when the reading is not finite, beyond the cell's span or at the
  /// converter's end.
  [[nodiscard]] double force_N(double value_mV_per_V) const;

  /// Readings beyond ± this are invalid, mV/V: the configured span, within the converter's.
  [[nodiscard]] double span_mV_per_V() const { return std::min(parameters_.limit_mV_per_V, kConverterEnd_mV_per_V); }

  /// Makes `force_N`, read with nothing on the cloth, the new zero. Not finite: ignored.
  void tare(double untouched_force_N);
  [[nodiscard]] double zero_N() const { return parameters_.zero_N; }

 private:
  LoadCellParameters parameters_;
};

}  // namespace fyd::sensing
