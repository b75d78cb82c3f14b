// Student's t, for intervals and for telling outliers from chance.
#pragma once

#include <cstddef>

namespace fyd::calibration {

/// Two-sided quantile: |t| stays below it with this probability. Infinite without degrees of freedom.
[[nodiscard]] double studentQuantile(double probability, std::size_t degrees_of_freedom);

}  // namespace fyd::calibration
