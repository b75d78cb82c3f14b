// The point of a triangle that is nearest to a point, in double [Ericson 2005 §5.1.5].
// Stability: may change
#pragma once

#include <algorithm>
#include <limits>

#include "core/scene/mesh/mesh.h"
#include "core/scene/mesh/vector.h"

namespace fyd::scene {

struct Nearest {
  double squared_mm2 = std::numeric_limits<double>::infinity();  ///< of the distance
  std::uint32_t triangle = kNoTriangle;
  Feature feature = Feature::inside;
  Vec3 point_mm;
  double at_1 = 0.0, at_2 = 0.0;  ///< the point's share of the vertices 1 and 2; the rest is of vertex 0
};

/// nearestOf for a needle triangle (kNeedle), where rounding spoils the barycentric shares that nearestOf computes.
/// Takes the smallest of the distances to its edges and, if the foot is within the triangle, to its plane.
[[nodiscard]] inline Nearest nearestOfNeedle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c,
                                             std::uint32_t triangle) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a, normal = cross(ab, ac);
  const double share = 1.0 / squared(normal), v = dot(cross(ap, ac), normal) * share,
               w = dot(cross(ab, ap), normal) * share;
  Nearest best;
  if (v > 0.0 && w > 0.0 && v + w < 1.0) {
    const double away = dot(normal, ap) * share;
    best = {away * away * squared(normal), triangle, Feature::inside, p - away * normal, v, w};
  }
  const auto edge = [&](const Vec3& from, const Vec3& to, Feature feature, double& at) {
    at = std::clamp(dot(p - from, to - from) / squared(to - from), 0.0, 1.0);
    const Vec3 point = from + at * (to - from);
    if (!(squared(p - point) < best.squared_mm2)) return false;
    best = {squared(p - point), triangle, feature, point, 0.0, 0.0};
    return true;
  };
  double at = 0.0;
  if (edge(a, b, Feature::edge_01, at)) best.at_1 = at;
  if (edge(b, c, Feature::edge_12, at)) best.at_1 = 1.0 - at, best.at_2 = at;
  if (edge(c, a, Feature::edge_20, at)) best.at_2 = 1.0 - at;
  if (best.feature == Feature::inside) return best;
  if (best.at_1 == 0.0 && best.at_2 == 0.0) best.feature = Feature::vertex_0;
  if (best.at_1 == 1.0) best.feature = Feature::vertex_1;
  if (best.at_2 == 1.0) best.feature = Feature::vertex_2;
  return best;
}

/// A triangle is a needle if the squared sine of its angle at vertex 0 is less than this.
inline constexpr double kNeedle = 1e-4;

[[nodiscard]] inline Nearest nearestOf(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c,
                                       std::uint32_t triangle) {
  const auto at = [&](const Vec3& point, Feature feature, double v, double w) {
    return Nearest{squared(p - point), triangle, feature, point, v, w};
  };
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return at(a, Feature::vertex_0, 0.0, 0.0);
  const Vec3 bp = p - b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return at(b, Feature::vertex_1, 1.0, 0.0);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 / (d1 - d3);
    return at(a + v * ab, Feature::edge_01, v, 0.0);
  }
  const Vec3 cp = p - c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return at(c, Feature::vertex_2, 0.0, 1.0);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 / (d2 - d6);
    return at(a + w * ac, Feature::edge_20, 0.0, w);
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return at(b + w * (c - b), Feature::edge_12, 1.0 - w, w);
  }
  if (!(va + vb + vc > kNeedle * squared(ab) * squared(ac))) return nearestOfNeedle(p, a, b, c, triangle);
  const double share = 1.0 / (va + vb + vc);
  const double v = vb * share, w = vc * share;
  return at(a + v * ab + w * ac, Feature::inside, v, w);
}

[[nodiscard]] inline Nearest nearestOnTriangle(const Mesh& mesh, const Vec3& probe_mm, std::uint32_t triangle) {
  const Triangle& t = mesh.triangles()[triangle];
  const auto v = mesh.vertices();
  return nearestOf(probe_mm, v[t[0]], v[t[1]], v[t[2]], triangle);
}

/// Which of two is taken: the nearer; of two equally near the one that comes first in the mesh, so that the answer
/// does not depend on the order in which they were found.
[[nodiscard]] inline bool nearer(const Nearest& a, const Nearest& b) {
  return a.squared_mm2 < b.squared_mm2 || (a.squared_mm2 == b.squared_mm2 && a.triangle < b.triangle);
}

}  // namespace fyd::scene
