// Damaged commit rows of a closed recording: rows after them stay readable, the recording is not reported whole, and
// blocks with correct checksums are kept.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/export/export_recording.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"
#include "recording_damage.h"
#include "recording_samples.h"

namespace fyd::recording {
namespace {

using namespace samples;
using testing::HasSubstr;

constexpr std::uint64_t kCommitRows = 4100;  // the last commit holds 100
constexpr std::uint64_t kLast = 17;          // commits: an empty one, sixteen of 250 steps, the closing one

class DamagedCommits : public testing::Test {
 protected:
  void SetUp() override {
    auto writer = RecordingWriter::create(file, header());
    ASSERT_TRUE(writer);
    for (std::uint64_t row = 0; row < kCommitRows; ++row) ASSERT_TRUE((*writer)->append(plainStep(row)));
    ASSERT_TRUE((*writer)->append(Note{.when = instantAt(1004.05), .text = "the last word"}));
    ASSERT_TRUE((*writer)->close());
    first = commitAt(file, 0);
    ASSERT_EQ(commitAt(file, kLast), commitAt(file, 12) + (kLast - 12) * sizeof(CommitRow));
  }

  /// All of them say "damaged", and none of them calls less than everything whole.
  void expectSaid() const {
    const auto recording = Recording::open(file);
    ASSERT_TRUE(recording) << recording.error().text();
    EXPECT_EQ((*recording)->info().wholeness, Wholeness::damaged);
    EXPECT_EQ(healthOf((*recording)->info()).word, "damaged");
    EXPECT_THAT((*recording)->info().damage.text(), HasSubstr("/commits"));
    const auto checked = verify(file);
    ASSERT_TRUE(checked) << checked.error().text();
    EXPECT_FALSE(checked->intact());
    EXPECT_EQ(checked->wholeness, Wholeness::damaged);
    EXPECT_EQ(checked->health.word, "damaged");
  }

  /// What is left after `recover`, which is sound; every step there is the one it was.
  std::unique_ptr<Recording> recovered(RecoverResult expected, std::uint64_t steps) {
    const auto outcome = recover(file);
    if (!outcome) {
      ADD_FAILURE() << outcome.error().text();
      return nullptr;
    }
    EXPECT_EQ(outcome->result, expected) << outcome->first_damage.text();
    EXPECT_EQ(outcome->steps, steps);
    EXPECT_EQ(outcome->steps + outcome->lost_steps, kCommitRows);
    EXPECT_TRUE(verify(file)->intact());
    EXPECT_TRUE(othersOpen(file));
    auto recording = Recording::open(file);
    EXPECT_TRUE(recording);
    for (std::uint64_t row = 0; row < (*recording)->info().committed_samples; ++row) {
      const auto step = (*recording)->step(row);
      if (!step || (step->missing == 0 && !sameRecord(*step, plainStep(step->telemetry.step - 1)))) {
        ADD_FAILURE() << "row " << row;
        break;
      }
    }
    return std::move(*recording);
  }

  Folder folder;
  std::string file = folder.file();
  std::size_t first = 0;
};

TEST_F(DamagedCommits, OneTurnedBitOfAnyRowIsToldAndCostsNothing) {
  const std::string good = contentOf(file);
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i) {
    write(file, good);
    const std::uint64_t number = i < 20 ? kLast - random() % 3 : random() % (kLast + 1);
    flipBit(file, commitAt(file, number) + random() % sizeof(CommitRow), random() % 8);
    expectSaid();
    const auto whole = recovered(RecoverResult::whole, kCommitRows);
    ASSERT_TRUE(whole);
    EXPECT_TRUE(whole->info().header.missing.empty());
    EXPECT_EQ(whole->info().gaps, 0U);
    EXPECT_EQ(whole->notes()->size(), 1U);
    ASSERT_FALSE(HasFailure()) << "commit " << number;
    std::filesystem::remove(folder.file("a.h5.damaged"));
  }
}

TEST_F(DamagedCommits, OfARowThatIsWrongInManyPlacesTheProvenTablesAreKept) {
  const std::size_t at = commitAt(file, 8);
  loseBytes(file, at, 40);                                                         // number, times, counters
  loseBytes(file, at + offsetof(CommitRow, crc) + 4 * indexOf(Table::motors), 4);  // and one table's checksum
  expectSaid();
  const auto left = recovered(RecoverResult::part_lost, kCommitRows);
  ASSERT_TRUE(left);
  ASSERT_EQ(left->info().header.missing.size(), 1U);
  const MissingRows& missing = left->info().header.missing[0];
  EXPECT_EQ(missing.table, "/motors");
  EXPECT_EQ(missing.first, 7 * 250U);
  EXPECT_EQ(missing.count, 250U);
}

TEST_F(DamagedCommits, RowsThatNoCommitProvesAreNeitherShownNorHidden) {
  loseBytes(file, commitAt(file, kLast - 1), 2 * sizeof(CommitRow));
  expectSaid();
  {
    const auto recording = Recording::open(file);
    ASSERT_TRUE(recording);
    const RecordingInfo& info = (*recording)->info();
    EXPECT_EQ(info.samples, kCommitRows);
    EXPECT_EQ(info.committed_samples, kCommitRows - 350);
    EXPECT_GE(info.unproven_rows, 350U);
    EXPECT_FALSE((*recording)->step(kCommitRows - 350));
    const auto all = exports::exportRecording(**recording, folder.file("all.csv"), {});
    ASSERT_FALSE(all);
    EXPECT_THAT(all.error().text(), HasSubstr("recover"));
    EXPECT_FALSE(std::filesystem::exists(folder.file("all.csv")));
    exports::ExportOptions some;
    some.to_s = 3.0;
    EXPECT_TRUE(exportRecording(**recording, folder.file("some.csv"), some));
  }
  const auto left = recovered(RecoverResult::part_lost, kCommitRows - 350);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->info().gaps, 350U);
  std::vector<std::pair<std::string, std::uint64_t>> gone;
  for (const MissingRows& rows : left->info().header.missing) gone.emplace_back(rows.table, rows.count);
  EXPECT_THAT(gone, testing::UnorderedElementsAre(std::pair("/telemetry", 350U), std::pair("/notes/index", 1U)));
  EXPECT_TRUE(exports::exportRecording(*left, folder.file("left.csv"), {}));
}

TEST_F(DamagedCommits, ALostSectorOfThemCostsItsOwnBlocksOnly) {
  loseBytes(file, commitAt(file, 5), 512);  // commits 5 and 6
  expectSaid();
  const auto left = recovered(RecoverResult::part_lost, kCommitRows - 750);  // and 7, whose beginning nothing tells
  ASSERT_TRUE(left);
  EXPECT_EQ(left->info().gaps, 750U);
}

TEST_F(DamagedCommits, AllOfThemLostIsNoRecordingAnyMore) {
  loseBytes(file, commitAt(file, 0), 12 * sizeof(CommitRow));
  loseBytes(file, commitAt(file, 12), 6 * sizeof(CommitRow));
  const auto recording = Recording::open(file);
  ASSERT_FALSE(recording);
  EXPECT_THAT(recording.error().text(), HasSubstr("all 18 are damaged"));
  const std::string before = contentOf(file);
  const auto outcome = recover(file);
  ASSERT_TRUE(outcome);
  EXPECT_EQ(outcome->result, RecoverResult::nothing);
  EXPECT_TRUE(contentOf(file) == before);
}

}  // namespace
}  // namespace fyd::recording
