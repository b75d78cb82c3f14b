// A mesh with its search tree and contact model, for tests.
#pragma once

#include "core/scene/contact/contact.h"
#include "tests/unit/scene/shapes.h"

namespace fyd::scene {

struct TouchedBody {
  Mesh mesh;
  TriangleTree tree;
  BodyContact contact;

  TouchedBody(TriangleSoup soup, ContactModel model, double radius_mm = 0.0, Surface surface = {})
      : mesh(shapes::built(std::move(soup))), tree(mesh), contact(tree, surface, {model, radius_mm, 0.0}) {}
  TouchedBody(const TouchedBody&) = delete;
  TouchedBody& operator=(const TouchedBody&) = delete;

  Contact at(const Vec3& probe_mm, const Vec3& velocity_mm_s = {}) {
    return contact.touch(probe_mm, velocity_mm_s, tree.nearest(probe_mm));
  }
};

}  // namespace fyd::scene
