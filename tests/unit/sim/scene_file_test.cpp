// Scenes from files: a mesh that several bodies name.
#include "core/sim/scene_file.h"

#include <fstream>

#include <gtest/gtest.h>

#include "core/scene/scene_bytes.h"
#include "tests/temporary_folder.h"

namespace fyd::sim {
namespace {

TEST(SceneFile, ASoftAndARigidBodyMayNameOneMeshInTwoWays) {
  const Folder folder;
  const std::string mesh = folder.file("square.obj"), scene = folder.file("scene.toml");
  std::ofstream(mesh) << "v -20 -20 0\nv 20 -20 0\nv 20 20 0\nv -20 20 0\nf 1 2 3\nf 1 3 4\n";
  std::ofstream(scene) << "[[body]]\nsoft = true\nmesh = \"" << mesh
                       << "\"\n[[body]]\nmesh = \"square.obj\"\nposition_mm = [0, 0, -10]\n";
  auto felt = openFeltScene(scene, 1000.0);
  ASSERT_TRUE(felt.has_value()) << felt.error().text();
  EXPECT_EQ(felt->loaded()->meshes[0], felt->loaded()->meshes[1]) << "it is read once";
  const auto again = scene::unpackScene(packScene(*felt));
  ASSERT_TRUE(again.has_value()) << again.error().text();
  EXPECT_EQ(again->loaded()->meshes[0], again->loaded()->meshes[1]);
}

}  // namespace
}  // namespace fyd::sim
