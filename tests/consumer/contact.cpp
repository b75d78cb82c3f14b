// A finger presses a box, alone and in a scene. Truth: Hooke's law over the way that was pressed, and the direction of
// the face.
#include <core/pipeline/pipeline.h>
#include <core/scene/contact/contact.h>
#include <core/scene/felt_scene.h>
#include <core/scene/mesh/mesh_text.h>

#include "expect.h"

int main() {
  using namespace fyd::scene;
  // A box of 100 × 100 × 40 mm, its top at z = 0.
  constexpr std::string_view kBox = R"(
v -50 -50 -40
v  50 -50 -40
v  50  50 -40
v -50  50 -40
v -50 -50 0
v  50 -50 0
v  50  50 0
v -50  50 0
f 1 4 3 2
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3 4 8 7
f 4 1 5 8
)";
  auto soup = parseMesh(kBox, MeshFormat::obj, LengthUnit::mm);
  expect("a mesh", soup.has_value());
  auto mesh = Mesh::build(std::move(*soup));
  expect("a closed body", mesh && mesh->report().holes == 0 && mesh->report().pieces == 1);
  expectNear("its volume, mm³", mesh->report().volume_mm3, 100.0 * 100.0 * 40.0, 1e-6);

  const TriangleTree tree(*mesh);
  for (const ContactModel model : {ContactModel::facet, ContactModel::proxy}) {
    BodyContact contact(tree, {.stiffness_N_per_mm = 0.8}, {.model = model});
    for (int i = -40; i < 60; ++i) {
      const double depth_mm = 0.05 * i;
      const fyd::Vec3 probe_mm{12.3, -7.1, -depth_mm};
      const Contact touch = contact.touch(probe_mm, {}, tree.nearest(probe_mm));
      expectNear("force upwards, N", touch.force_N.z, depth_mm > 0.0 ? 0.8 * depth_mm : 0.0, 1e-4);
      expectNear("force along the face, N", std::hypot(touch.force_N.x, touch.force_N.y), 0.0, 1e-4);
    }
  }

  // The same box in a scene, and the scene in the robot's place.
  auto description =
      parseScene("[[body]]\nmesh = \"box.obj\"\ncontact = \"facet\"\nstiffness_N_per_mm = 0.8\n", "bench");
  expect("a scene's text", description.has_value());
  LoadedScene loaded{.text = {}, .description = std::move(*description), .meshes = {}, .textures = {std::nullopt}};
  loaded.meshes.push_back(std::make_shared<const SearchedMesh>(std::move(*mesh)));
  auto felt = FeltScene::build(std::make_shared<const LoadedScene>(std::move(loaded)), 1000.0);
  expect("a scene", felt.has_value());
  const fyd::pipeline::LocalModel local{.surface = {}, .scene = std::make_shared<const FeltScene>(*felt)};
  expectNear("force upwards in the scene, N", felt->step({12.3, -7.1, -1.5}, 0.0).force_N.z, 0.8 * 1.5, 1e-4);
  fyd::pipeline::Pipeline pipeline({}, local);
  expect("the step has it", pipeline.step({}).telemetry.step == 1 && pipeline.scene()->rate_Hz() == 1000.0);
  expect("and steps a copy", !pipeline.scene()->touch().touching);
  expect("a sentence is no mesh", !parseMesh("once upon a time", MeshFormat::ply, LengthUnit::mm));
}
