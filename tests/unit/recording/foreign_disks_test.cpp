// Folders on other file systems than the tester's: a network share, one without locks, one that cannot sync a folder;
// and other programs that come in between. What the system says of a folder or a file is replaced here; the folder
// itself is an ordinary one.
#include <fcntl.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/recording/file/export_file.h"
#include "core/recording/file/export_part.h"
#include "core/recording/file/recording_place.h"
#include "recording_damage.h"
#include "recording_samples.h"
#include "refusal.h"

namespace fyd::recording {
namespace {

/// What the calls below say; 0: what the system says.
struct SystemSays {
  std::atomic<std::uint32_t> file_system{0};  ///< its magic number
  std::atomic<int> no_answer{0};              ///< an errno, as the next: to the question for its file system
  std::atomic<int> no_lock{0};
  std::atomic<int> no_sync{0};
  std::function<void()> before_lock;      ///< what another program does just then
  std::atomic<bool> comes_before{false};  ///< … the next time; also other threads lock files
};
SystemSays system_says;

/// Fails with `error`, or calls the system.
template <class... Arguments>
int failOrCall(int error, long call, Arguments... arguments) {
  if (error == 0) return static_cast<int>(::syscall(call, arguments...));
  errno = error;
  return -1;
}

}  // namespace
}  // namespace fyd::recording

// In place of the C library's, for this program alone.
extern "C" int statfs(const char* path, struct statfs* out) noexcept {
  const int result = fyd::recording::failOrCall(fyd::recording::system_says.no_answer, SYS_statfs, path, out);
  if (const std::uint32_t magic = fyd::recording::system_says.file_system; result == 0 && magic != 0)
    out->f_type = static_cast<decltype(out->f_type)>(magic);
  return result;
}
extern "C" int flock(int file, int how) noexcept {
  if (fyd::recording::system_says.comes_before.exchange(false)) fyd::recording::system_says.before_lock();
  return fyd::recording::failOrCall(fyd::recording::system_says.no_lock, SYS_flock, file, how);
}
extern "C" int fcntl(int file, int what, ...) {  // NOLINT(cert-dcl50-cpp): as the C library declares it
  va_list arguments;
  va_start(arguments, what);
  void* argument = va_arg(arguments, void*);
  va_end(arguments);
  const int error = what == F_OFD_SETLK ? fyd::recording::system_says.no_lock.load() : 0;
  return fyd::recording::failOrCall(error, SYS_fcntl, file, what, argument);
}
extern "C" int fsync(int file) {
  return fyd::recording::failOrCall(fyd::recording::system_says.no_sync, SYS_fsync, file);
}

namespace fyd::recording {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

class ForeignDisk : public testing::Test {
 protected:
  ~ForeignDisk() override {
    system_says.file_system = 0;
    system_says.no_answer = 0;
    system_says.no_lock = 0;
    system_says.no_sync = 0;
    system_says.comes_before = false;
  }

  Folder folder;
};

TEST_F(ForeignDisk, OnANetworkNoRecordingBeginsAndItsKindIsNamed) {
  // As statfs(2) lists them.
  for (const auto& [magic, name] : {std::pair{0x6969U, "NFS"},
                                    {0xFF534D42U, "CIFS"},
                                    {0x00C36400U, "Ceph"},
                                    {0x01021997U, "9P"},
                                    {0x65735546U, "FUSE"}}) {
    system_says.file_system = magic;
    const auto writer = RecordingWriter::create(folder.file(), samples::header());
    ASSERT_FALSE(writer) << name;
    EXPECT_THAT(writer.error().text(), HasSubstr(folder.path() + ": lies on " + name + ";"));
    EXPECT_THAT(namesIn(folder.path()), IsEmpty());
  }
  system_says.file_system = 0xEF53;  // ext4
  auto writer = RecordingWriter::create(folder.file(), samples::header());
  ASSERT_TRUE(writer) << writer.error().text();
  EXPECT_TRUE((*writer)->close());
}

TEST_F(ForeignDisk, AFolderThatDoesNotTellItsKindIsRefusedWithTheReason) {
  system_says.no_answer = EIO;
  const auto writer = RecordingWriter::create(folder.file(), samples::header());
  ASSERT_FALSE(writer);
  EXPECT_EQ(writer.error().text(), folder.path() + ": the folder cannot be used: Input/output error");
  EXPECT_THAT(namesIn(folder.path()), IsEmpty());
}

TEST_F(ForeignDisk, AFolderThatCannotBeSyncedHoldsNamesWithoutItOneThatFailsIsAnError) {
  system_says.no_sync = EINVAL;
  auto writer = RecordingWriter::create(folder.file(), samples::header());
  ASSERT_TRUE(writer) << writer.error().text();
  for (std::uint64_t row = 0; row < 10; ++row) ASSERT_TRUE((*writer)->append(samples::plainStep(row)));
  system_says.no_sync = EIO;
  const auto closed = (*writer)->close();
  ASSERT_FALSE(closed) << "its name may be gone after a power cut";
  EXPECT_THAT(closed.error().text(), HasSubstr(folder.path() + ": Input/output error"));
  const auto begun = RecordingWriter::create(folder.file("b.h5"), samples::header());
  ASSERT_FALSE(begun);
  EXPECT_THAT(begun.error().text(), HasSubstr(folder.path() + ": Input/output error"));
  const auto recording = Recording::open(folder.file());
  ASSERT_TRUE(recording) << recording.error().text();
  EXPECT_EQ((*recording)->info().committed_samples, 10U);
}

TEST_F(ForeignDisk, ARecordingWhoseFolderCannotBeSyncedLeavesItsNameFree) {
  system_says.no_sync = EIO;
  const auto refused = RecordingWriter::create(folder.file(), samples::header());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().text(), folder.path() + ": Input/output error");
  EXPECT_FALSE(std::filesystem::exists(partialOf(folder.file())));
  EXPECT_THAT(namesIn(folder.path()), IsEmpty());
  system_says.no_sync = 0;
  samples::record(folder.file(), 10);
  const auto recording = Recording::open(folder.file());
  ASSERT_TRUE(recording) << recording.error().text();
  EXPECT_EQ((*recording)->info().committed_samples, 10U);
}

