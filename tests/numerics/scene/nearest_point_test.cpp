// The walk with its certificate against every triangle of the mesh, looked at one by one.
#include "core/scene/mesh/nearest_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <tuple>

#include "core/scene/mesh/vector.h"
#include "tests/unit/scene/shapes.h"

namespace fyd::scene {
namespace {

using shapes::bumps;
using shapes::heights;
using shapes::scaled;

/// Independent of nearestOf: a point within a triangle by its plane and three half-planes, else the nearest of three
/// segments.
double distanceTo(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 n = cross(b - a, c - a);
  const auto within = [&](const Vec3& from, const Vec3& to) { return dot(cross(n, to - from), p - from) >= 0.0; };
  if (within(a, b) && within(b, c) && within(c, a)) return std::abs(dot(n, p - a)) / length(n);
  const auto segment = [&](const Vec3& from, const Vec3& to) {
    const Vec3 way = to - from;
    const double at = std::clamp(dot(p - from, way) / squared(way), 0.0, 1.0);
    return length(p - (from + at * way));
  };
  return std::min({segment(a, b), segment(b, c), segment(c, a)});
}

double distanceTo(const Vec3& p, const Mesh& mesh) {
  double least = 1e300;
  for (const Triangle& t : mesh.triangles()) {
    const auto v = mesh.vertices();
    least = std::min(least, distanceTo(p, v[t[0]], v[t[1]], v[t[2]]));
  }
  return least;
}

/// Two sheets, 0.05 mm apart, and a wall between them with a fold.
TriangleSoup thinWalls() {
  TriangleSoup a = heights(10.0, 30, [](double x, double y) { return 0.3 * x + 0.1 * std::abs(y); });
  const TriangleSoup b = heights(10.0, 17, [](double x, double y) { return 0.3 * x + 0.1 * std::abs(y) + 0.05; });
  const auto more = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + more, t[2] + more, t[1] + more});
  return a;
}

/// Triangles anywhere that know nothing of each other, most of them needles.
TriangleSoup chaos(unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> any(0.0, 1.0);
  TriangleSoup soup;
  for (std::uint32_t t = 0; t < 400; ++t) {
    const Vec3 at = {10.0 * any(random), 10.0 * any(random), 10.0 * any(random)};
    const double thin = std::pow(10.0, -6.0 * std::abs(any(random)));
    const Vec3 way = {any(random), any(random), any(random)};
    soup.vertices.insert(soup.vertices.end(),
                         {at, at + 3.0 * way, at + 1.5 * way + thin * Vec3{any(random), any(random), any(random)}});
    soup.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return soup;
}

/// A ball of needles and large triangles around few vertices: fans of many triangles, folded over themselves.
TriangleSoup crumpled(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-5.0, 5.0);
  TriangleSoup soup;
  for (int v = 0; v < 40; ++v) soup.vertices.push_back({any(random), any(random), any(random)});
  std::uniform_int_distribution<std::uint32_t> which(0, 39);
  for (int t = 0; t < 200; ++t) soup.triangles.push_back({which(random), which(random), which(random)});
  return soup;
}

/// Corners of a coarse grid, joined anyhow: many triangles touch or cross each other without a common vertex.
TriangleSoup touching(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> any(0, 2);
  TriangleSoup soup;
  for (int v = 0; v < 40; ++v) {
    soup.vertices.push_back({5.0 * any(random), 5.0 * any(random), 20.0 * any(random)});
  }
  std::uniform_int_distribution<std::uint32_t> which(0, 39);
  for (int t = 0; t < 30; ++t) soup.triangles.push_back({which(random), which(random), which(random)});
  return soup;
}

