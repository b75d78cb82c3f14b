// A mesh file of any content: refused with a reason, or a mesh that can be touched anywhere without a number that is
// none.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/scene/contact/contact.h"
#include "core/scene/mesh/mesh_text.h"
#include "core/scene/mesh/nearest_point.h"
#include "core/scene/mesh/vector.h"
#include "tests/fuzz/fuzz.h"

using namespace fyd;
using namespace fyd::scene;

namespace {

/// What rounding makes of the place of a foot: of a needle of the length L and the height h it is known to within
/// 24·ε·L²/h. The side of an edge on which it is follows from d·d' − d″·d‴, of inner products of L². Each of these has
/// three products of rounded differences, 5·ε·L²; so each term is wrong by 11·ε·L⁴, and by L²·h that is a length.
double roundingOfFeet_mm(const Mesh& mesh) {
  const auto v = mesh.vertices();
  const double size_mm = length(mesh.report().highest_mm - mesh.report().lowest_mm);
  double worst_mm = 0.0;
  for (const Triangle& t : mesh.triangles()) {
    const Vec3 ab = v[t[1]] - v[t[0]], bc = v[t[2]] - v[t[1]], ca = v[t[0]] - v[t[2]];
    const double longest_mm = std::max({length(ab), length(bc), length(ca)});
    const double height_mm = length(cross(ab, ca)) / longest_mm;
    worst_mm = std::max(worst_mm, std::numeric_limits<double>::epsilon() * longest_mm / height_mm * size_mm);
  }
  return 24.0 * worst_mm;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1 || size > 4096) return 0;
  const auto format = static_cast<MeshFormat>(data[0] % kMeshFormats.size());
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  auto soup = parseMesh(bytes, format, LengthUnit::mm);
  if (!soup) {
    fuzz::require(!soup.error().text().empty());
    return 0;
  }
  const auto mesh = Mesh::build(std::move(*soup));
  if (!mesh) return 0;
  const TriangleTree tree(*mesh);
  const WalkableMesh walkable(tree);
  const double rounding_mm = roundingOfFeet_mm(*mesh);
  for (const ContactModel model :
       {ContactModel::nodes, ContactModel::facet, ContactModel::vicinity, ContactModel::proxy}) {
    BodyContact contact(tree, {.stiffness_N_per_mm = 0.5}, {.model = model});
    NearestPoint nearest(walkable);
    const Vec3 low = mesh->report().lowest_mm, high = mesh->report().highest_mm;
    for (int i = 0; i <= 8; ++i) {
      const double at = i / 8.0;
      const Vec3 probe = {low.x + at * (high.x - low.x), high.y + (0.3 - at) * (high.y - low.y),
                          low.z + 0.5 * (high.z - low.z)};
      const Nearest found = nearest.find(probe);
      const double whole = std::sqrt(tree.nearest(probe).squared_mm2);
      if (std::isinf(whole)) {  // only where nothing is searched
        fuzz::require(length(probe - 0.5 * (low + high)) >= kFarthest_mm);
      } else {
        fuzz::require(std::abs(std::sqrt(found.squared_mm2) - whole) <=
                      1e-9 * (whole + length(high - low)) + rounding_mm);
      }
      const Contact touch = contact.touch(probe, {}, found);
      fuzz::require(touch.force_N.finite() && touch.proxy_mm.finite() && std::isfinite(touch.depth_mm));
    }
  }
  return 0;
}
