// The order of a recording's life as its disk sees it: nothing is acknowledged before it is synced, a commit's row is
// among what its journal makes whole, and the file gets its name last.
#include <cerrno>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "core/recording/file/recording_place.h"
#include "core/recording/reader/recording.h"
#include "core/recording/recovery/recording_repair.h"
#include "recording_damage.h"
#include "recording_samples.h"
#include "tests/integration/recording/remembering_disk.h"

namespace fyd::recording {
namespace {

using namespace samples;

/// What a reader finds in the file if the power went after these calls and everything not synced was lost.
std::uint64_t rowsIfCutNow(const LoggingDisk& disk, const std::string& file) {
  std::vector<LoggingDisk::Call> safe = disk.calls;
  while (!safe.empty() && !safe.back().sync) safe.pop_back();
  std::vector<std::byte> bytes;
  for (const auto& call : safe) {
    if (call.sync) continue;
    bytes.resize(std::max<std::size_t>(bytes.size(), call.at + call.bytes.size()));
    std::ranges::copy(call.bytes, bytes.begin() + static_cast<std::ptrdiff_t>(call.at));
  }
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  const auto found = Recording::open(file);
  EXPECT_TRUE(found) << (found ? "" : found.error().text());
  return found ? (*found)->info().committed_samples : 0;
}

struct Begun {
  Folder folder;
  std::shared_ptr<LoggingDisk> disk = std::make_shared<LoggingDisk>();
  std::unique_ptr<RecordingWriter> writer = std::move(*createRecording(folder.file(), header(), disk));
};

TEST(RecordingOrder, AfterItsCreationItIsARecordingWhateverHappens) {
  Begun made;
  EXPECT_EQ(rowsIfCutNow(*made.disk, made.folder.file("cut.h5")), 0U);
  EXPECT_TRUE(std::filesystem::exists(partialOf(made.folder.file())));
  EXPECT_FALSE(std::filesystem::exists(made.folder.file()));
}

TEST(RecordingOrder, WhatIsAcknowledgedIsSyncedAlready) {
  Begun made;
  for (std::uint64_t row = 0; row < 600; ++row) {
    ASSERT_TRUE(made.writer->append(plainStep(row)));
    if (row % 250 == 249 || row == 300) {
      if (row == 300) {
        ASSERT_TRUE(made.writer->commit());
      }
      EXPECT_EQ(made.writer->committedSteps(), row + 1);
      EXPECT_EQ(rowsIfCutNow(*made.disk, made.folder.file("cut.h5")), row + 1) << "and its commit row with it";
    }
  }
  EXPECT_EQ(made.writer->committedSteps(), 500U) << "a hundred wait";
  const auto growing = Recording::open(made.folder.file());
  ASSERT_TRUE(growing);
  EXPECT_EQ((*growing)->info().wholeness, Wholeness::growing) << "only its last commit closes it";
}

TEST(RecordingOrder, AClosedOneIsSyncedWithoutAJournalAndHasItsName) {
  Begun made;
  for (std::uint64_t row = 0; row < 300; ++row) ASSERT_TRUE(made.writer->append(plainStep(row)));
  ASSERT_TRUE(made.writer->append(Note{.when = instantAt(1000.2), .text = "said"}));
  const std::size_t before = made.disk->calls.size();
  ASSERT_TRUE(made.writer->close());
  EXPECT_EQ(made.writer->committedSteps(), 300U);
  EXPECT_TRUE(std::filesystem::exists(made.folder.file()));
  EXPECT_FALSE(std::filesystem::exists(partialOf(made.folder.file())));
  EXPECT_GT(made.disk->calls.size(), before);
  EXPECT_TRUE(made.disk->calls.back().sync);
  const auto& cleared = made.disk->calls[made.disk->calls.size() - 2];
  EXPECT_EQ(cleared.at, 0U);
  EXPECT_TRUE(std::ranges::all_of(cleared.bytes, [](std::byte b) { return b == std::byte{0}; }));
  EXPECT_EQ(rowsIfCutNow(*made.disk, made.folder.file("cut.h5")), 300U);
  const auto found = Recording::open(made.folder.file());
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)->info().wholeness, Wholeness::whole);
  EXPECT_EQ((*found)->notes()->size(), 1U);
  // Over is over.
  EXPECT_FALSE(made.writer->append(plainStep(300)));
  EXPECT_FALSE(made.writer->append(Note{.when = instantAt(1000.3), .text = "late"}));
  EXPECT_FALSE(made.writer->append(EncodedPicture{}));
  EXPECT_FALSE(made.writer->append(LinkRow{}));
  EXPECT_FALSE(made.writer->commit());
  EXPECT_FALSE(made.writer->close());
  EXPECT_EQ((*Recording::open(made.folder.file()))->info().samples, 300U);
}

/// The disk refuses from one call on, until it is told to work again.
class RefusingDisk final : public DiskCalls {
 public:
  int write(int file, std::span<const std::byte> bytes, std::uint64_t at) override {
    return refuses ? EIO : DiskCalls::write(file, bytes, at);
  }
  int sync(int) override { return refuses ? EIO : 0; }
  bool refuses = false;
};

