// The scenes that come with the program: each names every parameter of its gesture, as the one description has it.
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/profile_text.h"
#include "core/scene/ball.h"
#include "core/scene/palpation.h"
#include "core/scene/swords.h"

namespace fyd::scene {
namespace {

template <class... Parts>
void reads(const std::string& name, std::string_view gesture, Parts&... parts) {
  std::ifstream file(std::string(FYD_SOURCE_DIR "/resources/scenes/") + name);
  ASSERT_TRUE(file) << name;
  std::ostringstream whole;
  whole << file.rdbuf();
  std::string text = whole.str();
  // The gesture's name stands above all tables.
  const std::string line = "gesture = \"" + std::string(gesture) + "\"\n";
  const auto at = text.find(line);
  ASSERT_NE(at, std::string::npos) << name;
  text.replace(at, line.size(), "\n");
  std::vector<Parameter> all;
  const auto add = [&](auto& part) {
    const auto bound = bindParameters(part);
    all.insert(all.end(), bound.begin(), bound.end());
  };
  (add(parts), ...);
  const auto read = parseProfile(text, name, all);
  EXPECT_TRUE(read.has_value()) << read.error().text();
  for (const Parameter& each : all) {
    const std::string key = std::string(each.id.substr(each.id.find('.') + 1)) + " = ";
    EXPECT_NE(text.find("\n" + key), std::string::npos) << name << ": " << each.id;
    EXPECT_FALSE(each.info.help.empty()) << each.id;
  }
}

TEST(GestureScenes, AreReadByTheDescriptionsOfTheirParameters) {
  SwordParameters swords;
  FencingParameters fencing;
  reads("fencing.toml", kGestures[static_cast<std::size_t>(Gesture::swords)], swords, fencing);
  BallParameters ball;
  ServeParameters serve;
  reads("tennis.toml", kGestures[static_cast<std::size_t>(Gesture::ball)], ball, serve);
  EXPECT_EQ(ball.drag_per_m, 0.02);
  PalpationParameters palpation;
  PlaneParameters plane;
  reads("echography.toml", kGestures[static_cast<std::size_t>(Gesture::palpation)], palpation, plane);
}

}  // namespace
}  // namespace fyd::scene
