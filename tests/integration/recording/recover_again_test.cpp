// `recover` is killed or interrupted by a power cut: a second run completes it, and other programs open the file.
#include <map>

#include <gtest/gtest.h>

#include "core/recording/file/recording_place.h"
#include "core/recording/recovery/recording_repair.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"
#include "remembering_disk.h"
#include "tests/unit/recording/recording_damage.h"
#include "tests/unit/recording/recording_samples.h"

namespace fyd::recording {
namespace {

using namespace samples;

constexpr std::uint64_t kRows = 1300;
constexpr std::uint64_t kCommitted = 1250;

class RecoverAgain : public testing::Test {
 protected:
  void SetUp() override {
    {
      auto writer = RecordingWriter::create(file, header());
      ASSERT_TRUE(writer);
      for (std::uint64_t row = 0; row < kRows; ++row) ASSERT_TRUE((*writer)->append(plainStep(row)));
    }  // as its recorder's end leaves it
    const std::string content = contentOf(partialOf(file));
    for (const char c : content) left.push_back(static_cast<std::byte>(c));
    const auto finished = finishRecording(partialOf(file), disk);
    ASSERT_TRUE(finished) << finished.error().text();
    ASSERT_GT(disk->calls.size(), 10U);
    std::filesystem::remove(partialOf(file));
  }

