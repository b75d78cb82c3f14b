// What a scene in a robot's place shows of itself.
#include "core/sim/scene_arm.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace fyd::sim {
namespace {

using std::chrono::milliseconds;

/// A square of 20 mm that looks up, and a scene of it. Removed at the end.
class SceneFolder {
 public:
  explicit SceneFolder(const std::string& body) {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "square.obj") << "v -10 -10 0\nv 10 -10 0\nv 10 10 0\nv -10 10 0\nf 1 2 3\nf 1 3 4\n";
    std::ofstream(folder_ / "scene.toml") << "[[body]]\nmesh = \"square.obj\"\nunit = \"mm\"\n" << body;
  }
  ~SceneFolder() { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::unique_ptr<SceneArm> open() const {
    auto arm = SceneArm::open((folder_ / "scene.toml").string(), 1000.0);
    EXPECT_TRUE(arm) << arm.error().message.text();
    return arm ? std::move(*arm) : nullptr;
  }

 private:
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("fyd_scene_arm_" + std::to_string(::getpid()));
};

Instant at(int ms) { return Instant{} + std::chrono::hours(1) + milliseconds(ms); }

TEST(SceneArm, WhatIsTouchedIsShown) {
  const SceneFolder folder("stiffness_N_per_mm = 0.5\ncontact = \"facet\"\nvelocity_mm_per_s = [100, 0, 0]\n");
  const auto arm = folder.open();
  ASSERT_NE(arm, nullptr);
  SceneStage& stage = *arm->stage();
  EXPECT_EQ(stage.file().meshes.size(), 1U);
  EXPECT_FALSE(stage.newest().stepped);
  ASSERT_TRUE(arm->exchange({1.0, 2.0, 3.0}, at(0)));
  EXPECT_TRUE(stage.newest().stepped);
  EXPECT_FALSE(stage.newest().touch.touching);
  ASSERT_TRUE(arm->exchange({1.0, 2.0, -2.0}, at(20)));
  const SceneMoment& now = stage.newest();
  EXPECT_EQ(now.point_mm, (Vec3{1.0, 2.0, -2.0}));
  EXPECT_TRUE(now.touch.touching);
  EXPECT_NEAR(now.touch.force_N.z, 1.0, 1e-12);  // 2 mm deep
  EXPECT_NEAR(now.touch.proxy_mm.z, 0.0, 1e-12);
  EXPECT_NEAR(now.time_s, 0.02, 1e-9);
  EXPECT_NEAR(stage.placements()[0].toScene({}, now.time_s).x, 2.0, 1e-6);
  EXPECT_TRUE(now.shapes_mm[0].empty());  // rigid
}

TEST(SceneArm, ShownAtMostAboutSixtyTimesASecond) {
  const SceneFolder folder("contact = \"facet\"\n");
  const auto arm = folder.open();
  ASSERT_NE(arm, nullptr);
  int changes = 0;
  double last_s = -1.0;
  for (int ms = 0; ms < 1000; ++ms) {
    ASSERT_TRUE(arm->exchange({0.0, 0.0, 1.0}, at(ms)));
    const double now_s = arm->stage()->newest().time_s;
    changes += now_s == last_s ? 0 : 1;
    last_s = now_s;
  }
  EXPECT_EQ(changes, 63);  // at 0, 16, … 992 ms
}

TEST(SceneArm, APressedSoftBodysShapeIsShown) {
  const SceneFolder folder("soft = true\nstiffness_N_per_mm = 0.5\nspread_mm = 5\nfinger_mm = 5\n");
  const auto arm = folder.open();
  ASSERT_NE(arm, nullptr);
  ASSERT_TRUE(arm->exchange({0.0, 0.0, 5.0}, at(0)));
  EXPECT_TRUE(arm->stage()->newest().shapes_mm[0].empty());  // at rest
  for (int ms = 1; ms <= 200; ++ms) ASSERT_TRUE(arm->exchange({0.0, 0.0, -1.0}, at(ms)));
  const std::vector<Vec3>& shape_mm = arm->stage()->newest().shapes_mm[0];
  ASSERT_EQ(shape_mm.size(), 4U);
  double lowest_mm = 0.0;
  for (const Vec3& each : shape_mm) lowest_mm = std::min(lowest_mm, each.z);
  EXPECT_LT(lowest_mm, -0.05);
}

}  // namespace
}  // namespace fyd::sim
