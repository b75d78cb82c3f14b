#include "core/signal/high_pass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"

namespace fyd::signal {

BiquadCoefficients highPass(double corner_Hz, double sample_rate_Hz) {
  const double ratio = std::clamp(corner_Hz / sample_rate_Hz, 1e-6, kHighestCorner);
  const double k = math::tan(std::numbers::pi * ratio);
  const double g = 1.0 / (1.0 + std::numbers::sqrt2 * k + k * k);
  return {.b0 = g,
          .b1 = -2.0 * g,
          .b2 = g,
          .a1 = 2.0 * (k * k - 1.0) * g,
          .a2 = (1.0 - std::numbers::sqrt2 * k + k * k) * g};
}

}  // namespace fyd::signal
