// Meshes for the tests of scenes, and the surfaces they stand for.
#pragma once

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/scene/mesh/mesh.h"
#include "core/scene/mesh/vector.h"

namespace fyd::scene::shapes {

inline Mesh built(TriangleSoup soup) {
  auto mesh = Mesh::build(std::move(soup));
  if (!mesh) throw std::runtime_error("the test's mesh has no triangle");
  return std::move(*mesh);
}

/// Axis-aligned box with corners at ± half.
inline TriangleSoup box(double half_x, double half_y, double half_z) {
  TriangleSoup soup;
  for (int i = 0; i < 8; ++i) {
    soup.vertices.push_back(
        {(i & 1) != 0 ? half_x : -half_x, (i & 2) != 0 ? half_y : -half_y, (i & 4) != 0 ? half_z : -half_z});
  }
  soup.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return soup;
}

/// A height over a square of ± half, in `cells` × `cells` squares of two triangles; outside is +z.
template <class Height>
TriangleSoup heights(double half, unsigned cells, Height height) {
  TriangleSoup soup;
  for (unsigned j = 0; j <= cells; ++j) {
    for (unsigned i = 0; i <= cells; ++i) {
      const double x = half * (2.0 * i / cells - 1.0), y = half * (2.0 * j / cells - 1.0);
      soup.vertices.push_back({x, y, height(x, y)});
    }
  }
  for (unsigned j = 0; j < cells; ++j) {
    for (unsigned i = 0; i < cells; ++i) {
      const unsigned a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
      soup.triangles.push_back({a, b, d});
      soup.triangles.push_back({a, d, c});
    }
  }
  return soup;
}

inline TriangleSoup plane(double half, unsigned cells) {
  return heights(half, cells, [](double, double) { return 0.0; });
}

/// By meridians and parallels: 2·n·(n − 1) triangles.
inline TriangleSoup sphere(double radius, unsigned n) {
  TriangleSoup soup;
  soup.vertices.push_back({0.0, 0.0, radius});
  for (unsigned j = 1; j < n; ++j) {
    for (unsigned i = 0; i < n; ++i) {
      const double down = std::numbers::pi * j / n, around = 2.0 * std::numbers::pi * i / n;
      soup.vertices.push_back({radius * std::sin(down) * std::cos(around), radius * std::sin(down) * std::sin(around),
                               radius * std::cos(down)});
    }
  }
  const auto last = static_cast<unsigned>(soup.vertices.size());
  soup.vertices.push_back({0.0, 0.0, -radius});
  const auto at = [n](unsigned j, unsigned i) { return 1 + (j - 1) * n + i % n; };
  for (unsigned i = 0; i < n; ++i) {
    soup.triangles.push_back({0, at(1, i), at(1, i + 1)});
    soup.triangles.push_back({last, at(n - 1, i + 1), at(n - 1, i)});
    for (unsigned j = 1; j + 1 < n; ++j) {
      soup.triangles.push_back({at(j, i), at(j + 1, i), at(j + 1, i + 1)});
      soup.triangles.push_back({at(j, i), at(j + 1, i + 1), at(j, i + 1)});
    }
  }
  return soup;
}

/// z = 2 sin(2πx/20) sin(2πy/20), millimetres.
struct Bumps {
  static constexpr double k = 2.0 * std::numbers::pi / 20.0;
  static double height(double x, double y) { return 2.0 * std::sin(k * x) * std::sin(k * y); }
  static Vec3 normal(double x, double y) {
    return unit({-2.0 * k * std::cos(k * x) * std::sin(k * y), -2.0 * k * std::sin(k * x) * std::cos(k * y), 1.0});
  }
  /// The point of the surface that is nearest to p, by Newton's method on the gradient of the squared distance.
  static Vec3 foot(const Vec3& p) {
    double x = p.x, y = p.y;
    for (int i = 0; i < 100; ++i) {
      const double sx = std::sin(k * x), cx = std::cos(k * x), sy = std::sin(k * y), cy = std::cos(k * y);
      const double z = 2.0 * sx * sy - p.z, zx = 2.0 * k * cx * sy, zy = 2.0 * k * sx * cy;
      const double zxx = -k * k * 2.0 * sx * sy, zxy = 2.0 * k * k * cx * cy;
      const double gx = x - p.x + z * zx, gy = y - p.y + z * zy;
      const double a = 1.0 + zx * zx + z * zxx, b = zx * zy + z * zxy, d = 1.0 + zy * zy + z * zxx;
      const double det = a * d - b * b;
      if (!(det > 0.0)) throw std::runtime_error("no nearest point here");
      const double dx = (d * gx - b * gy) / det, dy = (a * gy - b * gx) / det;
      x -= dx;
      y -= dy;
      if (std::abs(dx) + std::abs(dy) < 1e-14) break;
    }
    return {x, y, height(x, y)};
  }
};

inline TriangleSoup bumps(unsigned cells) { return heights(50.0, cells, Bumps::height); }

inline TriangleSoup scaled(TriangleSoup soup, double scale, const Vec3& moved = {}) {
  for (Vec3& v : soup.vertices) v = scale * v + moved;
  return soup;
}

}  // namespace fyd::scene::shapes
