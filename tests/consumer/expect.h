// What each of these programs needs to say what went wrong.
#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>

/// Ends the program with exit code 1 unless `value` is within `tolerance` of `expected`.
inline void expectNear(const char* what, double value, double expected, double tolerance) {
  if (std::abs(value - expected) <= tolerance) return;
  std::fprintf(stderr, "%s: %.9g; expected %.9g within %.3g\n", what, value, expected, tolerance);
  std::exit(1);
}

inline void expect(const char* what, bool holds) {
  if (holds) return;
  std::fprintf(stderr, "%s: expected\n", what);
  std::exit(1);
}
