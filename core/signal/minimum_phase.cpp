#include "core/signal/minimum_phase.h"

#include <algorithm>

#include "core/base/portable_math.h"

namespace fyd::signal {

void minimumPhase(RealFft& fft) {
  const auto cepstrum = fft.time();
  const std::size_t half = cepstrum.size() / 2;
  fft.backward();
  for (std::size_t i = 1; i < half; ++i) cepstrum[i] *= 2.0;
  std::fill(cepstrum.begin() + static_cast<std::ptrdiff_t>(half) + 1, cepstrum.end(), 0.0);
  fft.forward();
  for (auto& bin : fft.bins()) bin = math::polar(math::exp(bin.real()), bin.imag());
  fft.backward();
}

}  // namespace fyd::signal
