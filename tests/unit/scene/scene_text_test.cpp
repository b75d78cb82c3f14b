// Scene files: the smallest scene, defaults, errors with line and expected value.
#include <gtest/gtest.h>

#include "core/scene/scene_description.h"

namespace fyd::scene {
namespace {

std::string errorOf(std::string_view text) {
  const auto scene = parseScene(text, "s.toml");
  return scene ? "" : scene.error().text();
}

TEST(SceneText, TheLeastScene) {
  const auto scene = parseScene(R"(
    [[body]]
    mesh = "bumpy.obj"          # relative to this file
    unit = "mm"
    stiffness_N_per_mm = 0.5
    contact = "vicinity"        # nodes | facet | vicinity | proxy
  )",
                                "s.toml");
  ASSERT_TRUE(scene.has_value()) << scene.error().text();
  ASSERT_EQ(scene->bodies.size(), 1U);
  EXPECT_EQ(scene->bodies[0].mesh, "bumpy.obj");
  EXPECT_EQ(scene->bodies[0].name, "bumpy.obj");
  EXPECT_EQ(scene->bodies[0].contact, ContactChoice::vicinity);
  EXPECT_FALSE(scene->accuracy || scene->swords || scene->ball || scene->palpation);
}

TEST(SceneText, AnAccuracyIsAShare) {
  const std::string body = "[[body]]\nmesh = \"a.obj\"\n";
  EXPECT_DOUBLE_EQ(parseScene("[scene]\naccuracy = \"1%\"\n" + body, "s")->accuracy.value(), 0.01);
  EXPECT_DOUBLE_EQ(parseScene("[scene]\naccuracy = \"0.02\"\n" + body, "s")->accuracy.value(), 0.02);
  for (const char* wrong : {"0", "-1%", "101%", "1 percent", "nan", "inf", "%"}) {
    EXPECT_EQ(errorOf("[scene]\naccuracy = \"" + std::string(wrong) + "\"\n" + body),
              "s.toml: scene.accuracy \"" + std::string(wrong) +
                  "\": expected a share such as \"1%\", above 0 and up to 100%");
  }
}

TEST(SceneText, EveryErrorNamesItsLineAndWhatWasExpected) {
  EXPECT_EQ(errorOf(""), "s.toml: nothing to touch; expected a [[body]], [swords], [ball] or [palpation]");
  EXPECT_EQ(errorOf("[[body]]\nunit = \"mm\"\n"), "s.toml:1: body.mesh: expected an OBJ, STL or PLY file");
  EXPECT_EQ(errorOf("[body]\nmesh = \"a.obj\"\n"), "s.toml:1: 'body': expected tables [[body]]");
  EXPECT_EQ(errorOf("[[body]]\nmesh = \"a.obj\"\nmass = 1\n"),
            "s.toml:3: unknown parameter 'body.mass'; 'fyd scene keys' lists those there are");
  EXPECT_EQ(errorOf("[[body]]\nmesh = \"a.obj\"\nposition_mm = [1, 2]\n"),
            "s.toml:1: body.position_mm: expected three numbers");
  EXPECT_EQ(errorOf("[[body]]\nmesh = \"a.obj\"\nkinetic_friction = 0.5\n"),
            "s.toml:1: body.kinetic_friction 0.5: expected at most body.static_friction, 0");
  EXPECT_EQ(
      errorOf("[room]\n"),
      "s.toml:1: 'room': expected one of [scene], [[body]], [swords], [fencing], [ball], [serve], [palpation] and "
      "[plane]");
  EXPECT_EQ(errorOf("[serve]\nz_mm = 1\n"), "s.toml: [serve] without [ball]");
  EXPECT_EQ(errorOf("[palpation]\n[plane]\nnormal_z = 0\n"),
            "s.toml: plane.normal_x, normal_y and normal_z are 0: expected a direction");
  EXPECT_NE(
      errorOf("[[body]]\nmesh = \"a.obj\"\ncontact = \"soft\"\n").find("s.toml:3: body.contact = \"soft\": expected"),
      std::string::npos);
  for (const char* wrong : {"nan", "inf", "-1", "0", "1e9", "\"1\""}) {
    EXPECT_NE(errorOf("[[body]]\nmesh = \"a.obj\"\nstiffness_N_per_mm = " + std::string(wrong) + "\n")
                  .find("s.toml:3: body.stiffness_N_per_mm"),
              std::string::npos)
        << wrong;
  }
  EXPECT_NE(errorOf("[[body\n").find("s.toml:1: "), std::string::npos);
}

TEST(SceneText, GesturesAreWhatIsNamed) {
  const auto scene = parseScene("[ball]\nrestitution = 0.5\n", "s");
  ASSERT_TRUE(scene.has_value()) << scene.error().text();
  EXPECT_DOUBLE_EQ(scene->ball.value().restitution, 0.5);
  EXPECT_FALSE(scene->swords || scene->palpation);
  EXPECT_TRUE(scene->bodies.empty());
}

}  // namespace
}  // namespace fyd::scene
