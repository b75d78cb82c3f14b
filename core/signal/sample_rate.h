// The rate at which a signal is sampled.
// Stability: may change
#pragma once

#include <cmath>

#include "core/base/error.h"

namespace fyd::signal {

/// @return an error unless it is finite and more than 0
[[nodiscard]] inline Result<void> checkSampleRate(double rate_Hz) {
  if (rate_Hz > 0.0 && std::isfinite(rate_Hz)) return {};
  return fail("rate = {} Hz: expected more than 0", rate_Hz);
}

}  // namespace fyd::signal
