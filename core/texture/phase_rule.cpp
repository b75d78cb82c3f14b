#include "core/texture/phase_rule.h"

#include <cmath>
#include <numbers>

#include "core/base/portable_math.h"

namespace fyd::texture {
namespace {

using Bin = std::complex<double>;

Bin direction(Bin a) { return a / math::abs(a); }

// The direction where the sum of the axes (nearly) vanishes; magnitude > 0.
Bin antiphaseDirection(Bin x, Bin y, Bin z, double magnitude) {
  static const double kAlong = math::cos(std::numbers::pi / 12.0);
  static const double kAcross = math::sin(std::numbers::pi / 12.0);
  const Bin p = (x - y) / std::numbers::sqrt2;
  const Bin q = (x + y - 2.0 * z) / (std::numbers::sqrt2 * std::numbers::sqrt3);
  const Bin t = kAlong * p + kAcross * q;
  if (math::abs(t) > kAntiphaseRatio * magnitude) return direction(t);
  return direction(kAlong * q - kAcross * p);
}

}  // namespace

Bin combineAxes(Bin x, Bin y, Bin z) {
  const double energy = std::norm(x) + std::norm(y) + std::norm(z);
  // Below this the squares are denormal: far below perception, and slow to compute with.
  if (!(energy > 1e-280)) return {};
  const Bin sum = x + y + z;
  const double sum_energy = std::norm(sum);
  if (sum_energy >= kAntiphaseRatio * kAntiphaseRatio * energy) return sum * std::sqrt(energy / sum_energy);

  const double magnitude = std::sqrt(energy);
  const double s = std::sqrt(sum_energy) / (kAntiphaseRatio * magnitude);
  const Bin fallback = antiphaseDirection(x, y, z, magnitude);
  const Bin blend = s > 0.0 ? s * s * direction(sum) + (1.0 - s * s) * fallback : fallback;
  const double length = math::abs(blend);
  return length > 1e-6 ? blend * (magnitude / length) : fallback * magnitude;
}

}  // namespace fyd::texture
