// Meshes: volume, repair of defects and their counts, holes, empty meshes.
#include "core/scene/mesh/mesh.h"

#include <gtest/gtest.h>

#include "tests/unit/scene/shapes.h"

namespace fyd::scene {
namespace {

TriangleSoup cube() { return shapes::scaled(shapes::box(0.5, 0.5, 0.5), 1.0, {0.5, 0.5, 0.5}); }

TEST(Mesh, ACubeIsClosedAndOfOneCubicMillimetre) {
  const auto mesh = Mesh::build(cube());
  ASSERT_TRUE(mesh.has_value());
  const MeshReport& r = mesh->report();
  EXPECT_EQ(r.vertices, 8U);
  EXPECT_EQ(r.triangles, 12U);
  EXPECT_EQ(r.pieces, 1U);
  EXPECT_EQ(r.rim_edges + r.holes + r.non_manifold_edges + r.flipped_triangles + r.inside_out, 0U);
  EXPECT_DOUBLE_EQ(r.volume_mm3, 1.0);
  EXPECT_DOUBLE_EQ(r.area_mm2, 6.0);
}

TEST(Mesh, WhatIsBrokenIsMendedAndCounted) {
  TriangleSoup soup = cube();
  soup.vertices.push_back(soup.vertices[7]);          // 8: a second 7
  soup.triangles[11] = {3, 8, 5};                     // by it
  soup.triangles[3] = {5, 6, 7};                      // turned over
  soup.triangles.push_back({0, 0, 1});                // without an area
  soup.triangles.push_back({1, 0, 2});                // the first, again
  soup.vertices.push_back({std::nan(""), 0.0, 0.0});  // 9
  soup.triangles.push_back({0, 1, 9});
  const auto mesh = Mesh::build(soup);
  ASSERT_TRUE(mesh.has_value());
  const MeshReport& r = mesh->report();
  EXPECT_EQ(r.vertices, 8U);
  EXPECT_EQ(r.triangles, 12U);
  EXPECT_EQ(r.duplicate_vertices, 1U);
  EXPECT_EQ(r.flipped_triangles, 1U);
  EXPECT_EQ(r.degenerate_triangles, 1U);
  EXPECT_EQ(r.duplicate_triangles, 1U);
  EXPECT_EQ(r.not_finite, 1U);
  EXPECT_DOUBLE_EQ(r.volume_mm3, 1.0);
}

TEST(Mesh, AMissingTriangleIsAHoleWithThreeRims) {
  TriangleSoup soup = cube();
  soup.triangles.pop_back();
  const auto mesh = Mesh::build(soup);
  ASSERT_TRUE(mesh.has_value());
  EXPECT_EQ(mesh->report().rim_edges, 3U);
  EXPECT_EQ(mesh->report().holes, 1U);
}

/// Two cubes that touch along one edge, which four triangles have.
TriangleSoup twoCubesAlongAnEdge() {
  TriangleSoup soup = cube();
  const auto first = static_cast<std::uint32_t>(soup.vertices.size());
  for (const Vec3& v : cube().vertices) soup.vertices.push_back(v + Vec3{1.0, 1.0, 0.0});
  for (const Triangle& t : cube().triangles) soup.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return soup;
}

TEST(Mesh, BodiesThatShareAnEdgeAreClosed) {
  const auto mesh = Mesh::build(twoCubesAlongAnEdge());
  ASSERT_TRUE(mesh.has_value());
  const MeshReport& r = mesh->report();
  EXPECT_EQ(r.non_manifold_edges, 1U);
  EXPECT_EQ(r.pieces, 2U);
  EXPECT_EQ(r.rim_edges + r.holes + r.inside_out + r.flipped_triangles, 0U);
  EXPECT_NEAR(r.volume_mm3, 2.0, 1e-12);
  std::size_t open = 0;
  for (std::uint32_t t = 0; t < r.triangles; ++t) {
    for (const std::uint32_t other : mesh->neighbours(t)) {
      EXPECT_TRUE(other < r.triangles || other == kNoTriangle) << other;
      open += other == kNoTriangle ? 1 : 0;
    }
  }
  EXPECT_EQ(open, 4U) << "nothing is a neighbour across the edge";
}

TEST(Mesh, AnInsideOutBodyIsNoticedThoughItSharesAnEdge) {
  TriangleSoup soup = twoCubesAlongAnEdge();
  for (std::size_t t = 12; t < 24; ++t) std::swap(soup.triangles[t][1], soup.triangles[t][2]);
  const auto mesh = Mesh::build(soup);
  ASSERT_TRUE(mesh.has_value());
  EXPECT_EQ(mesh->report().inside_out, 1U);
  EXPECT_EQ(mesh->report().holes, 0U);
}

TEST(Mesh, AWallWithinABodyEnclosesNothing) {
  TriangleSoup soup = cube();  // its two diagonals x = z, at y = 0 and 1, lie in one plane
  soup.triangles.push_back({0, 5, 7});
  soup.triangles.push_back({0, 7, 2});
  // The faces y = 0 and y = 1 are cut along that plane.
  soup.triangles[4] = {0, 1, 5};
  soup.triangles[5] = {0, 5, 4};
  soup.triangles[6] = {2, 7, 3};
  soup.triangles[7] = {2, 6, 7};
  const auto mesh = Mesh::build(soup);
  ASSERT_TRUE(mesh.has_value());
  const MeshReport& r = mesh->report();
  EXPECT_EQ(r.non_manifold_edges, 4U);
  EXPECT_EQ(r.rim_edges + r.holes + r.inside_out, 0U);
  EXPECT_EQ(r.volume_mm3, 0.0) << "no piece is closed by itself";
}

TEST(Mesh, NothingToTouchIsSaid) {
  EXPECT_FALSE(Mesh::build({}).has_value());
  TriangleSoup soup;
  soup.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  soup.triangles = {{0, 1, 2}};
  EXPECT_FALSE(Mesh::build(soup).has_value());
}

}  // namespace
}  // namespace fyd::scene
