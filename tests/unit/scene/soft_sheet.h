// A flat sheet of triangles, and a hand's paths, for tests of soft bodies.
#pragma once

#include <random>

#include "core/scene/soft/soft_body.h"

namespace fyd::scene {

/// Square in z = 0, centred on the origin, with alternating diagonals.
inline Mesh sheet(int cells, double side_mm) {
  TriangleSoup soup;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      soup.vertices.push_back({side_mm * (double(i) / cells - 0.5), side_mm * (double(j) / cells - 0.5), 0.0});
    }
  }
  const auto at = [&](int i, int j) { return std::uint32_t(j * (cells + 1) + i); };
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      if ((i + j) % 2 != 0) {
        soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      } else {
        soup.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        soup.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  return *Mesh::build(soup);
}

struct SoftSheet {
  SoftSheet(int cells, double side_mm, const SoftMaterial& material, const SoftResolution& resolution = {})
      : mesh(sheet(cells, side_mm)), tree(mesh), body(*SoftBody::build(tree, material, resolution)) {}
  SoftSheet(const SoftSheet&) = delete;
  SoftSheet& operator=(const SoftSheet&) = delete;
  Mesh mesh;
  TriangleTree tree;
  SoftBody body;
};

}  // namespace fyd::scene
