#include <algorithm>
#include <cmath>

#include "widgets/scene/scene_shot.h"

namespace fyd::widgets {
namespace {

bool goodTriangle(const SceneBody& body, const scene::Triangle& triangle) {
  return std::ranges::all_of(triangle, [&](std::uint32_t corner) {
    return corner < body.vertices_mm.size() && body.vertices_mm[corner].finite();
  });
}

void appendUnit(std::vector<float>& to, Vec3 unit) {
  for (const double each : {unit.x, unit.y, unit.z}) to.push_back(static_cast<float>(each));
}

}  // namespace

std::shared_ptr<const SceneMeshes> SceneMeshes::of(std::span<const SceneBody> bodies) {
  auto out = std::make_shared<SceneMeshes>();
  SceneBox all;
  out->bodies.resize(bodies.size());
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const SceneBody& given = bodies[b];
    Body& body = out->bodies[b];
    body.name = given.name;
    body.role = given.role;
    if (given.triangles.size() > scene::kMostTriangles - out->triangles) {
      out->too_big.push_back(given.name);
      continue;
    }
    body.triangles.reserve(3 * given.triangles.size());
    for (const scene::Triangle& triangle : given.triangles) {
      if (!goodTriangle(given, triangle)) {
        ++out->left_out;
        continue;
      }
      for (const std::uint32_t corner : triangle) body.box.add(given.vertices_mm[corner]);
      body.triangles.insert(body.triangles.end(), triangle.begin(), triangle.end());
    }
    out->triangles += body.triangles.size() / 3;
    all.add(body.box);
  }
  if (!all.empty()) {
    out->middle_mm = all.middle();
    out->radius_mm = all.radius();
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    if (!out->bodies[b].triangles.empty()) out->bodies[b].vertices = out->shapeOf(b, bodies[b].vertices_mm);
  }
  return out;
}

std::vector<float> SceneMeshes::shapeOf(std::size_t body, std::span<const Vec3> vertices_mm) const {
  std::vector<float> out;
  if (body >= bodies.size()) return out;
  const std::vector<float>& given = bodies[body].vertices;
  if (!given.empty() && given.size() != 3 * (vertices_mm.size() + 1)) return out;
  out.reserve(3 * (vertices_mm.size() + 1));
  for (const Vec3& v : vertices_mm) {
    const std::size_t at = out.size();
    // A vertex that is no number stays where it was given; without a triangle it is nowhere.
    if (v.finite() || at + 3 > given.size()) {
      appendUnit(out, v.finite() ? unitOf(v) : Vec3{});
    } else {
      out.insert(out.end(), given.begin() + static_cast<std::ptrdiff_t>(at),
                 given.begin() + static_cast<std::ptrdiff_t>(at + 3));
    }
  }
  appendUnit(out, {});
  return out;
}

}  // namespace fyd::widgets