/// Steps of 0.1 mm, now and then a leap, near the mesh and far from it, along its edges and exactly on its vertices.
template <class Each>
void wander(const Mesh& mesh, int steps, unsigned seed, Each each) {
  std::mt19937 random(seed);
  std::normal_distribution<double> any(0.0, 1.0);
  std::uniform_int_distribution<std::size_t> which(0, mesh.triangles().size() - 1);
  const double size_mm = length(mesh.report().highest_mm - mesh.report().lowest_mm);
  const double step_mm = size_mm / 1000.0;
  Vec3 at, way;
  for (int i = 0; i < steps; ++i) {
    if (i % 97 == 0) {
      const Triangle& t = mesh.triangles()[which(random)];
      const auto v = mesh.vertices();
      const double a = std::abs(any(random)), b = std::abs(any(random)), c = i % 3 == 0 ? 0.0 : std::abs(any(random));
      at = (1.0 / (a + b + c)) * (a * v[t[0]] + b * v[t[1]] + c * v[t[2]]);
      if (i % 5 == 0) at = v[t[0]];
      const double away = i % 7 == 0 ? 0.0 : (i % 11 == 0 ? size_mm : size_mm / 100.0) * any(random);
      at = at + away * unit(cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]));
      way = unit({any(random), any(random), any(random)});
    } else {
      way = unit(way + 0.1 * Vec3{any(random), any(random), any(random)});
      at = at + step_mm * way;
    }
    each(at);
  }
}

struct Searched {
  explicit Searched(TriangleSoup soup) : mesh(*Mesh::build(std::move(soup))), tree(mesh), walkable(tree) {}
  Mesh mesh;
  TriangleTree tree;
  WalkableMesh walkable;
};

void expectWholeSearch(const Searched& on, int steps, unsigned seed) {
  NearestPoint probe(on.walkable);
  int differs = 0;
  double worst = 0.0;
  wander(on.mesh, steps, seed, [&](const Vec3& at) {
    const Nearest walked = probe.find(at), asked = on.tree.nearest(at);
    const double a = std::sqrt(walked.squared_mm2), b = std::sqrt(asked.squared_mm2);
    if (a != b) worst = std::max(worst, std::abs(a - b) / std::max(b, 1e-3 * on.mesh.report().mean_edge_mm));
    differs += walked.triangle != asked.triangle ? 1 : 0;
  });
  EXPECT_LE(worst, 1e-12);
  EXPECT_LE(differs, steps / 1000) << "another triangle of those that are equally near";
}

void expectEveryTriangle(const Searched& on, int steps, unsigned seed, double tolerance = 1e-12) {
  NearestPoint probe(on.walkable);
  double worst = 0.0;
  const double size_mm = length(on.mesh.report().highest_mm - on.mesh.report().lowest_mm);
  wander(on.mesh, steps, seed, [&](const Vec3& at) {
    worst = std::max(worst, std::abs(std::sqrt(probe.find(at).squared_mm2) - distanceTo(at, on.mesh)) / size_mm);
  });
  EXPECT_LE(worst, tolerance);
}

