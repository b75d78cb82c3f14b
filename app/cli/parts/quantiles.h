// Quantiles of a list of measured times.
#pragma once

#include <vector>

namespace fyd::cli {

struct Quantiles {
  double p50 = 0.0;
  double p99 = 0.0;
  double p999 = 0.0;
  double worst = 0.0;
};
/// @param samples is reordered; empty gives zeros
[[nodiscard]] Quantiles quantiles(std::vector<double>& samples);

}  // namespace fyd::cli
