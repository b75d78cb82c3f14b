#include <cmath>
#include <numbers>

#include "app/bench/parts/scene_bumpy_plane.h"
#include "core/scene/mesh/vector.h"

namespace fyd::bench {
namespace {

constexpr double kWave = 2.0 * std::numbers::pi / kBumpLength_mm;
constexpr double kReach_mm = 40.0;  // of the path, from the middle

}  // namespace

double bumpyHeight(double x_mm, double y_mm) { return kBumps_mm * std::sin(kWave * x_mm) * std::sin(kWave * y_mm); }

Vec3 bumpyNormal(double x_mm, double y_mm) {
  return scene::unit({-kBumps_mm * kWave * std::cos(kWave * x_mm) * std::sin(kWave * y_mm),
                      -kBumps_mm * kWave * std::sin(kWave * x_mm) * std::cos(kWave * y_mm), 1.0});
}

scene::TriangleSoup bumpyPlane(int n) {
  scene::TriangleSoup soup;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= n; ++j) {
      const double x = kPlane_mm * (static_cast<double>(i) / n - 0.5),
                   y = kPlane_mm * (static_cast<double>(j) / n - 0.5);
      soup.vertices.push_back({x, y, bumpyHeight(x, y)});
    }
  }
  const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return soup;
}

std::vector<Vec3> underBumpyPlane(int steps, double speed_mm_s, double depth_mm) {
  std::vector<Vec3> path;
  path.reserve(static_cast<std::size_t>(steps));
  for (int i = 0; i < steps; ++i) {
    const double force_over_stiffness_mm = 1e-3 * speed_mm_s * i;
    const double x = kReach_mm * std::sin(force_over_stiffness_mm / kReach_mm),
                 y = kReach_mm * std::sin(0.731 * force_over_stiffness_mm / kReach_mm + 1.0);
    path.push_back(Vec3{x, y, bumpyHeight(x, y)} - depth_mm * bumpyNormal(x, y));
  }
  return path;
}

}  // namespace fyd::bench
