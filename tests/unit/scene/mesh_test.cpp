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

TEST(Mesh, NothingToTouchIsSaid) {
  EXPECT_FALSE(Mesh::build({}).has_value());
  TriangleSoup soup;
  soup.vertices = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  soup.triangles = {{0, 1, 2}};
  EXPECT_FALSE(Mesh::build(soup).has_value());
}

}  // namespace
}  // namespace fyd::scene
