// Minimum-phase impulse response of a given gain, by folding the real cepstrum to its causal half
// (Oppenheim and Schafer, Discrete-Time Signal Processing, homomorphic systems).
#pragma once

#include "core/signal/fft.h"

namespace fyd::signal {

/// @param fft of even length. In: bins() hold the natural logarithm of the gain. Out: time() holds the impulse
///   response. Allocates nothing.
void minimumPhase(RealFft& fft);

}  // namespace fyd::signal
