// Profile files: round trip, atomic saving, refusal of incomplete or huge files.
#include "core/station/profile/profile.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/station/station.h"

namespace fyd::station {
namespace {

class ProfileFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "fyd-profile-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  [[nodiscard]] std::string path(const std::string& name = "profile.toml") const { return (folder_ / name).string(); }

  std::filesystem::path folder_;
};

/// With devices of its own.
Profile withLaboratory() {
  Profile out;
  out.sources = {.touchpad = "modbus-tcp:192.168.0.7:502",
                 .motors = "qbmove:id=A6",
                 .camera = "id=99F1",
                 .robot = "link:0.0.0.0:3491",
                 .key_file = "lab.key"};
  return out;
}

TEST_F(ProfileFile, RoundTrips) {
  Profile written;
  written.step.control.kp = 0.123456789012345;
  written.step.sensing.indentation.ir_offset_mm[1] = 99.5;
  written.sim.seed = 42;
  ASSERT_TRUE(saveProfile(written, path()));
  const auto read = loadProfile(path());
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->step.control.kp, written.step.control.kp);
  EXPECT_EQ(read->step.sensing.indentation.ir_offset_mm[1], 99.5);
  EXPECT_EQ(read->sim.seed, 42);
}

TEST_F(ProfileFile, SaysWhichDevicesTheStationHas) {
  ASSERT_TRUE(saveProfile(withLaboratory(), path()));
  const auto read = loadProfile(path());
  ASSERT_TRUE(read) << read.error().text();

  const StationOptions all = withProfileSources({.profile = *read});
  EXPECT_EQ(all.touchpad, "modbus-tcp:192.168.0.7:502");
  EXPECT_EQ(all.motors, "qbmove:id=A6");
  EXPECT_EQ(all.camera, "id=99F1");
  EXPECT_EQ(all.robot, "link:0.0.0.0:3491");
  EXPECT_EQ(all.key_file, "lab.key");
}

TEST_F(ProfileFile, ANamedTouchpadOrRobotLeavesTheProfilesDevicesAlone) {
  const StationOptions out =
      withProfileSources({.profile = withLaboratory(), .touchpad = "simulated", .robot = "none"});
  EXPECT_EQ(out.touchpad, "simulated");
  EXPECT_EQ(out.motors, "") << "a simulation must not drive the laboratory's motors";
  EXPECT_EQ(out.camera, "");
  EXPECT_EQ(out.robot, "none");
  EXPECT_EQ(out.key_file, "");
}

TEST_F(ProfileFile, AMissingFileIsNamed) {
  const auto read = loadProfile(path("none.toml"));
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().text(), testing::HasSubstr("none.toml"));
}

/// With another value of every number, as far as its range goes.
Profile unlikeTheDefault() {
  Profile out;
  for (const Parameter& each : bindParameters(out)) {
    if (!each.isNumber()) continue;
    for (const double value :
         {each.value() + 0.123456, each.value() - 0.123456,
          each.value() + 0.123456 * (each.info.maximum - each.value()), each.value() + 1.0, each.value() - 1.0}) {
      if (value == each.value() || !checkParameter(each, value)) continue;
      each.set(value);
      break;
    }
  }
  return out;
}

/// How many parameters stand in whole lines.
std::size_t wholeLines(std::string_view text) {
  std::size_t out = 0;
  for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
    out += text.substr(0, end).find(" = ") != std::string_view::npos ? 1 : 0;
    text.remove_prefix(end + 1);
  }
  return out;
}