TEST(NearestPoint, AMillionStepsAreAsNearAsTheWholeSearch) {
  expectWholeSearch(Searched(bumps(71)), 600'000, 1);
  expectWholeSearch(Searched(bumps(200)), 400'000, 2);
}

TEST(NearestPoint, HardMeshesAreAsNearAsTheWholeSearch) {
  expectWholeSearch(Searched(thinWalls()), 200'000, 3);
  for (unsigned seed = 0; seed < 10; ++seed) {
    expectWholeSearch(Searched(chaos(seed)), 20'000, seed);
    expectWholeSearch(Searched(crumpled(seed)), 20'000, seed);
    expectWholeSearch(Searched(touching(seed)), 20'000, seed);
  }
}

TEST(NearestPoint, AsNearAsTheNearestOfAllTriangles) {
  expectEveryTriangle(Searched(bumps(30)), 6'000, 4);
  expectEveryTriangle(Searched(thinWalls()), 4'000, 5);
  expectEveryTriangle(Searched(chaos(6)), 20'000, 6, 1e-8);  // rounding turns needles of 1e-8 their length
  expectEveryTriangle(Searched(crumpled(7)), 20'000, 7);
  for (unsigned seed = 0; seed < 10; ++seed) expectEveryTriangle(Searched(touching(seed)), 20'000, seed);
}

TEST(NearestPoint, OfAnyScale) {
  for (const double scale : {1e-6, 1e-3, 1e3, 1e6}) {
    expectWholeSearch(Searched(scaled(bumps(40), scale)), 50'000, 8);
    expectEveryTriangle(Searched(scaled(crumpled(9), scale)), 2'000, 9);
  }
}

TEST(NearestPoint, OneTriangleAndNoPlace) {
  TriangleSoup one;
  one.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  one.triangles = {{0, 1, 2}};
  const Searched on(one);
  NearestPoint probe(on.walkable);
  EXPECT_DOUBLE_EQ(probe.find({0.2, 0.2, 3.0}).squared_mm2, 9.0);
  EXPECT_EQ(probe.find({std::nan(""), 0.0, 0.0}).triangle, kNoTriangle);
  EXPECT_EQ(probe.find({1e300, 0.0, 0.0}).triangle, kNoTriangle);
  EXPECT_DOUBLE_EQ(probe.find({-3.0, 0.5, 0.0}).squared_mm2, 9.0);
}

TEST(NearestPoint, AFanOfManyTriangles) {
  TriangleSoup cone;
  constexpr std::uint32_t kMany = 20'000;
  cone.vertices.push_back({0.0, 0.0, 5.0});
  for (std::uint32_t i = 0; i < kMany; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kMany;
    cone.vertices.push_back({10.0 * std::cos(turn), 10.0 * std::sin(turn), 0.0});
    cone.triangles.push_back({0, 1 + i, 1 + (i + 1) % kMany});
  }
  expectWholeSearch(Searched(cone), 1'000, 11);
}

/// The certificate is what spares the tree: without it, this would only be slow.
TEST(NearestPoint, BallsBesideATriangleAreEmpty) {
  const Searched on(bumps(71));
  std::mt19937 random(10);
  std::uniform_int_distribution<std::uint32_t> which(0, static_cast<std::uint32_t>(on.mesh.triangles().size()) - 1);
  double sum_mm = 0.0;
  for (int i = 0; i < 300; ++i) {
    const std::uint32_t t = which(random);
    const auto v = on.mesh.vertices();
    const Triangle& own = on.mesh.triangles()[t];
    for (const bool outside : {false, true}) {
      const double radius_mm = on.walkable.emptyBall_mm(t, outside);
      sum_mm += radius_mm;
      for (const std::array<double, 3> share : {std::array{0.98, 0.01, 0.01}, {0.3, 0.3, 0.4}, {0.0, 0.5, 0.5}}) {
        const Vec3 touching = share[0] * v[own[0]] + share[1] * v[own[1]] + share[2] * v[own[2]];
        const Vec3 middle = touching + (outside ? radius_mm : -radius_mm) * on.mesh.triangleNormal(t);
        for (const Triangle& other : on.mesh.triangles()) {
          const bool apart = std::none_of(other.begin(), other.end(), [&own](std::uint32_t w) {
            return w == own[0] || w == own[1] || w == own[2];
          });
          if (!apart) continue;
          ASSERT_GE(distanceTo(middle, v[other[0]], v[other[1]], v[other[2]]), radius_mm);
        }
      }
    }
  }
  EXPECT_GT(sum_mm / 600.0, 2.0) << "the surface's least radius of curvature is 2.5 mm";
}

/// Several threads build it.
TEST(NearestPoint, BuiltTwiceIsTheSame) {
  const Searched on(bumps(71));
  const WalkableMesh again(on.tree);
  const auto bytes = [](const WalkableMesh::Side& s) { return std::tie(s.empty, s.edge, s.strip, s.disc); };
  for (std::uint32_t t = 0; t < on.mesh.triangles().size(); ++t) {
    for (const bool outside : {false, true}) {
      ASSERT_EQ(bytes(on.walkable.side(t, outside)), bytes(again.side(t, outside))) << t;
    }
  }
}

}  // namespace
}  // namespace fyd::scene
