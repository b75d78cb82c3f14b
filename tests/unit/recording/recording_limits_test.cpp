// What the recorder meets at its limits: descriptors that cannot be read or written, journals that were forged, pictures
// of other kinds, values that are too large, and questions before anything began.
#include <fcntl.h>
#include <hdf5.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "core/recording/file/picture_decode.h"
#include "core/recording/file/picture_png.h"
#include "core/recording/file/quick_deflate.h"
#include "core/recording/file/recording_disk.h"
#include "core/recording/file/recording_driver.h"
#include "core/recording/file/recording_hdf5.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/file/recording_storage.h"
#include "core/recording/writer/disk_space.h"
#include "core/recording/writer/picture_history.h"
#include "core/recording/writer/picture_queue.h"
#include "core/recording/writer/recorder.h"
#include "core/recording/writer/step_history.h"
#include "recording_damage.h"
#include "recording_samples.h"
#include "tests/files_of_at_most.h"
#include "tests/reference_crc.h"

namespace fyd::recording {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

class OpenFile {
 public:
  OpenFile(const std::string& path, int flags) : number(::open(path.c_str(), flags | O_CLOEXEC, 0644)) {}
  ~OpenFile() { ::close(number); }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  const int number;
};

std::vector<std::byte> someBytes(std::size_t count) { return std::vector<std::byte>(count, std::byte{7}); }

// --- the disk's calls

TEST(DiskCalls, WhatTheSystemRefusesIsTheErrnoThatIsGiven) {
  const samples::Folder folder;
  samples::write(folder.file(), "abc");
  const OpenFile only_read(folder.file(), O_RDONLY);
  DiskCalls disk;
  EXPECT_EQ(disk.write(only_read.number, someBytes(1), 0), EBADF);
  EXPECT_EQ(disk.write(only_read.number, {}, 0), 0) << "nothing is asked of it";
  EXPECT_EQ(disk.resize(only_read.number, 10), EINVAL);
  EXPECT_EQ(disk.sync(-1), EBADF);
}

TEST(JournaledFileLimits, AFileThatCannotBeReadHasNoJournalAndGivesItsError) {
  const samples::Folder folder;
  samples::write(folder.file(), "abc");
  const OpenFile only_written(folder.file(), O_WRONLY);
  const JournaledFile unreadable(only_written.number, JournaledFile::Mode::read, true);
  EXPECT_FALSE(unreadable.foundJournal());
  std::vector<std::byte> out(3);
  EXPECT_EQ(unreadable.read(0, out), EBADF);
  const JournaledFile none(-1, JournaledFile::Mode::read, true);
  EXPECT_EQ(none.size(), 0U);
  EXPECT_EQ(none.sizeNow(), 0U);
  EXPECT_EQ(none.diskBytes(), 0U);
}

/// A journal as manual/recording-format.md describes it, with a sound checksum, of these pieces' bytes.
std::string journalOf(const std::string& pieces, std::uint64_t bytes) {
  std::string body = pieces;
  for (char& c : body) c = static_cast<char>(static_cast<unsigned char>(c) ^ 0xA5U);
  const std::uint64_t sequence = 3;
  std::string numbers(16, '\0');
  std::memcpy(numbers.data(), &sequence, 8);
  std::memcpy(numbers.data() + 8, &bytes, 8);
  const std::string proven = numbers + body;
  const std::uint32_t crc = referenceCrc32c(std::as_bytes(std::span(proven)));
  std::string out = std::string("FYD journal 1\r\n\0", 16) + numbers;
  out.append(reinterpret_cast<const char*>(&crc), 4);
  out.append(4, '\0');
  return out + body;
}

std::string pieceOf(std::uint64_t at, std::uint64_t length, const std::string& bytes) {
  std::string out(16, '\0');
  std::memcpy(out.data(), &at, 8);
  std::memcpy(out.data() + 8, &length, 8);
  return out + bytes;
}

class ForgedJournal : public testing::Test {
 protected:
  static constexpr std::uint64_t kAt = kJournalBytes + 2;

