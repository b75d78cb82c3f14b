// Files are replaced atomically, regular files only: links, mode, owner, devices and pipes stay.
#include "core/station/profile/replace_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace fyd::station {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class ReplaceFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "fyd-replace-XXXXXX").string();
    folder = ::mkdtemp(pattern.data());
    ::chmod(folder.c_str(), 0777);
  }
  void TearDown() override { fs::remove_all(folder); }

  [[nodiscard]] std::string name(const char* of) const { return (folder / of).string(); }
  static std::string contentOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static struct stat statusOf(const std::string& path) {
    struct stat status {};
    EXPECT_EQ(::lstat(path.c_str(), &status), 0) << path;
    return status;
  }
  static std::string refusalOf(const std::string& path) {
    const auto done = replaceFile(path, "new");
    return done ? "" : done.error().text();
  }

  fs::path folder;
};

TEST_F(ReplaceFile, WhatIsNoFileIsNamedAndStays) {
  ASSERT_EQ(::mkfifo(name("pipe").c_str(), 0600), 0);
  fs::create_directory(name("folder"));
  sockaddr_un address{.sun_family = AF_UNIX, .sun_path = {}};
  std::strncpy(address.sun_path, name("socket").c_str(), sizeof address.sun_path - 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  fs::create_symlink("/dev/null", name("device"));
  fs::create_symlink("pipe", name("to_pipe"));
  fs::create_symlink("circle", name("circle"));
  const struct stat before = statusOf("/dev/null");
  EXPECT_EQ(refusalOf(name("pipe")), name("pipe") + ": is a pipe, not a file");
  EXPECT_EQ(refusalOf(name("to_pipe")), name("to_pipe") + ": is a pipe, not a file");
  EXPECT_EQ(refusalOf(name("folder")), name("folder") + ": is a folder, not a file");
  EXPECT_EQ(refusalOf(name("socket")), name("socket") + ": is a socket, not a file");
  EXPECT_EQ(refusalOf(name("device")), name("device") + ": is a device, not a file");
  EXPECT_EQ(refusalOf(name("circle")), name("circle") + ": its links run in a circle");
  EXPECT_THAT(refusalOf(name("nothing/x")), HasSubstr("nothing/x: cannot be written: No such file"));
  EXPECT_TRUE(fs::is_fifo(name("pipe")));
  EXPECT_TRUE(fs::is_symlink(name("device")));
  EXPECT_EQ(statusOf("/dev/null").st_ino, before.st_ino);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 6);  // and nothing was left beside
  ::close(socket);
}

TEST_F(ReplaceFile, ADeviceNodeIsNotReplaced) {
  if (::mknod(name("node").c_str(), S_IFCHR | 0666, ::makedev(1, 3)) != 0) GTEST_SKIP() << "only root makes devices";
  EXPECT_EQ(refusalOf(name("node")), name("node") + ": is a device, not a file");
  EXPECT_TRUE(S_ISCHR(statusOf(name("node")).st_mode));
}

TEST_F(ReplaceFile, ALinkStaysAndTheFileItLeadsToIsReplaced) {
  fs::create_directory(name("far"));
  fs::create_symlink("far/b", name("a"));
  fs::create_symlink("../c", name("far/b"));  // not there yet
  ASSERT_TRUE(replaceFile(name("a"), "first"));
  ASSERT_TRUE(replaceFile(name("a"), "second"));
  EXPECT_EQ(contentOf(name("c")), "second");
  EXPECT_TRUE(fs::is_symlink(name("a")) && fs::is_symlink(name("far/b")));
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(name("c"))));
}

TEST_F(ReplaceFile, ModeAndOwnerStay) {
  std::ofstream(name("mine")) << "old";
  ASSERT_EQ(::chmod(name("mine").c_str(), 0640), 0);
  ASSERT_TRUE(replaceFile(name("mine"), "new"));
  EXPECT_EQ(statusOf(name("mine")).st_mode & 07777U, 0640U);
  if (::geteuid() != 0) GTEST_SKIP() << "only root gives files away";
  ASSERT_EQ(::chown(name("mine").c_str(), 1234, 1235), 0);
  ASSERT_TRUE(replaceFile(name("mine"), "newer"));
  EXPECT_EQ(contentOf(name("mine")), "newer");
  EXPECT_EQ(statusOf(name("mine")).st_uid, 1234U);
  EXPECT_EQ(statusOf(name("mine")).st_gid, 1235U);
  EXPECT_EQ(statusOf(name("mine")).st_mode & 07777U, 0640U);
}

TEST_F(ReplaceFile, AFileThatCannotKeepItsOwnerOrIsProtectedIsLeft) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root is two users";
  for (const auto& [file, mode] : {std::pair{"shared", 0666U}, {"protected", 0644U}}) {
    std::ofstream(name(file)) << "old";
    ASSERT_EQ(::chmod(name(file).c_str(), mode), 0);
  }
  ASSERT_EQ(::seteuid(65534), 0);
  const std::string shared = refusalOf(name("shared"));
  const std::string locked = refusalOf(name("protected"));
  ASSERT_EQ(::seteuid(0), 0);
  EXPECT_EQ(shared,
            name("shared") + ": belongs to another user (uid 0, gid 0), who would lose it; choose another name");
  EXPECT_EQ(locked, name("protected") + ": cannot be written: Permission denied");
  EXPECT_EQ(contentOf(name("shared")), "old");
  EXPECT_EQ(contentOf(name("protected")), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2);
}

}  // namespace
}  // namespace fyd::station
