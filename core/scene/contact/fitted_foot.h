// FittedSurface::foot (fitted_surface.h), inline as it is called in every step.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/scene/contact/fitted_surface.h"
#include "core/scene/mesh/vector.h"

namespace fyd::scene {
namespace fitted {

inline constexpr double kLeastDeterminant = 0.05;  // of I − z K; 0 at a centre of curvature

/// Symmetric: xx xy xz yy yz zz.
using Tensor = std::array<double, 6>;

inline Vec3 operator*(const Tensor& k, const Vec3& v) {
  return {k[0] * v.x + k[1] * v.y + k[2] * v.z, k[1] * v.x + k[3] * v.y + k[4] * v.z,
          k[2] * v.x + k[4] * v.y + k[5] * v.z};
}

}  // namespace fitted

inline Foot FittedSurface::foot(const Vec3& probe_mm, const Nearest& nearest) const {
  const Triangle& t = triangles_[nearest.triangle];
  const std::array<double, 3> barycentric = {1.0 - nearest.at_1 - nearest.at_2, nearest.at_1, nearest.at_2};
  using fitted::Tensor, fitted::operator*;
  Vec3 gradient;
  Tensor k{};
  double height_mm = 0.0;  // of the nearest point
  double longest_mm2 = 0.0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Corner& corner = corners_[t[i]];
    const Vec3 e = nearest.point_mm - corner.point_mm;
    const Vec3 bent = corner.curvature * e;
    const double b = barycentric[i];
    height_mm += b * dot(e, 2.0 / 3.0 * corner.normal - 1.0 / 6.0 * bent);
    gradient = gradient + b * (corner.normal - 0.5 * bent);
    for (std::size_t j = 0; j < 6; ++j) k[j] += b * corner.curvature[j];
    longest_mm2 = std::max(longest_mm2, squared(e));
  }
  const Vec3 normal = unit(gradient);
  const Vec3 to_probe = probe_mm - nearest.point_mm + height_mm * normal;
  if (edges_.crease(nearest)) return creaseFoot(probe_mm, nearest, to_probe, normal);
  // u = (I − z K)⁻¹ e in the tangent plane, by the trace of K and its determinant there (the Gaussian curvature)
  const double trace = k[0] + k[3] + k[5];
  const double trace_of_square =
      k[0] * k[0] + k[3] * k[3] + k[5] * k[5] + 2.0 * (k[1] * k[1] + k[2] * k[2] + k[4] * k[4]);
  const double gaussian = 0.5 * (trace * trace - trace_of_square);
  const double z = dot(to_probe, normal);
  const Vec3 e = to_probe - z * normal;
  const Vec3 ke = k * e;
  const double determinant = 1.0 - z * trace + z * z * gaussian;
  // Beyond the centre of curvature the nearest point is not defined.
  const double inverse = determinant > fitted::kLeastDeterminant ? 1.0 / determinant : 0.0;
  // u: from the foot of the probe on the tangent plane; bent: K u, the tilt of the normal there.
  Vec3 u = inverse * ((1.0 - z * trace) * e + z * ke), bent = inverse * (ke - (z * gaussian) * e);
  if (const double far = squared(u); far > longest_mm2) {
    const double shortened = std::sqrt(longest_mm2 / far);
    u = shortened * u;
    bent = shortened * bent;
  }
  const Vec3 out = unit(normal - bent);
  const Vec3 above = to_probe - u - (0.5 * dot(u, bent)) * normal;
  return {probe_mm - above, out, dot(above, out)};
}

inline Foot FittedSurface::creaseFoot(const Vec3& probe_mm, const Nearest& nearest, const Vec3& to_probe,
                                      const Vec3& normal) const {
  const double distance_mm = length(to_probe);
  if (!(distance_mm > 0.0)) return {probe_mm, normal, 0.0};
  const bool above = dot(probe_mm - nearest.point_mm, mesh_->normalOf(nearest.triangle, nearest.feature)) >= 0.0;
  const double sign = above ? 1.0 : -1.0;
  return {probe_mm - to_probe, sign / distance_mm * to_probe, sign * distance_mm};
}

}  // namespace fyd::scene
