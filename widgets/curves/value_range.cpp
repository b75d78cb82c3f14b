#include "widgets/curves/value_range.h"

#include <algorithm>
#include <cmath>

namespace fyd::widgets {
namespace {

/// 1, 2 or 5 times a power of ten: an eighth of `span` or the next above.
double roundStep(double span) {
  const double raw = span / 8.0;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (raw <= factor * power) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

Range ValueRange::fit(double minimum, double maximum) {
  if (!std::isfinite(minimum) || !std::isfinite(maximum) || minimum > maximum) return shown_;
  Range wanted{std::min(minimum, least_.lower), std::max(maximum, least_.upper)};
  if (wanted == least_) {
    wanted = least_;
  } else {
    const double step = roundStep(wanted.upper - wanted.lower);
    if (wanted.lower < least_.lower) wanted.lower = std::floor(wanted.lower / step) * step;
    if (wanted.upper > least_.upper) wanted.upper = std::ceil(wanted.upper / step) * step;
  }
  const bool too_small = wanted.lower < shown_.lower || wanted.upper > shown_.upper;
  const bool mostly_empty = (wanted.upper - wanted.lower) < 0.5 * (shown_.upper - shown_.lower);
  if (too_small) {
    shown_ = {std::min(wanted.lower, shown_.lower), std::max(wanted.upper, shown_.upper)};
  } else if (mostly_empty) {
    shown_ = wanted;
  }
  return shown_;
}

}  // namespace fyd::widgets
