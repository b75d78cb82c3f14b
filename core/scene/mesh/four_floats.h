// Four floats at a time: SIMD vector type and element-wise operations.
#pragma once

#include <cmath>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace fyd::scene {

using Floats = float __attribute__((vector_size(16)));

inline Floats larger(Floats a, Floats b) { return a > b ? a : b; }
inline Floats smaller(Floats a, Floats b) { return a < b ? a : b; }

inline Floats load(const float (&four)[4]) {
  Floats out;
  __builtin_memcpy(&out, four, sizeof out);
  return out;
}

inline Floats root(Floats a) {
#ifdef __SSE2__
  return _mm_sqrt_ps(a);
#else
  return Floats{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])};
#endif
}

}  // namespace fyd::scene
