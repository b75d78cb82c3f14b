// What stands between HDF5 and a recording's file, asked through HDF5's own calls for drivers; a commit that is larger
// than the journal before it; and a beginning for which there is no memory.
#include <fcntl.h>
#include <hdf5.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/recording/file/recording_driver.h"
#include "core/recording/file/recording_storage.h"
#include "recording_damage.h"
#include "recording_samples.h"
#include "tests/integration/recording/remembering_disk.h"

namespace fyd::recording {
namespace {

/// A file that HDF5 reads through the driver.
class Driven {
 public:
  Driven(const std::string& path, int flags)
      : descriptor_(::open(path.c_str(), flags | O_CLOEXEC)),
        disk_(std::make_shared<JournaledFile>(descriptor_, JournaledFile::Mode::read, false)),
        access_(accessThrough(disk_)),
        file_(H5FDopen(path.c_str(), H5F_ACC_RDONLY, access_.id(), HADDR_UNDEF)) {
    EXPECT_NE(file_, nullptr);
    EXPECT_GE(H5FDset_eoa(file_, H5FD_MEM_DRAW, haddr_t{1} << 40U), 0);
  }
  ~Driven() {
    H5FDclose(file_);
    ::close(descriptor_);
  }
  Driven(const Driven&) = delete;
  Driven& operator=(const Driven&) = delete;

  [[nodiscard]] bool reads(haddr_t at, std::string& out) const {
    return H5FDread(file_, H5FD_MEM_DRAW, H5P_DEFAULT, at, out.size(), out.data()) >= 0;
  }
  [[nodiscard]] H5FD_t* file() const { return file_; }
  [[nodiscard]] JournaledFile& disk() const { return *disk_; }

 private:
  int descriptor_;
  std::shared_ptr<JournaledFile> disk_;
  Handle access_;
  H5FD_t* file_;
};

class RecordingDriverCalls : public testing::Test {
 protected:
  RecordingDriverCalls() {
    std::string content(kJournalBytes, '\0');
    content.append("0123456789");
    samples::write(path, content);
  }