TEST(RecordingOrder, AfterAFailedCommitNothingIsAcknowledgedEvenIfTheDiskWorksAgain) {
  const Folder folder;
  const auto disk = std::make_shared<RefusingDisk>();
  auto writer = createRecording(folder.file(), header(), disk);
  ASSERT_TRUE(writer);
  for (std::uint64_t row = 0; row < 260; ++row) ASSERT_TRUE((*writer)->append(plainStep(row)));
  EXPECT_EQ((*writer)->committedSteps(), 250U);
  disk->refuses = true;
  const auto failed = (*writer)->commit();
  ASSERT_FALSE(failed);
  EXPECT_EQ((*writer)->committedSteps(), 250U);
  disk->refuses = false;
  const auto again = (*writer)->commit();
  ASSERT_FALSE(again);
  EXPECT_NE(again.error().text().find("nothing more can be recorded"), std::string::npos) << again.error().text();
  EXPECT_FALSE((*writer)->append(plainStep(260)));
  EXPECT_FALSE((*writer)->close());
  EXPECT_EQ((*writer)->committedSteps(), 250U);
  EXPECT_FALSE(std::filesystem::exists(folder.file()));
  writer->reset();
  const auto found = Recording::open(folder.file());
  ASSERT_TRUE(found) << found.error().text();
  EXPECT_EQ((*found)->info().committed_samples, 250U);
}

TEST(RecordingOrder, ACloseThatFailsAcknowledgesNothingAndLeavesTheNameFree) {
  const Folder folder;
  const auto disk = std::make_shared<RefusingDisk>();
  auto writer = createRecording(folder.file(), header(), disk);
  ASSERT_TRUE(writer);
  for (std::uint64_t row = 0; row < 260; ++row) ASSERT_TRUE((*writer)->append(plainStep(row)));
  disk->refuses = true;
  EXPECT_FALSE((*writer)->close());
  EXPECT_EQ((*writer)->committedSteps(), 250U);
  EXPECT_FALSE(std::filesystem::exists(folder.file()));
}

TEST(RecordingOrder, OneThatIsDroppedIsAsItsLastCommitLeftIt) {
  const Folder folder;
  const auto disk = std::make_shared<LoggingDisk>();
  auto writer = createRecording(folder.file(), header(), disk);
  ASSERT_TRUE(writer);
  for (std::uint64_t row = 0; row < 260; ++row) ASSERT_TRUE((*writer)->append(plainStep(row)));
  const std::size_t before = disk->calls.size();
  writer->reset();
  EXPECT_EQ(disk->calls.size(), before) << "not a byte more";
  const auto left = Recording::open(folder.file());
  ASSERT_TRUE(left);
  EXPECT_EQ((*left)->info().committed_samples, 250U);
  EXPECT_EQ((*left)->info().wholeness, Wholeness::crashed) << "no commit before the last closes it";
}

TEST(RecordingOrder, ARepairThatFindsNoCommitLeavesTheFileAsItIs) {
  Begun made;
  for (std::uint64_t row = 0; row < 300; ++row) ASSERT_TRUE(made.writer->append(plainStep(row)));
  ASSERT_TRUE(made.writer->close());
  loseBytes(made.folder.file(), commitAt(made.folder.file(), 0), 3 * sizeof(CommitRow));
  const std::string before = contentOf(made.folder.file());
  const std::size_t calls = made.disk->calls.size();
  EXPECT_FALSE(finishRecording(made.folder.file(), made.disk));
  EXPECT_EQ(made.disk->calls.size(), calls);
  EXPECT_TRUE(contentOf(made.folder.file()) == before);
}

TEST(RecordingOrder, ItsFileIsLockedWhileItIsRecorded) {
  Begun made;
  const auto repaired = finishRecording(partialOf(made.folder.file()), made.disk);
  ASSERT_FALSE(repaired);
  EXPECT_NE(repaired.error().text().find("it may be recorded at this moment"), std::string::npos)
      << repaired.error().text();
}

TEST(RecordingOrder, StepsThatNeverCameAreCountedInTheNextCommit) {
  Begun made;
  ASSERT_TRUE(made.writer->append(plainStep(0)));
  ASSERT_TRUE(made.writer->append(plainStep(5)));  // four are missing
  ASSERT_TRUE(made.writer->append(plainStep(6)));
  made.writer->countLost(3);
  ASSERT_TRUE(made.writer->close());
  const auto found = Recording::open(made.folder.file());
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)->info().samples, 3U);
  EXPECT_EQ((*found)->info().gaps, 4U);  // the three that the ring lost are among the four that are missing
}

TEST(RecordingOrder, StepsLostAtTheEndAreCountedThoughNoneFollowsThem) {
  Begun made;
  ASSERT_TRUE(made.writer->append(plainStep(0)));
  ASSERT_TRUE(made.writer->append(plainStep(1)));
  made.writer->countLost(7);
  ASSERT_TRUE(made.writer->close());
  const auto found = Recording::open(made.folder.file());
  ASSERT_TRUE(found);
  EXPECT_EQ((*found)->info().samples, 2U);
  EXPECT_EQ((*found)->info().gaps, 7U);
}

}  // namespace
}  // namespace fyd::recording
