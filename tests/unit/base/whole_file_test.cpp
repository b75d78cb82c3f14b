// Files read as a whole, and files that get another name in one step.
#include "core/base/whole_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "core/base/atomic_rename.h"
#include "tests/temporary_folder.h"

namespace fyd {
namespace {

using testing::HasSubstr;

std::string write(const std::string& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

TEST(WholeFile, ReadsEveryByte) {
  const Folder folder;
  std::string text(200'000, 'x');
  text[7] = '\0';
  EXPECT_EQ(readWholeFile(write(folder.file("a"), text)).value(), text);
  EXPECT_EQ(readWholeFile(write(folder.file("b"), "")).value(), "");
}

TEST(WholeFile, RefusesWhatIsMissingNoFileOrTooLarge) {
  const Folder folder;
  const auto problem = [](const auto& result) { return result ? std::string("none") : result.error().text(); };
  EXPECT_THAT(problem(readWholeFile(folder.file("gone"))), HasSubstr("gone: cannot be read: No such file"));
  EXPECT_THAT(problem(readWholeFile(folder.path())), HasSubstr("it is no file"));
  EXPECT_THAT(problem(readWholeFile("/dev/null")), HasSubstr("it is no file"));
  const std::string five = write(folder.file("five"), "12345");
  EXPECT_THAT(problem(readWholeFile(five, 4)), HasSubstr("five: 5 bytes, expected at most 4"));
  EXPECT_EQ(readWholeFile(five, 5).value(), "12345");
  EXPECT_THAT(problem(readWholeFile("/dev/zero", 1000, FileKind::pipe_too)), HasSubstr("expected at most 1000"));
}

TEST(WholeFile, ReadsAPipeOnlyWhereOneIsTaken) {
  const Folder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_FALSE(readWholeFile(pipe));  // and does not wait for a writer
  std::jthread writer([&] { write(pipe, "through the pipe"); });
  EXPECT_EQ(readWholeFile(pipe, 100, FileKind::pipe_too).value(), "through the pipe");
}

TEST(WholeFile, APipesWriterMayPause) {
  const Folder folder;
  const std::string pipe = folder.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::string half(100'000, 'h');
  std::jthread writer([&] {
    std::ofstream file(pipe, std::ios::binary);
    for (int i = 0; i < 2; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      file << half << std::flush;
    }
  });
  EXPECT_EQ(readWholeFile(pipe, 1'000'000, FileKind::pipe_too).value(), half + half);
}

TEST(AtomicRename, KeepsOrReplacesWhatHasTheName) {
  const Folder folder;
  const std::string from = write(folder.file("from"), "new");
  const std::string to = write(folder.file("to"), "old");
  EXPECT_EQ(renameAtomically(from, to, ExistingFile::keep), std::errc::file_exists);
  EXPECT_EQ(readWholeFile(to).value(), "old");
  EXPECT_EQ(readWholeFile(from).value(), "new");
  EXPECT_FALSE(renameAtomically(from, to, ExistingFile::replace));
  EXPECT_EQ(readWholeFile(to).value(), "new");
  EXPECT_FALSE(std::filesystem::exists(from));
  EXPECT_FALSE(renameAtomically(to, from, ExistingFile::keep));
  EXPECT_EQ(renameAtomically(folder.file("gone"), to, ExistingFile::keep), std::errc::no_such_file_or_directory);
}

}  // namespace
}  // namespace fyd
