// Elementary functions that give the same bits on every processor, for everything a replay computes again.
//
// The C library chooses its exp, log, sin, pow, … by the processor it runs on (with or without fused multiply-add), so
// their last bit differs between machines. SLEEF's "cinz" functions are written without such choices; they are within
// 1 ulp and take three to seven times as long (18 ns for exp, 28 ns for log). Square root, rounding, remainder and the
// four operations are exact by IEEE 754 and stay the standard library's.
//
// Special values (±0, ±infinity, NaN, overflow to infinity, underflow to 0) are those of the C library.
#pragma once

#include <complex>

#include <sleef.h>

namespace fyd::math {

[[nodiscard]] inline double exp(double x) { return Sleef_cinz_expd1_u10purec(x); }
[[nodiscard]] inline double log(double x) { return Sleef_cinz_logd1_u10purec(x); }
[[nodiscard]] inline double pow(double base, double exponent) { return Sleef_cinz_powd1_u10purec(base, exponent); }
[[nodiscard]] inline double square(double x) { return x * x; }
[[nodiscard]] inline double cbrt(double x) { return Sleef_cinz_cbrtd1_u10purec(x); }

/// Angles in radians.
[[nodiscard]] inline double sin(double x) { return Sleef_cinz_sind1_u10purec(x); }
[[nodiscard]] inline double cos(double x) { return Sleef_cinz_cosd1_u10purec(x); }
[[nodiscard]] inline double tan(double x) { return Sleef_cinz_tand1_u10purec(x); }
[[nodiscard]] inline double atan2(double y, double x) { return Sleef_cinz_atan2d1_u10purec(y, x); }

/// √(x² + y²) without overflow on the way.
[[nodiscard]] inline double hypot(double x, double y) { return Sleef_cinz_hypotd1_u05purec(x, y); }

[[nodiscard]] inline double abs(const std::complex<double>& z) { return hypot(z.real(), z.imag()); }
/// Of a complex number, in (−π, π].
[[nodiscard]] inline double arg(const std::complex<double>& z) { return atan2(z.imag(), z.real()); }
/// length·e^(i·angle)
[[nodiscard]] inline std::complex<double> polar(double length, double angle) {
  const Sleef_double_2 turned = Sleef_cinz_sincosd1_u10purec(angle);
  return {length * turned.y, length * turned.x};
}
[[nodiscard]] inline std::complex<double> exp(const std::complex<double>& z) { return polar(exp(z.real()), z.imag()); }

}  // namespace fyd::math
