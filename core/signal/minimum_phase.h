// The impulse response of minimum phase that has a given gain, by folding the real cepstrum to its causal half
// (Oppenheim and Schafer, Discrete-Time Signal Processing, homomorphic systems).
#pragma once

#include "core/signal/fft.h"

namespace fyd::signal {

/// @param fft of even length; bins() hold the natural logarithm of the gain, which time() holds as a response then.
///     Allocates nothing.
void minimumPhase(RealFft& fft);

}  // namespace fyd::signal