TEST_F(ForeignDisk, WithoutLocksNoRecordingBeginsAndItsNameStaysFree) {
  system_says.no_lock = ENOLCK;
  for (int attempt = 0; attempt < 2; ++attempt) {
    const auto refused = RecordingWriter::create(folder.file(), samples::header());
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().text(), HasSubstr("its lock cannot be had"));
    EXPECT_THAT(refused.error().text(), HasSubstr("No locks available"));
    EXPECT_THAT(namesIn(folder.path()), IsEmpty());
  }
}

TEST_F(ForeignDisk, AnExportThatCannotBeSyncedReplacesNothing) {
  samples::write(folder.file("a.csv"), "mine");
  {
    auto file = ExportFile::create(folder.file("a.csv"), true);
    ASSERT_TRUE(file && file->write("new"));
    system_says.no_sync = EIO;
    const auto done = file->commit();
    ASSERT_FALSE(done);
    EXPECT_THAT(done.error().text(), HasSubstr("a.csv: writing failed: Input/output error; the file stays as it was"));
  }
  EXPECT_EQ(samples::contentOf(folder.file("a.csv")), "mine");
  EXPECT_THAT(namesIn(folder.path()), ElementsAre("a.csv"));
}

TEST_F(ForeignDisk, WithoutLocksExportsAreMadeAndNothingIsTakenForALeftover) {
  samples::write(folder.file(".b.fyd-part-a1B2c3.csv"), "half of it");
  system_says.no_lock = ENOLCK;
  auto file = ExportFile::create(folder.file("a.csv"), false);
  ASSERT_TRUE(file) << file.error().text();
  ASSERT_TRUE(file->write("whole") && file->commit());
  EXPECT_EQ(samples::contentOf(folder.file("a.csv")), "whole");
  EXPECT_THAT(namesIn(folder.path()), SizeIs(2)) << "the other may be somebody's who writes it now";
  system_says.no_lock = 0;
  EXPECT_EQ(removeExportLeftovers(folder.path()), 1U);
}

TEST_F(ForeignDisk, AProgramThatTakesEveryPartFileAwayEndsTheExport) {
  system_says.no_lock = EWOULDBLOCK;  // it holds each one's lock before its maker has it
  const auto part = makeExportPart(folder.file("a.csv"));
  ASSERT_FALSE(part);
  EXPECT_THAT(part.error().text(), HasSubstr("a.csv: cannot be written: another program takes its part files away"));
}

TEST_F(ForeignDisk, APartFileThatIsTakenForALeftoverWhileItIsMadeIsMadeAgain) {
  system_says.before_lock = [&] {
    for (const auto& each : std::filesystem::directory_iterator(folder.path())) std::filesystem::remove(each.path());
  };
  system_says.comes_before = true;
  auto file = ExportFile::create(folder.file("a.csv"), false);
  ASSERT_TRUE(file) << file.error().text();
  EXPECT_FALSE(system_says.comes_before) << "the other program came";
  EXPECT_TRUE(std::filesystem::exists(file->temporary())) << "the name that is written to is a file that is locked";
  ASSERT_TRUE(file->write("whole") && file->commit());
  EXPECT_EQ(samples::contentOf(folder.file("a.csv")), "whole");
  EXPECT_THAT(namesIn(folder.path()), ElementsAre("a.csv"));
}

TEST_F(ForeignDisk, WhatTookALeftoversNameInBetweenIsNotRemoved) {
  const std::string left = folder.file(".b.fyd-part-a1B2c3.csv");
  samples::write(left, "half of it");
  system_says.before_lock = [&] { std::filesystem::remove(left); };
  system_says.comes_before = true;
  EXPECT_EQ(removeExportLeftovers(folder.path()), 0U) << "it is gone already";
  samples::write(left, "half of it");
  system_says.before_lock = [&] {
    std::filesystem::remove(left);
    samples::write(left, "somebody else's");
  };
  system_says.comes_before = true;
  EXPECT_EQ(removeExportLeftovers(folder.path()), 0U);
  EXPECT_EQ(samples::contentOf(left), "somebody else's");
}

}  // namespace
}  // namespace fyd::recording
