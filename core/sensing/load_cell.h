// Load cell to newtons (thesis §4.1.3): F = (1004.8805·value − 20.2512)/1000 · g, less the tare.
// value is the bridge's mV/V (an API in V/V needs × 1000); the bridge delivers ±7.77 at gain 128.
#pragma once

#include "core/base/parameter.h"

namespace fyd::sensing {

struct LoadCellParameters {
  double slope_g_per_mV_per_V = 1004.8805;
  double offset_g = -20.2512;
  double zero_N = 0.0;
  double limit_mV_per_V = 7.77;

  template <class Visitor>
  void describe(Visitor& v) {
    v.real("sensing.force_slope_g", slope_g_per_mV_per_V,
           {.unit = "g/(mV/V)", .minimum = -1e5, .maximum = 1e5, .help = "Load cell: grams per mV/V."});
    v.real("sensing.force_offset_g", offset_g,
           {.unit = "g", .minimum = -1e4, .maximum = 1e4, .help = "Load cell: grams at 0 mV/V."});
    v.real("sensing.force_zero_N", zero_N,
           {.unit = "N",
            .minimum = -80,
            .maximum = 80,
            .help = "Load cell: force that is read with nothing on the cloth; the tare sets it.",
            .live = true});
    v.real("sensing.force_limit_mV_per_V", limit_mV_per_V,
           {.unit = "mV/V", .minimum = 0.1, .maximum = 1000, .help = "Load cell: readings beyond it are invalid."});
  }
};

class LoadCell {
 public:
  explicit LoadCell(const LoadCellParameters& parameters = {}) : parameters_(parameters) {}
  void configure(const LoadCellParameters& parameters) { parameters_ = parameters; }

  /// Force on the cloth, N, downward positive; NaN when the reading is not finite or beyond the bridge's span.
  [[nodiscard]] double force_N(double value_mV_per_V) const;

  /// Makes `force_N`, read with nothing on the cloth, the new zero. Not finite: ignored.
  void tare(double untouched_force_N);
  [[nodiscard]] double zero_N() const { return parameters_.zero_N; }

 private:
  LoadCellParameters parameters_;
};

}  // namespace fyd::sensing
