// Files that are damaged, no recordings or not of this program: an error or the right values, never a crash.
// FYD_FLIPS=all flips every byte of the file's front.
#include <hdf5.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/recording/file/recording_disk.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/reader/recording_health.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"
#include "recording_damage.h"
#include "recording_samples.h"

namespace fyd::recording {
namespace {

using namespace samples;

/// Reads damaged files and counts what can be read of them.
struct Readings {
  /// Whatever opens holds what was recorded, or says that it is damaged, or what is missing.
  /// @param rows that were recorded
  void expectErrorOrEqual(const std::string& file, std::uint64_t rows) {
    const auto recording = Recording::open(file);
    if (!recording) return;
    ++opened;
    const RecordingInfo& info = (*recording)->info();
    EXPECT_EQ(info.header.profile, header().profile);
    EXPECT_EQ(info.header.started, header().started);
    EXPECT_EQ(info.header.subject, header().subject);
    EXPECT_LE(info.committed_samples, rows);
    if (info.wholeness == Wholeness::whole) {
      ++whole;
      EXPECT_EQ(info.committed_samples, rows);
    }
    const auto lacksSomething = [&](std::uint64_t row) {
      return std::ranges::any_of(info.header.missing, [&](const MissingRows& missing) {
        return row >= missing.first && row - missing.first < missing.count;
      });
    };
    for (std::uint64_t row = 0; row < info.committed_samples; row += 41) {
      if (lacksSomething(row)) continue;
      const auto step = (*recording)->step(row);
      if (step) {
        ++steps;
        EXPECT_TRUE(sameRecord(*step, plainStep(row))) << row;
      }
    }
  }
  int opened = 0, whole = 0, steps = 0;
};

TEST(RecordingDamage, WhatIsNoRecordingIsAnError) {
  const Folder folder;
  EXPECT_FALSE(Recording::open(folder.file("none.h5")));
  EXPECT_FALSE(Recording::open(folder.path()));
  EXPECT_FALSE(Recording::open("/dev/null"));
  std::mt19937 random(1);
  for (const std::size_t size : {0U, 1U, 7U, 511U, 4096U, 100'000U}) {
    std::string garbage(size, '\0');
    for (char& c : garbage) c = static_cast<char>(random());
    write(folder.file(), garbage);
    EXPECT_FALSE(Recording::open(folder.file())) << size;
    EXPECT_FALSE(verify(folder.file()));
    const auto outcome = recover(folder.file());
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->result, RecoverResult::nothing);
    EXPECT_TRUE(contentOf(folder.file()) == garbage);  // left as it is
  }
}

TEST(RecordingDamage, AnotherHdf5FileAndAnotherVersionAreNamedAsSuch) {
  const Folder folder;
  H5Fclose(H5Fcreate(folder.file("other.h5").c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
  const auto other = Recording::open(folder.file("other.h5"));
  ASSERT_FALSE(other);
  EXPECT_NE(other.error().text().find("not a recording"), std::string::npos) << other.error().text();

  record(folder.file(), 10);
  const hid_t file = H5Fopen(folder.file().c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  ASSERT_GE(file, 0);  // a closed recording is a plain HDF5 file
  const hid_t attribute = H5Aopen(file, "fyd_recording", H5P_DEFAULT);
  const std::int64_t next = 2;
  EXPECT_GE(H5Awrite(attribute, H5T_NATIVE_INT64, &next), 0);
  H5Aclose(attribute);
  H5Fclose(file);
  const auto newer = Recording::open(folder.file());
  ASSERT_FALSE(newer);
  EXPECT_NE(newer.error().text().find("format 2"), std::string::npos) << newer.error().text();
}

TEST(RecordingDamage, AFlippedByteIsAnErrorOrChangesNothing) {
  const Folder folder;
  record(folder.file("good.h5"), 600);
  const std::string good = contentOf(folder.file("good.h5"));
  const char* all = std::getenv("FYD_FLIPS");
  std::mt19937 random(2);
  Readings readings;
  const auto flipAt = [&](std::size_t at) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ (1 << (random() % 8)));
    write(folder.file(), bad);
    readings.expectErrorOrEqual(folder.file(), 600);
  };
  const std::size_t front = std::min<std::size_t>(good.size(), kJournalBytes + 24'000);
  for (std::size_t at = kJournalBytes; at < front; at += all != nullptr ? 1 : 397) flipAt(at);
  for (const char* text : {"00112233445566778899", "2026-05-04T03", "S07", "pilot", "kp=0.5", "started_ns"}) {
    const std::size_t at = good.find(text, kJournalBytes);
    ASSERT_NE(at, std::string::npos) << text;
    flipAt(at);
    flipAt(at + 2);
  }
  for (int i = 0; i < 60; ++i) flipAt(kJournalBytes + random() % (good.size() - kJournalBytes));
  EXPECT_GT(readings.opened, 10);  // not every flip may make it no recording
  EXPECT_GT(readings.steps, 100);
}

TEST(RecordingDamage, ATruncatedFileIsAnErrorOrChangesNothing) {
  const Folder folder;
  record(folder.file("good.h5"), 600);
  const std::string good = contentOf(folder.file("good.h5"));
  std::mt19937 random(3);
  Readings readings;
  readings.expectErrorOrEqual(folder.file("good.h5"), 600);
  for (int i = 0; i < 40; ++i) {
    const std::size_t keep = i < 20 ? random() % good.size() : good.size() - 1 - random() % 20'000;
    write(folder.file(), good.substr(0, keep));
    readings.expectErrorOrEqual(folder.file(), 600);
  }
  EXPECT_EQ(readings.whole, 1) << "none but the one that is not cut";
}

TEST(RecordingDamage, OfACopyThatBrokeOffWhatWasCopiedIsSaved) {
  const Folder folder;
  record(folder.file("good.h5"), 5000);
  const std::string good = contentOf(folder.file("good.h5"));
  const std::size_t rows_from = kJournalBytes + 40'000;  // the header is there
  std::uint64_t before = 0;
  for (const double part : {0.1, 0.4, 0.7, 0.95, 1.0}) {
    const std::size_t kept = rows_from + static_cast<std::size_t>(part * static_cast<double>(good.size() - rows_from));
    const std::string cut = good.substr(0, std::min(kept, good.size() - 1));
    write(folder.file(), cut);
    const auto said =
        fmt::format("cut short: its last {} of {} bytes are missing", good.size() - cut.size(), good.size());
    {
      const auto damaged = Recording::open(folder.file());
      ASSERT_TRUE(damaged) << damaged.error().text();
      EXPECT_EQ((*damaged)->info().wholeness, Wholeness::damaged);
      EXPECT_THAT((*damaged)->info().damage.text(), testing::StartsWith(said));
    }
    const auto checked = verify(folder.file());
    ASSERT_TRUE(checked) << checked.error().text();
    EXPECT_FALSE(checked->intact()) << part;
    EXPECT_EQ(checked->missing_bytes, good.size() - cut.size());
    EXPECT_THAT(checked->first_damage.text(), testing::StartsWith(said));
    const auto outcome = recover(folder.file());
    ASSERT_TRUE(outcome) << outcome.error().text();
    ASSERT_NE(outcome->result, RecoverResult::nothing) << outcome->first_damage.text();
    EXPECT_EQ(outcome->steps + outcome->lost_steps, 5000U) << part;
    // Of a file that is filled as time goes by.
    EXPECT_GE(static_cast<double>(outcome->steps), (0.8 * part - 0.1) * 5000.0) << part;
    EXPECT_GE(outcome->steps, before);
    before = outcome->steps;
    EXPECT_TRUE(contentOf(outcome->kept) == cut);
    EXPECT_TRUE(verify(folder.file())->intact());
    Readings readings;
    readings.expectErrorOrEqual(folder.file(), outcome->steps);
    EXPECT_EQ(readings.whole, 1);
    EXPECT_GE(readings.steps, static_cast<int>(outcome->steps) / 41 - 40) << part;  // some lack a table's rows
    std::filesystem::remove(folder.file());
    std::filesystem::remove(outcome->kept);
  }
}

TEST(RecordingDamage, OneBadBlockCostsItselfAndRecoverSavesTheRest) {
  const Folder folder;
  record(folder.file("good.h5"), 5000);
  const std::string good = contentOf(folder.file("good.h5"));
  for (const auto& [table, block, lost] :
       {std::tuple{"/telemetry", 7, 250U}, {"/inputs/steps", 7, 0U}, {"/motors", 3, 0U}, {"/inputs/bridge", 0, 0U}}) {
    write(folder.file(), good);
    damageChunk(folder.file(), table, static_cast<hsize_t>(block));
    const std::string bad = contentOf(folder.file());
    const auto checked = verify(folder.file());
    ASSERT_TRUE(checked);
    EXPECT_FALSE(checked->intact()) << table;
    EXPECT_EQ(checked->wholeness, Wholeness::damaged) << table;
    EXPECT_NE(checked->health.reason.text().find(table), std::string::npos) << checked->health.reason.text();
    const auto outcome = recover(folder.file());
    ASSERT_TRUE(outcome) << outcome.error().text();
    EXPECT_EQ(outcome->result, RecoverResult::part_lost) << table;
    EXPECT_EQ(outcome->steps + outcome->lost_steps, 5000U) << table;
    EXPECT_EQ(outcome->lost_steps, lost) << table;
    ASSERT_EQ(outcome->missing.size(), 1U) << table;
    EXPECT_EQ(outcome->missing[0].table, table);
    EXPECT_LE(outcome->missing[0].count, 750U) << table;  // of values that hold for more than a block, some more
    EXPECT_NE(outcome->missing[0].why.find("damaged"), std::string::npos) << outcome->missing[0].why;
    EXPECT_TRUE(contentOf(outcome->kept) == bad);
    const auto saved = Recording::open(folder.file());
    ASSERT_TRUE(saved) << saved.error().text();
    EXPECT_EQ((*saved)->info().committed_samples, outcome->steps);
    EXPECT_EQ((*saved)->info().gaps, lost) << table;
    EXPECT_EQ((*saved)->info().header.missing, outcome->missing) << table;
    EXPECT_EQ(healthOf((*saved)->info()).word, "gaps") << table;
    const auto again = verify(folder.file());
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->intact());
    std::filesystem::remove(folder.file());
    std::filesystem::remove(outcome->kept);
  }
}

TEST(RecordingDamage, WhatIsMadeOfTheRowsIsMadeAnew) {
  const Folder folder;
  record(folder.file(), 5000);
  damageChunk(folder.file(), "/overview/rows_25", 3);
  EXPECT_FALSE(verify(folder.file())->intact());
  const auto outcome = recover(folder.file());
  ASSERT_TRUE(outcome) << outcome.error().text();
  EXPECT_EQ(outcome->result, RecoverResult::whole);
  EXPECT_EQ(outcome->steps, 5000U);
  EXPECT_TRUE(outcome->missing.empty());
  EXPECT_EQ(outcome->kept, folder.file("a.h5.damaged"));
  EXPECT_TRUE(verify(folder.file())->intact());
  Readings readings;
  readings.expectErrorOrEqual(folder.file(), 5000);
  EXPECT_EQ(readings.whole, 1);
  EXPECT_EQ(readings.steps, 122);  // all that were looked at
}

}  // namespace
}  // namespace fyd::recording
