// A contact model of one's own: k·d along the normal of the vertices, interpolated over the nearest triangle, so that
// the direction of the force turns smoothly. Compared with the program's own models on a sphere of which the true
// answer is known.
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/scene/contact/contact.h"
#include "core/scene/contact/contact_push.h"
#include "core/scene/mesh/vector.h"

using namespace fyd;
using namespace fyd::scene;

// Direction and depth of the push; force = stiffness · force_over_stiffness_mm.
Push shadedPush(const Mesh& mesh, const Vec3& probe_mm, const Nearest& nearest) {
  const Vec3 to_surface = nearest.point_mm - probe_mm;
  const double depth_mm = dot(to_surface, mesh.normalOf(nearest.triangle, nearest.feature));
  if (!(depth_mm > 0.0)) return {};  // outside, or not a number
  const Triangle& corners = mesh.triangles()[nearest.triangle];
  const Vec3 normal = unit((1.0 - nearest.at_1 - nearest.at_2) * mesh.vertexNormal(corners[0]) +
                           nearest.at_1 * mesh.vertexNormal(corners[1]) + nearest.at_2 * mesh.vertexNormal(corners[2]));
  return {depth_mm * normal, nearest.point_mm, normal, depth_mm};
}

// A sphere by meridians and parallels.
Result<Mesh> sphere(double radius_mm, unsigned n) {
  TriangleSoup soup;
  for (unsigned j = 0; j <= n; ++j) {
    for (unsigned i = 0; i < 2 * n; ++i) {
      const double down = std::numbers::pi * j / n, around = std::numbers::pi * i / n;
      soup.vertices.push_back({radius_mm * std::sin(down) * std::cos(around),
                               radius_mm * std::sin(down) * std::sin(around), radius_mm * std::cos(down)});
    }
  }
  for (unsigned j = 0; j < n; ++j) {
    for (unsigned i = 0; i < 2 * n; ++i) {
      const unsigned a = j * 2 * n + i, b = j * 2 * n + (i + 1) % (2 * n), c = a + 2 * n, d = b + 2 * n;
      soup.triangles.push_back({a, c, b});
      soup.triangles.push_back({b, c, d});
    }
  }
  return Mesh::build(std::move(soup));  // merges the points at both poles
}

int main() {
  const auto mesh = sphere(20.0, 24);
  if (!mesh) return fmt::print(stderr, "{}\n", mesh.error().text()), 1;
  const TriangleTree tree(*mesh);
  const Surface surface{.stiffness_N_per_mm = 0.5};
  BodyContact facet(tree, surface, {.model = ContactModel::facet});
  BodyContact vicinity(tree, surface, {.model = ContactModel::vicinity});

  // The true force at 1 mm below the surface of the sphere is 0.5 N, straight outwards.
  double shaded_error = 0.0, facet_error = 0.0, vicinity_error = 0.0;
  constexpr int kPlaces = 2000;
  for (int i = 0; i < kPlaces; ++i) {
    // Places spread evenly by the golden angle.
    const double z = 1.0 - 2.0 * (i + 0.5) / kPlaces, around = std::numbers::pi * (3.0 - std::sqrt(5.0)) * i;
    const double r = std::sqrt(1.0 - z * z);
    const Vec3 outwards{r * std::cos(around), r * std::sin(around), z};
    const Vec3 probe_mm = 19.0 * outwards, truth_N = 0.5 * outwards;
    const Nearest nearest = tree.nearest(probe_mm);
    const Push shaded = shadedPush(*mesh, probe_mm, nearest);
    shaded_error += length(surface.stiffness_N_per_mm * shaded.force_over_stiffness_mm - truth_N) / kPlaces;
    facet_error += length(facet.touch(probe_mm, {}, nearest).force_N - truth_N) / kPlaces;
    vicinity_error += length(vicinity.touch(probe_mm, {}, nearest).force_N - truth_N) / kPlaces;
  }
  fmt::print("mean error of the force, of 0.5 N\nshaded   {:5.1f} mN\nfacet    {:5.1f} mN\nvicinity {:5.1f} mN\n",
             1e3 * shaded_error, 1e3 * facet_error, 1e3 * vicinity_error);
}
