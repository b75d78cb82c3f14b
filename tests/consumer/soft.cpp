// A soft ball is pressed, copied and pressed further: every copy feels what the original feels. Compiled for the very
// processor, too, whose registers may be wider than those that the library was compiled for.
#include <core/scene/felt_scene.h>

#include <numbers>
#include <vector>

#include "expect.h"

using namespace fyd::scene;

namespace {

TriangleSoup ball(double radius_mm, std::uint32_t parallels) {
  TriangleSoup out;
  const std::uint32_t round = 2 * parallels;
  for (std::uint32_t j = 0; j <= parallels; ++j) {
    for (std::uint32_t i = 0; i < round; ++i) {
      const double down = std::numbers::pi * j / parallels, around = std::numbers::pi * i / parallels;
      out.vertices.push_back({radius_mm * std::sin(down) * std::cos(around),
                              radius_mm * std::sin(down) * std::sin(around), radius_mm * std::cos(down)});
    }
  }
  for (std::uint32_t j = 0; j < parallels; ++j) {
    for (std::uint32_t i = 0; i < round; ++i) {
      const std::uint32_t a = j * round + i, b = j * round + (i + 1) % round;
      out.triangles.push_back({a, a + round, b});
      out.triangles.push_back({b, a + round, b + round});
    }
  }
  return out;
}

void press(FeltScene& scene, int from, int to) {
  for (int i = from; i < to; ++i) scene.step({0.0, 0.0, 20.5 - 0.01 * i}, 0.001 * i);
}

}  // namespace

int main() {
  auto description = parseScene("[[body]]\nname = \"ball\"\nmesh = \"ball.obj\"\nsoft = true\n", "soft");
  expect("a scene's text", description.has_value());
  auto mesh = Mesh::build(ball(20.0, 24));
  expect("a mesh", mesh.has_value());
  auto loaded = std::make_shared<LoadedScene>();
  loaded->description = std::move(*description);
  loaded->meshes.push_back(std::make_shared<const SearchedMesh>(std::move(*mesh), false));
  loaded->textures.emplace_back();
  auto scene = FeltScene::build(loaded, 1000.0);
  expect("a scene", scene.has_value());
  press(*scene, 0, 200);
  std::vector<FeltScene> copies(16, *scene);
  press(*scene, 200, 400);
  expect("a force", scene->touch().force_N.z > 0.0);
  for (FeltScene& copy : copies) {
    press(copy, 200, 400);
    expectNear("force on a copy, N", copy.touch().force_N.z, scene->touch().force_N.z, 1e-9);
  }
  copies.front() = std::move(*scene);
}
