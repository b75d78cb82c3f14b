// The scenes that come with the program: each names every parameter of its gesture, as described.
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "core/scene/scene_description.h"

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

}  // namespace
}  // namespace fyd::scene
