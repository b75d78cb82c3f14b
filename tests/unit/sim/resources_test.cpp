// Files that come with the programs are found by their name alone; a file of one's own comes first.
#include "core/sim/resources.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "tests/temporary_folder.h"

namespace fyd::sim {
namespace {

using testing::EndsWith;

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Resources, AreFoundByNameWithAndWithoutEnding) {
  for (const char* name : {"wood", "wood.toml"}) {
    const std::string found = findResource(name, "textures");
    EXPECT_THAT(found, EndsWith("/share/fyd-console/textures/wood.toml"));
    EXPECT_EQ(contents(found), contents(FYD_SOURCE_DIR "/resources/textures/wood.toml"));
  }
}

TEST(Resources, OfAnotherKindAreNotFound) { EXPECT_EQ(findResource("wood.toml", "scenes"), "wood.toml"); }

TEST(Resources, GiveWayToAFileOfThisName) {
  const Folder folder;
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  std::ofstream("wood.toml") << "mine";
  EXPECT_EQ(findResource("wood.toml", "textures"), "wood.toml");
  EXPECT_THAT(findResource("wood", "textures"), EndsWith("/textures/wood.toml"));
  std::filesystem::create_directory("wood");
  EXPECT_THAT(findResource("wood", "textures"), EndsWith("/textures/wood.toml")) << "a folder is no file of this name";
  std::filesystem::current_path(before);
}

TEST(Resources, AreNotLookedForWhereAFolderIsNamed) {
  EXPECT_EQ(findResource("./wood.toml", "textures"), "./wood.toml");
  EXPECT_EQ(findResource("/nowhere/wood.toml", "textures"), "/nowhere/wood.toml");
  EXPECT_EQ(findResource("", "textures"), "");
  EXPECT_EQ(findResource("../textures/wood.toml", "scenes"), "../textures/wood.toml");
}

}  // namespace
}  // namespace fyd::sim
