// The scenes that come with the program: each names every parameter of its gesture, as described, and is felt where a
// session leads the haptic point: at most 35 and 25 mm aside, and never above the place where the finger took hold.
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "tests/unit/scene/loaded.h"

namespace fyd::scene {
namespace {

std::string textOf(const std::string& name) {
  std::ifstream file(std::string(FYD_SOURCE_DIR "/resources/scenes/") + name);
  std::ostringstream whole;
  whole << file.rdbuf();
  return whole.str();
}

template <class... Parts>
void namesAll(const std::string& name, Parts... parts) {
  const std::string text = textOf(name);
  const auto look = [&](auto& part) {
    for (const Parameter& each : bindParameters(part)) {
      const std::string key = std::string(each.id.substr(each.id.find('.') + 1)) + " = ";
      EXPECT_NE(text.find("\n" + key), std::string::npos) << name << ": " << each.id;
    }
  };
  (look(parts), ...);
}

TEST(GestureScenes, AreReadAndNameAllTheirParameters) {
  const auto fencing = parseScene(textOf("fencing.toml"), "fencing.toml");
  ASSERT_TRUE(fencing.has_value()) << fencing.error().text();
  namesAll("fencing.toml", fencing->swords.value(), fencing->fencing);
  const auto tennis = parseScene(textOf("tennis.toml"), "tennis.toml");
  ASSERT_TRUE(tennis.has_value()) << tennis.error().text();
  EXPECT_EQ(tennis->ball.value().drag_per_m, 0.02);
  EXPECT_EQ(tennis->serve.z_mm_per_s, 1000.0);
  namesAll("tennis.toml", *tennis->ball, tennis->serve);
  const auto echography = parseScene(textOf("echography.toml"), "echography.toml");
  ASSERT_TRUE(echography.has_value()) << echography.error().text();
  namesAll("echography.toml", echography->palpation.value(), echography->plane);
}

TEST(GestureScenes, InFencingASwordIsFeltAndHeldOnItsSide) {
  for (const double side : {1.0, -1.0}) {
    for (const double z_mm : {0.0, -20.0}) {
      FeltScene scene = felt(loaded(textOf("fencing.toml"), {}));
      double time_s = 0.0;
      const auto to = [&](double y_mm) { return scene.step({5.0, side * y_mm, z_mm}, time_s += 1e-3); };
      for (int i = 0; i <= 500; ++i) EXPECT_FALSE(to(0.02 * i).touching) << i;
      for (int i = 0; i <= 550; ++i) to(10.0 - 0.02 * i);
      const SceneTouch touch = to(-1.0);  // held still: the damper gives nothing
      ASSERT_TRUE(touch.touching);
      EXPECT_NEAR(touch.force_N.y, side * 2.5, 1e-9);  // 0.5 N/mm, five times as far
      EXPECT_NEAR(touch.depth_mm, 1.0, 1e-9) << "of the haptic point, as proxy and stiffness are";
      EXPECT_NEAR(touch.stiffness_N_per_mm, 2.5, 1e-9);
      EXPECT_NEAR(touch.proxy_mm.x, 5.0, 1e-9);
      EXPECT_NEAR(touch.proxy_mm.y, 0.0, 1e-9);
      EXPECT_NEAR(touch.proxy_mm.z, z_mm, 1e-9);
    }
  }
}

TEST(GestureScenes, InTennisTheBallFallsOnARacketThatASessionLeads) {
  for (const double z_mm : {0.0, -6.0, -60.0}) {
    FeltScene scene = felt(loaded(textOf("tennis.toml"), {}));
    double largest_N = 0.0;
    for (int i = 0; i < 1000; ++i) {
      largest_N = std::max(largest_N, length(scene.step({5.0, 0.0, z_mm}, 1e-3 * i).force_N));
    }
    EXPECT_NEAR(largest_N, 6.4, 1e-9) << z_mm;
  }
}

TEST(GestureScenes, InTennisABallThatIsLostIsServedAgain) {
  FeltScene scene = felt(loaded(textOf("tennis.toml"), {}));
  bool fell = false, served = false;
  for (int i = 0; i < 8000 && !served; ++i) {
    scene.step({500.0, 0.0, 0.0}, 1e-3 * i);  // the racket is not beneath
    const BallState& ball = scene.scene().gestures().ball()->ball;
    fell = fell || ball.position_mm.z < -900.0;
    served = fell && ball.position_mm == (Vec3{0.0, 0.0, 500.0}) && ball.velocity_mm_per_s == (Vec3{0.0, 0.0, 1000.0});
  }
  EXPECT_TRUE(served);
}

TEST(GestureScenes, ABodyPushesAProbeNoHarderThanTheLimit) {
  const std::string text =
      "[[body]]\nmesh = \"p.obj\"\ncontact = \"facet\"\nstiffness_N_per_mm = 0.5\n[palpation]\nmost_force_N = 3\n";
  FeltScene scene = felt(loaded(text, {shapes::plane(50.0, 4)}));
  for (int i = 0; i <= 1000; ++i) {
    const double depth_mm = 0.02 * i;
    const SceneTouch touch = scene.step({1.0, 0.3, -depth_mm}, 1e-3 * i);
    EXPECT_NEAR(touch.force_N.z, std::min(0.5 * depth_mm, 3.0), 1e-9) << depth_mm;
  }
}

}  // namespace
}  // namespace fyd::scene
