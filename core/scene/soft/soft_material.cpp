#include "core/scene/soft/soft_material.h"

#include <array>
#include <cmath>
#include <numbers>

namespace fyd::scene {
namespace {

constexpr double kgPerNs2PerMm = 1000.0;  // 1 N = 1000 kg·mm/s²

}  // namespace

Result<SoftMaterial> checked(const SoftMaterial& m) {
  const auto least = [](double x) { return std::isfinite(x) && x >= 0.0; };
  if (!least(m.mass_kg)) return fail("mass_kg of a soft body is {}; expected 0 or more", m.mass_kg);
  if (!least(m.rigidity_N_per_mm) || m.rigidity_N_per_mm == 0.0) {
    return fail("rigidity_N_per_mm of a soft body is {}; expected more than 0", m.rigidity_N_per_mm);
  }
  if (!least(m.viscosity_Ns_per_mm)) {
    return fail("viscosity_Ns_per_mm of a soft body is {}; expected 0 or more", m.viscosity_Ns_per_mm);
  }
  if (!least(m.spread_mm)) return fail("spread_mm of a soft body is {}; expected 0 or more", m.spread_mm);
  if (!least(m.finger_mm) || m.finger_mm == 0.0) {
    return fail("finger_mm of a soft body is {}; expected more than 0", m.finger_mm);
  }
  return m;
}

double depthOfUnitPress(double finger_mm, double spread_mm) {
  constexpr std::size_t kWithin = 400, kRings = 4 * kWithin;
  const double pi = std::numbers::pi;
  const double spread = spread_mm / finger_mm;  // the finger's radius is 1 from here
  // Rings of equal width under the finger, growing beyond it to 12 spreads, where e^−12 is left.
  std::array<double, kRings + 1> edge{};
  for (std::size_t i = 0; i <= kWithin; ++i) edge[i] = double(i) / double(kWithin);
  for (std::size_t i = 1; i <= kRings - kWithin; ++i) {
    const double s = double(i) / double(kRings - kWithin);
    const double linear = 1.0 / double(kWithin) * double(kRings - kWithin);
    edge[kWithin + i] = 1.0 + s * (s * s * 12.0 * spread + (1.0 - s * s) * std::fmin(linear, 12.0 * spread)) + 1e-3 * s;
  }
  std::array<double, kRings> upper{}, value{}, area{}, load{};
  const auto integral = [&](double r) {  // of the finger's weight: 3/π·(1 − r²)² out to r
    const double rest = std::fmax(0.0, 1.0 - r * r);
    return 1.0 - rest * rest * rest;
  };
  const auto flow = [&](std::size_t i) {  // tension across the ring's outer edge
    if (i + 1 == kRings) return 0.0;
    return 4.0 * pi * spread * spread * edge[i + 1] / (edge[i + 2] - edge[i]);
  };
  double below = 0.0;
  for (std::size_t i = 0; i < kRings; ++i) {
    area[i] = pi * (edge[i + 1] * edge[i + 1] - edge[i] * edge[i]);
    load[i] = integral(edge[i + 1]) - integral(edge[i]);
    const double above = flow(i);
    const double pivot = area[i] + above + below + (i > 0 ? below * -upper[i - 1] : 0.0);
    upper[i] = above / pivot;
    value[i] = (load[i] + (i > 0 ? below * value[i - 1] : 0.0)) / pivot;
    below = above;
  }
  double depth = 0.0, u = 0.0;
  for (std::size_t i = kRings; i-- > 0;) {
    u = value[i] + upper[i] * u;
    depth += load[i] * u;
  }
  return depth / (finger_mm * finger_mm);
}

SoftSurface surfaceOf(const SoftMaterial& m, double area_mm2) {
  SoftSurface s;
  s.foundation_N_per_mm3 = m.rigidity_N_per_mm * depthOfUnitPress(m.finger_mm, m.spread_mm);
  s.tension_N_per_mm = s.foundation_N_per_mm3 * m.spread_mm * m.spread_mm;
  s.relaxation_s = m.viscosity_Ns_per_mm / m.rigidity_N_per_mm;
  s.mass_Ns2_per_mm3 = m.mass_kg / kgPerNs2PerMm / area_mm2;
  return s;
}

}  // namespace fyd::scene