  /// What a reader sees of ten bytes "0123456789" behind the journal.
  std::string readWith(const std::string& journal) {
    std::string content(kJournalBytes, '\0');
    content.replace(0, journal.size(), journal);
    samples::write(folder.file(), content + "0123456789");
    const OpenFile opened(folder.file(), O_RDWR);
    const JournaledFile file(opened.number, JournaledFile::Mode::read, true);
    found = file.foundJournal();
    std::string out(10, '?');
    EXPECT_EQ(file.read(kJournalBytes, std::as_writable_bytes(std::span(out))), 0);
    return out;
  }
  samples::Folder folder;
  bool found = false;
};

TEST_F(ForgedJournal, ASoundOneIsReadAsIfItWereApplied) {
  const std::string pieces = pieceOf(kAt, 2, "ab") + pieceOf(kAt + 7, 3, "xyz");  // the second beyond the end
  EXPECT_EQ(readWith(journalOf(pieces, pieces.size())), "01ab45678x");
  EXPECT_TRUE(found);
}

TEST_F(ForgedJournal, OfPiecesThatReachBeyondItOrTheFileThoseBeforeAreTaken) {
  const std::string good = pieceOf(kAt, 2, "ab");
  const std::string too_long = good + pieceOf(kAt, 100, "c");
  EXPECT_EQ(readWith(journalOf(too_long, too_long.size())), "01ab456789");
  const std::string far = good + pieceOf(kJournalBytes + 11, 1, "c");
  EXPECT_EQ(readWith(journalOf(far, far.size())), "01ab456789");
  const std::string half_a_head = good + "1234567";
  EXPECT_EQ(readWith(journalOf(half_a_head, half_a_head.size())), "01ab456789");
}

TEST_F(ForgedJournal, OneThatSaysToBeLongerThanItsRoomIsNone) {
  const std::string pieces = pieceOf(kAt, 2, "ab");
  EXPECT_EQ(readWith(journalOf(pieces, kJournalBytes)), "0123456789");
  EXPECT_FALSE(found);
}

TEST_F(ForgedJournal, ADiskThatRefusesItsPlacesLeavesItToBeAppliedAgain) {
  class Refusing final : public DiskCalls {
   public:
    int write(int, std::span<const std::byte>, std::uint64_t) override { return EIO; }
  };
  const std::string pieces = pieceOf(kAt, 2, "ab");
  EXPECT_EQ(readWith(journalOf(pieces, pieces.size())), "01ab456789");
  const OpenFile opened(folder.file(), O_RDWR);
  JournaledFile refused(opened.number, JournaledFile::Mode::write, true, std::make_shared<Refusing>());
  EXPECT_EQ(refused.applyJournal(), EIO);
  EXPECT_EQ(refused.commit(), EIO) << "and nothing is committed from then on";
  const JournaledFile again(opened.number, JournaledFile::Mode::read, true);
  EXPECT_TRUE(again.foundJournal());
}

TEST(RecordingDriver, KnowsItsOwnFilesOnly) {
  const samples::Folder folder;
  const auto lock = hdf5Lock();
  const hid_t file = H5Fcreate(folder.file().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  EXPECT_THROW((void)diskBytes(file), RecordingFailure);
  H5Fclose(file);
}

TEST(RecordingStorage, ClosesItsFileUnderTheLockOfHdf5) {
  const samples::Folder folder;
  auto lock = hdf5Lock();
  auto storage = std::make_unique<RecordingStorage>(folder.file(), std::make_shared<DiskCalls>());
  std::atomic<bool> closed = false;
  std::thread other([&] {
    storage.reset();
    closed = true;
  });
  std::this_thread::sleep_for(200ms);
  EXPECT_FALSE(closed) << "this thread may be within HDF5";
  lock.unlock();
  other.join();
  EXPECT_TRUE(closed);
}

TEST(RecordingPlace, AFolderThatIsNotThereCannotBeSynced) {
  EXPECT_THAT(syncFolder("/nowhere/at/all/a.h5").error().text(), HasSubstr("No such file"));
  EXPECT_FALSE(lockAsRecorder(-1));
  EXPECT_FALSE(recorderRuns(-1));
}

// --- pictures

using Jpeg = std::vector<std::uint8_t>;

/// SOI and these bytes, then enough zeros to be read to their end.
std::optional<cv::Size> sizeOfJpeg(Jpeg segments) {
  segments.insert(segments.begin(), {0xFF, 0xD8});
  segments.resize(segments.size() + 12);
  return pictureSize(segments);
}

TEST(JpegHeaders, AreFollowedMarkerByMarkerUpToABaselineFrame) {
  const Jpeg frame{0xFF, 0xC0, 0, 17, 8, 0, 30, 0, 40};  // SOF0, length, depth, height 30, width 40
  const auto behind = [&](Jpeg before) {
    before.insert(before.end(), frame.begin(), frame.end());
    return sizeOfJpeg(before);
  };
  EXPECT_EQ(behind({}), cv::Size(40, 30));
  EXPECT_EQ(behind({0xFF, 0xE0, 0, 4, 1, 2}), cv::Size(40, 30)) << "APP0";
  EXPECT_EQ(behind({0xFF, 0xC4, 0, 3, 1}), cv::Size(40, 30)) << "a Huffman table is no frame";
  EXPECT_EQ(behind({0xFF, 0xCC, 0, 3, 1}), cv::Size(40, 30)) << "nor is one of arithmetic coding";
  EXPECT_EQ(behind({0xFF, 0xFF}), cv::Size(40, 30)) << "filling";
  EXPECT_FALSE(behind({0x00})) << "no marker";
  EXPECT_FALSE(behind({0xFF, 0xC2, 0, 3, 1})) << "progressive";
  EXPECT_FALSE(behind({0xFF, 0xCF, 0, 3, 1})) << "the last kind of frame";
  EXPECT_FALSE(behind({0xFF, 0xDA, 0, 3, 1})) << "a scan before a frame";
  for (const std::uint8_t kind : Jpeg{0x01, 0xD0, 0xD3, 0xD7, 0x02, 0xBF, 0xF0})
    EXPECT_FALSE(behind({0xFF, kind, 0, 3, 1})) << "no length follows this marker: " << int{kind};
  EXPECT_FALSE(behind({0xFF, 0xFE, 0, 1, 1})) << "a length that does not count itself";
  EXPECT_FALSE(sizeOfJpeg({0xFF, 0xC0, 0, 17, 8, 0, 0, 0, 40})) << "no rows";
  EXPECT_FALSE(sizeOfJpeg({0xFF, 0xC0, 0, 17, 8, 0, 30, 0, 0})) << "no columns";
  EXPECT_FALSE(pictureSize(Jpeg{0xFF, 0xD8})) << "nothing follows";
}

TEST(PngHeaders, MustSayASizeThatIsOne) {
  Jpeg png = encodePng(cv::Mat(30, 40, CV_8UC1, cv::Scalar(7)));
  EXPECT_EQ(pictureSize(png), cv::Size(40, 30));
  EXPECT_FALSE(pictureSize(std::span(png).first(23))) << "cut in its size";
  EXPECT_FALSE(pictureSize(std::span(png).first(14))) << "cut in its head";
  Jpeg other = png;
  other[12] = 'X';
  EXPECT_FALSE(pictureSize(other)) << "another chunk is first";
  for (const std::size_t at : {16U, 20U}) {  // the highest byte of width and height
    other = png;
    other[at] = 1;
    EXPECT_FALSE(pictureSize(other)) << "more than 2^20";
  }
  png.resize(40);  // head and size are right, and then nothing
  EXPECT_THROW((void)decodePicture(png, "the picture"), RecordingFailure);
}

TEST(Pictures, OfAKindThatJpegDoesNotKnowOrTooLargeAreLeftOut) {
  EXPECT_TRUE(encodePicture({.picture = cv::Mat(8, 8, CV_64FC2)}, true).whole.empty());
  cv::Mat vast(4097, 8192, CV_8UC1);  // one row more than 2^25 pixels
  EXPECT_TRUE(encodePicture({.picture = vast}, true).whole.empty());
}

TEST(PictureHistory, IsReadOnlyWhileSomebodyReads) {
  PictureHistory history;
  EXPECT_FALSE(history.read(instantAt(1))) << "nobody said from where";
  const cv::Mat picture(4, 4, CV_8UC1, cv::Scalar(1));
  for (int i = 1; i <= 3; ++i) history.add({.picture = picture, .taken = instantAt(i), .number = std::uint64_t(i)});
  history.readFrom(instantAt(2));
  history.trim(instantAt(4));
  for (const std::uint64_t number : {2U, 3U}) {
    const auto kept = history.read(instantAt(9));
    ASSERT_TRUE(kept) << number << " is still to be read";
    EXPECT_EQ(kept->number, number);
  }
  EXPECT_EQ(history.lost(), 0U);
  EXPECT_FALSE(history.read(instantAt(9)));
  history.stopReading();
  history.trim(instantAt(4));
  history.readFrom(instantAt(0));
  EXPECT_FALSE(history.read(instantAt(9))) << "they were old, and read";
  history.add({.picture = picture, .taken = instantAt(5), .number = 5});
  EXPECT_EQ(history.read(instantAt(9))->number, 5U);
}

TEST(PictureQueue, PicturesThatCameLateAreReadBeforeTheyAreDropped) {
  PictureQueue queue;
  queue.history().readFrom(instantAt(1));
  queue.offer({.picture = cv::Mat(4, 4, CV_8UC1, cv::Scalar(1)), .taken = instantAt(2), .number = 7});
  queue.take(instantAt(3));  // nothing is kept from before, and the camera is slower than the steps
  const auto late = queue.history().read(instantAt(3));
  ASSERT_TRUE(late);
  EXPECT_EQ(late->number, 7U);
  queue.take(instantAt(3));
  queue.history().readFrom(instantAt(0));
  EXPECT_FALSE(queue.history().read(instantAt(3))) << "read, and old";
}

TEST(PictureQueue, KeepsTheNewestWhenNobodyTakesThemAndCountsTheOthers) {
  PictureQueue queue;
  const cv::Mat picture(1000, 1000, CV_8UC1, cv::Scalar(1));  // 1 MB
  constexpr std::uint64_t kMany = 100;
  const auto offer = [&] {
    for (std::uint64_t i = 1; i <= kMany; ++i)
      queue.offer({.picture = picture, .taken = instantAt(static_cast<double>(i)), .number = i});
  };
  offer();
  queue.take(instantAt(0));
  EXPECT_EQ(queue.history().lost(), 0U) << "nobody reads";
  queue.history().readFrom(instantAt(kMany + 1));
  offer();
  queue.take(instantAt(0));
  EXPECT_EQ(queue.history().lost(), kMany - PictureHistory::kMost_bytes / 1'000'000);
  queue.history().readFrom(instantAt(0));
  std::vector<std::uint64_t> numbers;
  while (const auto held = queue.history().read(instantAt(2 * kMany))) numbers.push_back(held->number);
  ASSERT_FALSE(numbers.empty());
  EXPECT_LT(numbers.size(), kMany);
  EXPECT_EQ(numbers.back(), kMany);
  EXPECT_EQ(numbers.front(), kMany + 1 - numbers.size()) << "none in between is missing";
}

// --- steps and space

TEST(StepHistory, WithoutAReaderHasNothingToRead) {
  StepHistory history;
  StepRecord record;
  EXPECT_FALSE(history.read(record));
  EXPECT_EQ(history.unread(), 0U);
  EXPECT_FALSE(history.start());
  history.readFromStart();
  EXPECT_FALSE(history.read(record)) << "there is no step yet";
  EXPECT_EQ(packedSize({}), 0U);
}

TEST(DiskSpace, IsNoMoreThanAFileMayGrow) {
  const FilesOfAtMost small(5'000);
  const auto left = freeBytes("a name without a folder", 2'000);
  const auto none = freeBytes("a name without a folder", 6'000);
  ASSERT_TRUE(left && none);
  EXPECT_EQ(*left, 3'000U);
  EXPECT_EQ(*none, 0U);
}

TEST(DiskSpace, OfAFileThatShrinksOrAClockThatStandsThereIsNoGrowth) {
  GrowthRate shrinks;
  shrinks.observe(instantAt(1), 100);
  shrinks.observe(instantAt(2), 50);
  EXPECT_EQ(shrinks.bytes_per_s(), 0.0);
  GrowthRate stands;
  stands.observe(instantAt(1), 100);
  stands.observe(instantAt(1), 200);
  EXPECT_EQ(stands.bytes_per_s(), 0.0);
}

/// Room in the address space that is never touched.
class VastRoom {
 public:
  explicit VastRoom(std::size_t bytes)
      : bytes_(bytes), at_(::mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0)) {}
  ~VastRoom() { ::munmap(at_, bytes_); }
  VastRoom(const VastRoom&) = delete;
  VastRoom& operator=(const VastRoom&) = delete;
  [[nodiscard]] std::span<std::byte> span() const { return {static_cast<std::byte*>(at_), bytes_}; }

 private:
  std::size_t bytes_;
  void* at_;
};

TEST(QuickDeflate, MoreThanFourGigabytesAtOnceAreRefusedUntouched) {
  const VastRoom vast((std::size_t{1} << 32U) + 1);
  std::vector<std::byte> packed;
  EXPECT_THAT(quickDeflate(vast.span(), packed).error().text(), HasSubstr("4294967297 bytes at once"));
  EXPECT_TRUE(packed.empty());
  EXPECT_THAT(quickInflate(someBytes(1), vast.span()).error().text(), HasSubstr("4294967297 bytes at once"));
  EXPECT_FALSE(quickInflate(vast.span(), packed));
}

// --- the recorder before its thread

TEST(RecorderThatDoesNotRun, SaysSo) {
  Recorder recorder({}, {}, {}, {}, {});
  EXPECT_THAT(recorder.begin({.path = "a.h5"}).error().text(), HasSubstr("a.h5: the recorder is not running"));
  EXPECT_THAT(recorder.end().error().text(), HasSubstr("the recorder is not running"));
  EXPECT_THAT(recorder.note(NoteKind::bookmark, "here").error().text(), HasSubstr("here: not kept"));
  recorder.shutDown();
  recorder.start();
  recorder.start();  // once is enough
  EXPECT_THAT(recorder.end().error().text(), HasSubstr("nothing is being recorded"));
  recorder.shutDown();
  recorder.shutDown();
}

}  // namespace
}  // namespace fyd::recording
