// Exports that cannot be finished: each says why and leaves nothing of itself, and the file it was to replace stays.
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/recording/file/export_file.h"
#include "core/recording/file/export_part.h"
#include "recording_damage.h"
#include "refusal.h"
#include "tests/files_of_at_most.h"
#include "tests/temporary_folder.h"

namespace fyd::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class ExportRefused : public testing::Test {
 protected:
  static ExportFile begun(const std::string& path, bool replace) {
    auto file = ExportFile::create(path, replace);
    EXPECT_TRUE(file) << (file ? "" : file.error().text());
    return std::move(*file);
  }
  [[nodiscard]] std::vector<std::string> left() const { return namesIn(folder.path()); }

  Folder folder;
  std::string path = folder.file("a.csv");
};

TEST_F(ExportRefused, ANameThatEndsWithItsFolder) {
  const auto file = ExportFile::create(folder.file(""), true);
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().text(), folder.path() + "/: not a file's name");
  EXPECT_THAT(left(), IsEmpty());
}

TEST_F(ExportRefused, AFullDiskLeavesTheFileThatWasToBeReplaced) {
  samples::write(path, "mine");
  {
    ExportFile file = begun(path, true);
    const FilesOfAtMost little(1'000);
    EXPECT_THAT(refusal(file.write(std::string(100'000, 'x'))),
                HasSubstr("a.csv: writing failed: File too large; the file stays as it was"));
  }
  EXPECT_EQ(samples::contentOf(path), "mine");
  EXPECT_THAT(left(), ElementsAre("a.csv"));
}

TEST_F(ExportRefused, WhatWasOnlyBufferedIsMissedAtTheEnd) {
  {
    ExportFile file = begun(path, false);
    const FilesOfAtMost little(10);
    ASSERT_TRUE(file.write("more than ten bytes")) << "it fits into the buffer";
    EXPECT_THAT(refusal(file.commit()), HasSubstr("a.csv: writing failed: File too large; nothing is left of it"));
  }
  EXPECT_THAT(left(), IsEmpty());
}

TEST_F(ExportRefused, AFolderThatGoesBeforeTheFirstByte) {
  const std::string inner = folder.file("in");
  std::filesystem::create_directory(inner);
  ExportFile file = begun(inner + "/a.csv", false);
  std::filesystem::remove_all(inner);
  EXPECT_THAT(refusal(file.write("1")), HasSubstr("a.csv: writing failed: No such file or directory"));
}

TEST_F(ExportRefused, APartThatSomebodyTookAway) {
  samples::write(path, "mine");
  ExportFile file = begun(path, true);
  ASSERT_EQ(::unlink(file.temporary().c_str()), 0);
  EXPECT_THAT(refusal(file.commit()), HasSubstr("No such file or directory; the file stays as it was"));
  EXPECT_EQ(samples::contentOf(path), "mine");
}

TEST_F(ExportRefused, AFolderThatAppearedUnderItsName) {
  {
    ExportFile file = begun(path, true);
    ASSERT_TRUE(file.write("1"));
    std::filesystem::create_directory(path);
    EXPECT_THAT(refusal(file.commit()), HasSubstr("a.csv: is a folder, not a file"));
  }
  EXPECT_THAT(left(), ElementsAre("a.csv"));
  EXPECT_TRUE(std::filesystem::is_directory(path));
}

TEST_F(ExportRefused, AFileThatAppearedUnderItsNameIsNotReplacedUnasked) {
  {
    ExportFile file = begun(path, false);
    ASSERT_TRUE(file.write("1"));
    samples::write(path, "somebody else's");
    EXPECT_EQ(refusal(file.commit()), path + ": exists already");
  }
  EXPECT_EQ(samples::contentOf(path), "somebody else's");
  EXPECT_THAT(left(), ElementsAre("a.csv"));
}

TEST_F(ExportRefused, AFolderInThePlaceOfItsPartDoesNotReplaceAFile) {
  samples::write(path, "mine");
  ExportFile file = begun(path, true);
  ASSERT_EQ(::unlink(file.temporary().c_str()), 0);
  ASSERT_EQ(::mkdir(file.temporary().c_str(), 0700), 0);
  EXPECT_THAT(refusal(file.commit()), HasSubstr("Not a directory; the file stays as it was"));
  EXPECT_EQ(samples::contentOf(path), "mine");
}

TEST(ExportPartNames, AreDottedMarkedAndHaveSixLettersOrDigits) {
  EXPECT_TRUE(isExportPart(".a.fyd-part-azAZ09.csv"));
  EXPECT_FALSE(isExportPart("ab.fyd-part-azAZ09.csv")) << "not hidden";
  EXPECT_FALSE(isExportPart(".a.fyd-part-azAZ0")) << "five";
  for (const char neither : {'{', '`', '[', '@', ':', '/'})  // beside the letters and the digits
    EXPECT_FALSE(isExportPart(std::string(".a.fyd-part-azAZ0") + neither + ".csv")) << neither;
}

}  // namespace
}  // namespace fyd::recording