// A profile is saved whole or not at all; one that was cut elsewhere is refused, or is what a shorter one says: the
// values before the cut, and the defaults after it. Only in the line of the cut a number may have lost digits.
TEST_F(ProfileFile, EveryHalfWrittenProfileIsRefusedOrShorter) {
  Profile written = unlikeTheDefault(), defaults;
  ASSERT_TRUE(saveProfile(written, path()));
  const auto of_written = bindParameters(written), of_defaults = bindParameters(defaults);
  std::ifstream file(path());
  const std::string whole{std::istreambuf_iterator<char>(file), {}};
  int refused = 0, accepted = 0;
  std::size_t unlike = 0;
  for (std::size_t i = 0; i < of_written.size(); ++i) {
    unlike += formatParameter(of_written[i]) != formatParameter(of_defaults[i]) ? 1 : 0;
  }
  EXPECT_GT(unlike, of_written.size() / 2);
  for (std::size_t size = 0; size < whole.size(); size += 37) {
    std::ofstream(path("half.toml"), std::ios::trunc) << whole.substr(0, size);
    auto read = loadProfile(path("half.toml"));
    if (!read) {
      ++refused;
      continue;
    }
    ++accepted;
    const std::size_t before = wholeLines(whole.substr(0, size));
    const auto of_read = bindParameters(*read);
    for (std::size_t i = 0; i < of_read.size(); ++i) {
      if (i == before) continue;
      ASSERT_EQ(formatParameter(of_read[i]), formatParameter((i < before ? of_written : of_defaults)[i]))
          << of_read[i].id << ", " << size << " bytes";
    }
  }
  EXPECT_GT(refused, 10);
  EXPECT_GT(accepted, 10);
}

TEST_F(ProfileFile, SavingReplacesWholeOrNotAtAll) {
  ASSERT_TRUE(saveProfile(Profile{}, path()));
  std::filesystem::create_directory(path("busy.toml"));  // cannot be replaced by a file
  EXPECT_FALSE(saveProfile(Profile{}, path("busy.toml")));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(std::filesystem::path(path()).parent_path()), {}), 2);
  EXPECT_TRUE(loadProfile(path()));
}

TEST_F(ProfileFile, AReadOnlyFolderIsAClearErrorAndLeavesTheOldProfile) {
  ASSERT_TRUE(saveProfile(Profile{}, path()));
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere; /proc stands for it below";
  ::chmod(folder_.c_str(), 0555);
  const auto saved = saveProfile(Profile{}, path());
  ::chmod(folder_.c_str(), 0755);
  EXPECT_FALSE(saved);
  EXPECT_TRUE(loadProfile(path()));
}

TEST(Profile, AFolderThatTakesNoFilesIsAClearError) {
  const auto saved = saveProfile(Profile{}, "/proc/profile.toml");
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().text(), testing::HasSubstr("/proc/profile.toml: cannot be written"));
}

TEST_F(ProfileFile, AnEnormousFileIsRefusedUnread) {
  std::ofstream(path()).close();
  std::filesystem::resize_file(path(), 8ULL << 30);
  const auto read = loadProfile(path());
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().text(), testing::HasSubstr("expected at most"));
}

TEST(Profile, EveryParameterIsDescribedOnceAndItsDefaultIsAllowed) {
  Profile profile;
  std::set<std::string_view> seen;
  for (const Parameter& parameter : bindParameters(profile)) {
    EXPECT_TRUE(seen.insert(parameter.id).second) << parameter.id << " stands twice";
    EXPECT_FALSE(parameter.info.help.empty()) << parameter.id;
    EXPECT_NE(parameter.id.find('.'), std::string_view::npos) << parameter.id;
    if (parameter.kind == ParameterKind::list) {
      for (const double value : parameter.list()) EXPECT_TRUE(checkParameter(parameter, value)) << parameter.id;
    } else if (parameter.kind == ParameterKind::text) {
      EXPECT_TRUE(checkText(parameter, parameter.text())) << parameter.id;
    } else {
      EXPECT_TRUE(checkParameter(parameter, parameter.value())) << parameter.id;
    }
  }
  EXPECT_GT(seen.size(), 50U);
}

TEST(Profile, AnIndexCountsTheSameInTheProfileAndInTheStep) {
  Profile profile;
  pipeline::Parameters step;
  const auto of_profile = bindParameters(profile);
  const auto of_step = bindParameters(step);
  for (std::size_t i = 0; i < of_step.size(); ++i) EXPECT_EQ(of_profile[i].id, of_step[i].id);
}

}  // namespace
}  // namespace fyd::station
