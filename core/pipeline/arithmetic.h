// Version of the step's arithmetic: it decides the exact bits that the same inputs give. A recording made with another
// version cannot replay bit for bit; that is no sign of damage.
//
//   1  exp, log, sin, … of the C library and FFTW's vector code, both chosen by the processor (to revision a4d2b6a)
//   2  portable functions (SLEEF's), FFTW without vector code: the same bits on every
//      x86-64 processor
//
// A new version never changes what is felt: an algorithm that feels different is added as a new named mode.
// Stability: may change
#pragma once

#include <optional>
#include <string_view>

namespace fyd::pipeline {

inline constexpr int kArithmetic = 2;

/// Largest difference between a step of this program's arithmetic and the same step of an older one.
struct ArithmeticTolerance {
  int since = 1;              ///< the oldest arithmetic it holds for
  std::string_view name;      ///< what has changed since
  double of_a_field = 0.0;    ///< telemetry, in the field's own unit
  double of_a_command = 0.0;  ///< commands, which are rounded: reference in ticks, duty in %
};

/// Tolerance for a recording made with arithmetic `recorded`; none when that is this program's own or unknown to it.
[[nodiscard]] constexpr std::optional<ArithmeticTolerance> arithmeticTolerance(int recorded) {
  if (recorded == 1) {
    return ArithmeticTolerance{.since = 1,
                               .name = "elementary functions and FFT do not depend on the processor any more",
                               .of_a_field = 1e-9,
                               .of_a_command = 1.0};
  }
  return std::nullopt;
}

}  // namespace fyd::pipeline
