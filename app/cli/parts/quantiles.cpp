#include "app/cli/parts/quantiles.h"

#include <algorithm>
#include <cstddef>

namespace fyd::cli {

Quantiles quantiles(std::vector<double>& samples) {
  if (samples.empty()) return {};
  std::sort(samples.begin(), samples.end());
  const auto at = [&](double q) {
    return samples[std::min(samples.size() - 1, static_cast<std::size_t>(q * static_cast<double>(samples.size())))];
  };
  return {at(0.5), at(0.99), at(0.999), samples.back()};
}

}  // namespace fyd::cli
