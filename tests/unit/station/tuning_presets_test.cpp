// Presets: what is saved comes back, what is bad changes nothing and says where, names cannot leave the folder.
#include "core/station/profile/tuning_presets.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace fyd::station {
namespace {

class Presets : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "fyd-presets-XXXXXX").string();
    root_ = ::mkdtemp(pattern.data());
    folder_ = presetFolder((root_ / "profile.toml").string());
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  std::filesystem::path root_;
  std::string folder_;
};

TEST_F(Presets, WhatIsSavedComesBackOverAnotherProfile) {
  EXPECT_TRUE(presetNames(folder_).empty());
  Profile soft;
  soft.step.control.kp = 0.123456789012345;
  soft.step.texture.method = texture::MethodChoice::soc;
  ASSERT_TRUE(writePreset(folder_, "soft cloth", formatPreset(soft)));
  EXPECT_EQ(presetNames(folder_), std::vector<std::string>{"soft cloth"});

  Profile base;
  base.step.control.kp = 7.0;
  base.step.control.ki_per_s = 9.0;
  base.step.control.travel_maximum_deg = 80.0;  // not live: stays the base's
  const auto text = readPreset(folder_, "soft cloth");
  ASSERT_TRUE(text) << text.error().text();
  const auto read = parsePreset(*text, "soft cloth", base);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->step.control.kp, soft.step.control.kp);
  EXPECT_EQ(read->step.control.ki_per_s, soft.step.control.ki_per_s);
  EXPECT_EQ(read->step.texture.method, texture::MethodChoice::soc);
  EXPECT_EQ(read->step.control.travel_maximum_deg, 80.0);
}

TEST_F(Presets, AParameterThatIsNotNamedStays) {
  Profile base;
  base.step.control.ki_per_s = 9.0;
  const auto read = parsePreset("[control]\nkp = 0.5\n", "p", base);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->step.control.kp, 0.5);
  EXPECT_EQ(read->step.control.ki_per_s, 9.0);
}

TEST_F(Presets, CalibratedValuesAreNotCarriedToAnotherTouchpad) {
  Profile one;
  one.step.control.kp = 0.5;
  one.step.sensing.finger.threshold = 91;
  const std::string text = formatPreset(one);
  EXPECT_EQ(text.find("finger_threshold"), std::string::npos) << text;
  EXPECT_EQ(text.find("measurement_bias"), std::string::npos) << text;

  Profile other;
  other.step.sensing.finger.threshold = 55;
  // As an earlier version wrote it.
  const auto read = parsePreset("[control]\nkp = 0.5\n[sensing]\nfinger_threshold = 91\n", "older", other);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->step.control.kp, 0.5);
  EXPECT_EQ(read->step.sensing.finger.threshold, 55);
  EXPECT_FALSE(parsePreset("[sensing]\nfinger_threshold = 900\n", "older", other));
}

TEST_F(Presets, ABadOneIsRefusedWithItsPlace) {
  const Profile base;
  for (const auto& [text, expected] : {std::pair{"[control]\nkp = -1\n", "p:2: control.kp"},
                                       {"[control]\nkp = nan\n", "control.kp"},
                                       {"[control]\nkpp = 1\n", "unknown parameter 'control.kpp'"},
                                       {"[control]\ntravel_maximum_deg = 80\n", "cannot change while"},
                                       {"[sensing]\nir_offset_mm = [1, 2, 3]\n", "cannot change while"},
                                       {"[control\nkp = 1\n", "p:1"},
                                       {"kp = 1\n", "outside a table"}}) {
    const auto read = parsePreset(text, "p", base);
    ASSERT_FALSE(read) << text;
    EXPECT_NE(read.error().text().find(expected), std::string::npos) << read.error().text();
  }
}

TEST_F(Presets, NamesStayInTheFolder) {
  for (const char* name : {"", " a", "a ", "../a", "a/b", ".", "..", ".hidden", "a.b", "a\nb", "nul\\"}) {
    EXPECT_FALSE(checkPresetName(name)) << name;
    EXPECT_FALSE(writePreset(folder_, name, "")) << name;
    EXPECT_FALSE(readPreset(folder_, name)) << name;
    EXPECT_FALSE(removePreset(folder_, name)) << name;
  }
  EXPECT_FALSE(checkPresetName(std::string(41, 'a')));
  EXPECT_TRUE(checkPresetName(std::string(40, 'a')));
  EXPECT_TRUE(checkPresetName("Söft"));
  EXPECT_FALSE(std::filesystem::exists(folder_));
}

TEST_F(Presets, WhatCannotBeReadOrWrittenIsSaid) {
  EXPECT_NE(readPreset(folder_, "none").error().text().find("none.toml"), std::string::npos);
  EXPECT_NE(removePreset(folder_, "none").error().text().find("no such file"), std::string::npos);
  std::ofstream(root_ / "presets") << "a file in the way";
  EXPECT_FALSE(writePreset(folder_, "soft", ""));
  EXPECT_TRUE(presetNames(folder_).empty());
}

TEST_F(Presets, OtherFilesInTheFolderAreNoPresets) {
  std::filesystem::create_directories(std::filesystem::path(folder_) / "folder.toml");
  std::ofstream(std::filesystem::path(folder_) / "readme.txt") << "hello";
  std::ofstream(std::filesystem::path(folder_) / ".toml") << "";
  ASSERT_TRUE(writePreset(folder_, "b", "x"));
  ASSERT_TRUE(writePreset(folder_, "a", "x"));
  EXPECT_EQ(presetNames(folder_), (std::vector<std::string>{"a", "b"}));
  ASSERT_TRUE(removePreset(folder_, "a"));
  EXPECT_EQ(presetNames(folder_), std::vector<std::string>{"b"});
}

}  // namespace
}  // namespace fyd::station