  void put(const std::string& name, const std::vector<std::byte>& bytes) const {
    write(name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }

  void expectMadeWhole(std::size_t end) const {
    const auto outcome = recover(file);
    ASSERT_TRUE(outcome) << outcome.error().text();
    EXPECT_EQ(outcome->result, RecoverResult::whole) << outcome->first_damage.text();
    EXPECT_TRUE(othersOpen(file)) << "after call " << end << " of " << disk->calls.size();
    const auto recording = Recording::open(file);
    ASSERT_TRUE(recording);
    EXPECT_EQ((*recording)->info().wholeness, Wholeness::whole);
    EXPECT_EQ((*recording)->info().committed_samples, kCommitted);
    EXPECT_TRUE(sameRecord(*(*recording)->step(kCommitted - 1), plainStep(kCommitted - 1)));
    EXPECT_TRUE(verify(file)->intact());
  }

  /// The file when the process was killed at call `end`: all that was asked of the disk before, nothing after.
  [[nodiscard]] std::vector<std::byte> afterKill(std::size_t end) const {
    std::vector<LoggingDisk::Call> calls(disk->calls.begin(), disk->calls.begin() + static_cast<long>(end));
    calls.push_back({.sync = true});
    calls.push_back({.sync = true});
    std::mt19937 unused(1);
    return diskAfterCut(calls, calls.size(), 512, unused, left);
  }

  Folder folder;
  std::string file = folder.file();
  std::vector<std::byte> left;
  std::shared_ptr<LoggingDisk> disk = std::make_shared<LoggingDisk>();
};

TEST_F(RecoverAgain, AfterAKillAtAnyCall) {
  for (std::size_t end = 0; end <= disk->calls.size(); ++end) {
    put(partialOf(file), afterKill(end));
    expectMadeWhole(end);
    std::filesystem::remove(file);
    ASSERT_FALSE(HasFailure()) << "killed at call " << end;
  }
}

TEST_F(RecoverAgain, AfterAPowerCutAtAnyCall) {
  std::mt19937 random(8);
  for (const std::size_t sector_bytes : {512U, 4096U}) {
    for (std::size_t end = 0; end <= disk->calls.size(); ++end) {
      put(partialOf(file), diskAfterCut(disk->calls, end, sector_bytes, random, left));
      expectMadeWhole(end);
      std::filesystem::remove(file);
      ASSERT_FALSE(HasFailure()) << sector_bytes << ": cut at call " << end;
    }
  }
}

TEST_F(RecoverAgain, AFileWhoseJournalWaitsIsNotCalledWholeUnderAnyName) {
  // The closing journal is written and synced, its places are not, and somebody gave the file its name.
  std::size_t journal = disk->calls.size();
  while (disk->calls[journal - 1].sync || disk->calls[journal - 1].at != 0 ||
         disk->calls[journal - 1].bytes.size() < 100)
    --journal;
  put(file, afterKill(journal));
  EXPECT_FALSE(othersOpen(file));
  const auto recording = Recording::open(file);
  ASSERT_TRUE(recording) << recording.error().text();
  EXPECT_EQ((*recording)->info().committed_samples, kCommitted);
  EXPECT_EQ((*recording)->info().wholeness, Wholeness::crashed);
  EXPECT_EQ(verify(file)->wholeness, Wholeness::crashed);
  expectMadeWhole(journal);
}

TEST_F(RecoverAgain, AfterAKillBetweenItsTwoNames) {
  put(file, afterKill(disk->calls.size()));
  damageChunk(file, "/telemetry", 2);
  ASSERT_EQ(recover(file)->result, RecoverResult::part_lost);
  std::filesystem::rename(file, folder.file("a.h5.recovered"));  // FILE.damaged has its name, the copy not yet
  const auto again = recover(file);
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again->result, RecoverResult::part_lost);
  EXPECT_EQ(again->steps, kCommitted - 250);
  EXPECT_EQ(again->lost_steps, 250U);
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_FALSE(recover(folder.file("other.h5")));
}

TEST_F(RecoverAgain, ACopyThatLacksSomethingIsNotCalledWholeTheNextTime) {
  put(file, afterKill(disk->calls.size()));
  damageChunk(file, "/telemetry", 2);
  const auto first = recover(file);
  ASSERT_TRUE(first) << first.error().text();
  ASSERT_EQ(first->result, RecoverResult::part_lost);
  const auto again = recover(file);
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again->result, RecoverResult::part_lost);
  EXPECT_EQ(again->steps, first->steps);
  EXPECT_EQ(again->lost_steps, first->lost_steps);
  EXPECT_EQ(again->missing, first->missing);
  EXPECT_EQ(again->file, file);
  EXPECT_EQ(again->kept, first->kept);
  EXPECT_FALSE(std::filesystem::exists(first->kept + "-2")) << "nothing was copied again";
}

TEST_F(RecoverAgain, OfManyEarlierLossesEachIsNamedOnceAtItsPlace) {
  RecordingHeader with_losses = header();
  for (std::uint64_t row = kRows; row-- > 0;)  // in any order
    with_losses.missing.push_back({"/telemetry", row, 1, fmt::format("before {}", row)});
  {
    auto writer = RecordingWriter::create(file, with_losses);
    ASSERT_TRUE(writer);
    for (std::uint64_t row = 0; row < kRows; ++row) ASSERT_TRUE((*writer)->append(plainStep(row)));
    ASSERT_TRUE((*writer)->close());
  }
  damageChunk(file, "/telemetry", 2);
  const auto outcome = recover(file);
  ASSERT_TRUE(outcome) << outcome.error().text();
  EXPECT_EQ(outcome->lost_steps, 250U);
  std::map<std::string, std::vector<std::uint64_t>> places;
  for (const MissingRows& rows : outcome->missing)
    if (rows.why.starts_with("before ")) places[rows.why].push_back(rows.first);
  for (std::uint64_t row = 0; row < kRows; ++row) {
    const std::uint64_t now = row < 500 ? row : row < 750 ? 500 : row - 250;
    EXPECT_EQ(places[fmt::format("before {}", row)], std::vector{now}) << row;
  }
}

TEST_F(RecoverAgain, AfterAKillOverACopyTheLeftCopyGoes) {
  put(file, afterKill(disk->calls.size()));
  damageChunk(file, "/telemetry", 2);
  { const auto unfinished = RecordingWriter::create(folder.file("a.h5.recovered"), header()); }
  RecordingHeader another = header();
  another.id = "ffffffffffffffffffffffffffffffff";
  { const auto somebodys = RecordingWriter::create(folder.file("a.h5.recovered-2"), another); }
  ASSERT_EQ(recover(file)->result, RecoverResult::part_lost);
  EXPECT_FALSE(std::filesystem::exists(folder.file("a.h5.recovered.partial")));
  EXPECT_TRUE(std::filesystem::exists(folder.file("a.h5.recovered-2.partial")));
}

}  // namespace
}  // namespace fyd::recording
