// Scenes of several bodies: placement, rotation, sleeping bodies, proxies, bit-exact repetition.
#include "core/scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/scene/mesh/vector.h"
#include "tests/sweep.h"
#include "tests/unit/scene/shapes.h"

namespace fyd::scene {
namespace {

std::shared_ptr<const SearchedMesh> searchedCube() {  // from the origin to 10 mm
  return std::make_shared<const SearchedMesh>(
      shapes::built(shapes::scaled(shapes::box(5.0, 5.0, 5.0), 1.0, {5.0, 5.0, 5.0})));
}

void set(ParameterList& list, Vec3 v) {
  list = {};
  for (const double each : {v.x, v.y, v.z}) ASSERT_TRUE(list.push(each));
}

BodyDescription at(Vec3 position_mm, Vec3 turned_deg = {}, Vec3 velocity_mm_per_s = {}) {
  BodyDescription body;
  set(body.position_mm, position_mm);
  set(body.turned_deg, turned_deg);
  set(body.velocity_mm_per_s, velocity_mm_per_s);
  return body;
}

Scene sceneOf(std::vector<BodyDescription> bodies, ContactModel model = ContactModel::facet) {
  SceneDescription description;
  description.bodies = std::move(bodies);
  const std::size_t count = description.bodies.size();
  return std::move(
      *Scene::build(description, std::vector(count, searchedCube()), std::vector(count, BodyModel{.contact = model})));
}

TEST(Scene, ABodyIsTouchedWhereItStands) {
  // About x by 90°, then moved: the cube's top (z = 10) looks to −y.
  Scene scene = sceneOf({at({100, 200, 300}, {90, 0, 0})});
  const SceneTouch touch = scene.step({105, 191, 305}, 0.0);
  ASSERT_TRUE(touch.touching);
  EXPECT_NEAR(touch.force_N.y, -0.5, 1e-12);
  EXPECT_NEAR(touch.proxy_mm.y, 190.0, 1e-12);
  EXPECT_NEAR(touch.normal.y, -1.0, 1e-12);
  EXPECT_NEAR(length(touch.force_N), 0.5, 1e-12);
}

TEST(Scene, TurnsAreAboutAxesThatStandStill) {
  const Placement turned(at({}, {90, 0, 90}));  // x first: z goes to −y; then about z: −y goes to x
  const Vec3 z = turned.turned({0, 0, 1});
  EXPECT_NEAR(z.x, 1.0, 1e-12);
  const Vec3 back = turned.turnedBack(z);
  EXPECT_NEAR(back.z, 1.0, 1e-12);
}

TEST(Scene, BodiesThatAreFarSleepAndWakeInTime) {
  std::vector<BodyDescription> bodies{at({})};
  for (int i = 1; i < 50; ++i) bodies.push_back(at({1000.0 * i, 0, 0}));
  Scene scene = sceneOf(bodies);
  static_cast<void>(scene.step({5, 5, 20}, 0.0));
  EXPECT_EQ(scene.awake(), 1U);
  // Along all of them, 3.7 mm a step: each is felt exactly where its top is crossed.
  int felt = 0;
  double time_s = 0.0;
  for (const double x : stepsBefore(5.0, 50'000.0, 3.7)) {
    time_s += 1e-3;
    const SceneTouch touch = scene.step({x, 5.0, 9.9}, time_s);
    const double within = std::fmod(x, 1000.0);
    EXPECT_EQ(touch.touching, within > 0.0 && within < 10.0 && x < 49'100) << x;
    felt += touch.touching ? 1 : 0;
    EXPECT_LE(scene.awake(), 1U);
  }
  EXPECT_GT(felt, 100);
}

TEST(Scene, ABodyThatFliesInWakesByItself) {
  Scene scene = sceneOf({at({1000, 0, 0}, {}, {-500, 0, 0})});
  for (int i = 0; i <= 3000; ++i) {
    const double time_s = 1e-3 * i, corner = 1000.0 - 500.0 * time_s;
    const SceneTouch touch = scene.step({5.0, 5.0, 9.9}, time_s);
    if (std::abs(corner - 5.0) < 0.6 || std::abs(corner + 5.0) < 0.6) continue;  // just at a face
    EXPECT_EQ(touch.touching, corner < 5.0 && corner > -5.0) << time_s;
  }
}

TEST(Scene, AProxyIsHeldByAWallThatIsLeapedOver) {
  Scene scene = sceneOf({at({})}, ContactModel::proxy);
  static_cast<void>(scene.step({5, 5, 5000}, 0.0));
  const SceneTouch touch = scene.step({5, 5, -5000}, 1e-3);
  EXPECT_TRUE(touch.touching);
  EXPECT_NEAR(touch.proxy_mm.z, 10.0, 1e-3);
}

TEST(Scene, BodiesPushTogether) {
  // Two cubes overlap in a wedge: one pushes up, the other to the side.
  Scene scene = sceneOf({at({0, 0, 0}), at({-9.5, 0, 4.0})});
  const SceneTouch touch = scene.step({0.2, 5.0, 9.9}, 0.0);
  ASSERT_TRUE(touch.touching);
  EXPECT_NEAR(touch.force_N.z, 0.5 * 0.1, 1e-9);
  EXPECT_NEAR(touch.force_N.x, 0.5 * 0.3, 1e-9);
  EXPECT_EQ(touch.body, 1U);
  // Σ k (n·f)² with unit f: both normals are at right angles, so it is k.
  EXPECT_NEAR(touch.stiffness_N_per_mm, 0.5, 1e-9);
}

TEST(Scene, NumbersThatAreNoneTouchNothing) {
  Scene scene = sceneOf({at({})});
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(scene.step({nan, 5, 5}, 0.0).touching);
  EXPECT_FALSE(scene.step({5, 5, infinite}, 0.0).touching);
  EXPECT_FALSE(scene.step({5, 5, 9}, nan).touching);
  EXPECT_TRUE(scene.step({5, 5, 9}, 0.0).touching);
  EXPECT_FALSE(scene.step({1e300, 5, 9}, 1e-3).touching);
  const SceneTouch last = scene.step({5, 5, 9}, 2e-3);
  for (const double back : {2e-3, 1e-3, -1e9}) {
    EXPECT_EQ(scene.step({5, 5, 8}, back).force_N, last.force_N) << "time does not go back";
  }
}

TEST(Scene, TheSamePathIsTheSameForceBitForBit) {
  for (const ContactModel model :
       {ContactModel::nodes, ContactModel::facet, ContactModel::vicinity, ContactModel::proxy}) {
    Scene a = sceneOf({at({}), at({3, 3, 3}, {10, 20, 30})}, model),
          b = sceneOf({at({}), at({3, 3, 3}, {10, 20, 30})}, model);
    std::mt19937 random(1);
    std::normal_distribution<double> any(0.0, 1.0);
    Vec3 p{5, 5, 15};
    for (int i = 0; i < 3000; ++i) {
      p = 0.99 * (p + 0.3 * Vec3{any(random), any(random), any(random)}) + 0.01 * Vec3{5, 5, 8};
      const SceneTouch one = a.step(p, 1e-3 * i), other = b.step(p, 1e-3 * i);
      ASSERT_EQ(one.force_N, other.force_N);
      ASSERT_EQ(one.proxy_mm, other.proxy_mm);
      ASSERT_TRUE(one.force_N.finite());
    }
  }
}

}  // namespace
}  // namespace fyd::scene
