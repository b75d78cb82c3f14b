// The step's arithmetic: which bits the same inputs give. It has a version, so that a recording made with another one
// is known by it: such a recording cannot replay bit for bit, which is no damage.
//
//   1  exp, log, sin, … of the C library and FFTW's vector code, both chosen by the processor (to revision a4d2b6a)
//   2  portable functions (core/base/portable_math.h), FFTW without vector code: the same bits on every x86-64
//   processor
//
// What is felt never changes with it: an algorithm that feels different is a new named mode beside the old one.
#pragma once

#include <optional>
#include <string_view>

namespace fyd::pipeline {

inline constexpr int kArithmetic = 2;

/// How far a step of this program's arithmetic may lie from one of an older arithmetic.
struct ArithmeticTolerance {
  int since = 1;              ///< the oldest arithmetic it holds for
  std::string_view name;      ///< what has changed since
  double of_a_field = 0.0;    ///< telemetry, in the field's own unit
  double of_a_command = 0.0;  ///< whole numbers that a rounding decides: reference in ticks, duty in %
};

/// Of a recording made with arithmetic `recorded`; none when it is this program's own, or one that it does not know.
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