  std::unique_lock<FairMutex> lock = hdf5Lock();
  Folder folder;
  std::string path = folder.file();
};

TEST_F(RecordingDriverCalls, TellFilesApartInOneOrder) {
  const Driven first(path, O_RDONLY), second(path, O_RDONLY);
  EXPECT_LT(H5FDcmp(first.file(), second.file()), 0);
  EXPECT_GT(H5FDcmp(second.file(), first.file()), 0);
  EXPECT_EQ(H5FDcmp(second.file(), second.file()), 0);
}

TEST_F(RecordingDriverCalls, ReadALittleBeyondTheEndAsZerosAndNoFurther) {
  constexpr std::size_t kLittle = 1U << 20U;
  constexpr haddr_t kEnd = kJournalBytes + 10;
  const Driven file(path, O_RDONLY);
  std::string out(10, '?');
  ASSERT_TRUE(file.reads(kEnd - 5, out));
  EXPECT_EQ(out, std::string("56789\0\0\0\0\0", 10));
  out.resize(kLittle);
  EXPECT_TRUE(file.reads(kEnd, out));
  EXPECT_EQ(out, std::string(kLittle, '\0'));
  out.resize(kLittle + 1);
  EXPECT_FALSE(file.reads(kEnd, out)) << "it ends too far away";
  out.resize(1);
  EXPECT_FALSE(file.reads(kEnd + kLittle, out));
  EXPECT_FALSE(file.reads(kEnd + kLittle + 1, out)) << "it begins too far away";
}

TEST_F(RecordingDriverCalls, ReadTheMissingEndAsZerosButNeverMoreThanTheFileCanHold) {
  const Driven file(path, O_RDONLY);
  file.disk().expectLength(1ULL << 39U);
  EXPECT_EQ(H5FDget_eof(file.file(), H5FD_MEM_DEFAULT), 1ULL << 39U);
  std::string out(10, '?');
  EXPECT_TRUE(file.reads(1ULL << 38U, out));
  EXPECT_EQ(out, std::string(10, '\0'));
  out.resize(4U << 20U);
  EXPECT_FALSE(file.reads(1ULL << 38U, out)) << "longer than the file";
  out.resize(1);
  EXPECT_FALSE(file.reads((1ULL << 39U) + (1U << 20U), out));
  file.disk().expectLength(std::numeric_limits<std::uint64_t>::max());
  EXPECT_FALSE(file.reads(1ULL << 38U, out)) << "no file is so long";
}

TEST_F(RecordingDriverCalls, ReadWhatARecorderAddedSinceItWasOpened) {
  const Driven file(path, O_RDONLY);
  std::string longer = samples::contentOf(path);
  longer.append(3U << 20U, 'n').append("end");
  samples::write(path, longer);
  std::string out(3, '?');
  ASSERT_TRUE(file.reads(kJournalBytes + 10 + (3U << 20U), out));
  EXPECT_EQ(out, "end");
}

TEST_F(RecordingDriverCalls, PassOnThatAFileCannotBeRead) {
  const Driven file(path, O_WRONLY);
  std::string out(3, '?');
  EXPECT_FALSE(file.reads(kJournalBytes, out));
}

TEST_F(RecordingDriverCalls, OpenNothingWithoutTheFileThatTheyStandFor) {
  const auto disk = std::make_shared<JournaledFile>(-1, JournaledFile::Mode::read, false);
  const hid_t driver = H5Pget_driver(accessThrough(disk).id());
  const Handle named(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "access");
  ASSERT_GE(H5Pset_driver(named.id(), driver, nullptr), 0);
  EXPECT_LT(H5Fopen(path.c_str(), H5F_ACC_RDONLY, named.id()), 0);
  constexpr std::array<std::byte, 64> kNothing{};
  ASSERT_GE(H5Pset_driver(named.id(), driver, kNothing.data()), 0);
  EXPECT_LT(H5Fopen(path.c_str(), H5F_ACC_RDONLY, named.id()), 0);
}

TEST(JournaledReader, HasNothingToCommit) {
  const Folder folder;
  samples::write(folder.file(), "abc");
  const int descriptor = ::open(folder.file().c_str(), O_RDONLY | O_CLOEXEC);
  const auto disk = std::make_shared<samples::LoggingDisk>();
  JournaledFile reader(descriptor, JournaledFile::Mode::read, false, disk);
  EXPECT_EQ(reader.commit(), 0);
  EXPECT_TRUE(disk->calls.empty());
  ::close(descriptor);
}

TEST(RecordingStorageName, IsStillTheFilesUntilAnotherProgramShowsOtherwise) {
  const Folder folder;
  const auto lock = hdf5Lock();
  const RecordingStorage storage(folder.file(), std::make_shared<DiskCalls>());
  EXPECT_TRUE(storage.isStill(folder.file()));
  EXPECT_FALSE(storage.isStill(folder.file("none")));
  std::ofstream(folder.file("another")) << "another's";
  EXPECT_FALSE(storage.isStill(folder.file("another")));
  std::filesystem::create_symlink("endless", folder.file("endless"));
  EXPECT_TRUE(storage.isStill(folder.file("endless"))) << "the system does not answer: it shows nothing";
  std::filesystem::resize_file(folder.file(), 100);
  EXPECT_FALSE(storage.isStill(folder.file()));
}

TEST(RecordingStorageCommit, LargerThanItsJournalIsAnErrorAndChangesNothing) {
  const Folder folder;
  const auto lock = hdf5Lock();
  constexpr hsize_t kBytes = 2 * kJournalBytes;
  {
    RecordingStorage storage(folder.file(), std::make_shared<DiskCalls>());
    const Handle space(H5Screate_simple(1, &kBytes, nullptr), H5Sclose, "a space");
    const Handle set(
        H5Dcreate2(storage.file(), "/much", H5T_STD_U8LE, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
        "/much");
    const auto write = [&](char value) {
      const std::string values(kBytes, value);
      check(H5Dwrite(set.id(), H5T_STD_U8LE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "/much");
      storage.flush();
      storage.persist();
    };
    write('a');
    std::string words;
    try {
      write('b');
    } catch (const RecordingFailure& failure) {
      words = failure.message.text();
    }
    EXPECT_EQ(words, "the disk: one commit changes more than the journal holds");
  }
  const std::string left = samples::contentOf(folder.file());
  EXPECT_NE(left.find(std::string(kBytes, 'a')), std::string::npos);
  EXPECT_EQ(left.find("bbbb"), std::string::npos);
}

/// Throws when it is to sync.
class ThrowingDisk final : public DiskCalls {
 public:
  int sync(int) override { std::rethrow_exception(thrown); }
  std::exception_ptr thrown;
};

TEST(RecordingBegun, WithoutMemoryIsAnErrorAndLeavesTheNameFree) {
  const Folder folder;
  const auto begunOn = [&](const std::exception_ptr& exception) {
    const auto disk = std::make_shared<ThrowingDisk>();
    disk->thrown = exception;
    return createRecording(folder.file(), samples::header(), disk);
  };
  const auto none = begunOn(std::make_exception_ptr(std::bad_alloc()));
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().text(), folder.file() + ": out of memory");
  const auto vast = begunOn(std::make_exception_ptr(std::length_error("too much")));
  ASSERT_FALSE(vast);
  EXPECT_EQ(vast.error().text(), folder.file() + ": a size in it is beyond all reason");
  auto next = RecordingWriter::create(folder.file(), samples::header());
  ASSERT_TRUE(next) << next.error().text();
  EXPECT_TRUE((*next)->close());
}

}  // namespace
}  // namespace fyd::recording
