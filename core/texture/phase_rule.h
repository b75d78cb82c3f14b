// One bin of DFT321: the magnitude that keeps the energy of three axes, and a phase.
//
//   |Â| = √(Σ|Aᵢ|²),   phase of S = ΣAᵢ   [thesis §5.3] [Landin 2010]
//
// The phase is undefined at S = 0 (axes in antiphase), where the printed rule turns 1e-9 of noise into the whole
// amplitude. The rule here, with s = |S| / (10⁻³·|Â|):
//
//   s ≥ 1:  the definition, exactly
//   s < 1:  the direction of  s²·S/|S| + (1 − s²)·T/|T|,   T = (p, q)·(cos 15°, sin 15°)
//
// where (p, q) are the components of A along (1, −1, 0)/√2 and (1, 1, −2)/√6, the plane in which S vanishes. T is
// linear in A, so its phase is as steady as the signal's, from frame to frame too. At S = 0 exactly T vanishes only for
// A ∝ (−sin 15°, cos 15°) in that plane, half-way between the patterns that symmetry makes likely ((1, −1, 0), (2, −1,
// −1) and their like); there the component across it takes its place. No rule is continuous everywhere: this one jumps
// where, with |S| < 10⁻³·|Â|, S and T point opposite ways at s² = 1/2, and at that one pattern.
#pragma once

#include <complex>

namespace fyd::texture {

inline constexpr double kAntiphaseRatio = 1e-3;

/// @return Â; exactly zero for zero input. |Â|² = |x|² + |y|² + |z|² whatever the phases.
[[nodiscard]] std::complex<double> combineAxes(std::complex<double> x, std::complex<double> y, std::complex<double> z);

}  // namespace fyd::texture
