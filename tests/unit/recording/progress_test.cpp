// Progress and cancellation of long work: a cancelled run leaves no files and no changes, and it can be run again.
#include "core/recording/progress.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/export/touches.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"
#include "core/report/report.h"
#include "recording_damage.h"
#include "recording_samples.h"
#include "refusal.h"
#include "tests/unit/recording/fake_recording.h"

namespace fyd::recording {
namespace {

using samples::contentOf;
using samples::damageChunk;
using samples::Folder;

/// Notes what it is told; ends the work when it has been told `most` times.
struct Listener {
  std::size_t most = std::numeric_limits<std::size_t>::max();
  std::vector<double> told;
  Progress progress() {
    return [this](double done) {
      told.push_back(done);
      return told.size() < most;
    };
  }
  void expectRising() const {
    ASSERT_GE(told.size(), 3U);
    EXPECT_GE(told.front(), 0.0);
    EXPECT_LE(told.back(), 1.0);
    EXPECT_LT(told.front(), told.back());
    EXPECT_TRUE(std::ranges::is_sorted(told));
  }
};

FakeRecording fiveSeconds() {
  return FakeRecording(5000, [](std::uint64_t row) {
    auto sample = FakeRecording::sampleAt(0.001 * static_cast<double>(row), row + 1);
    sample.contact = row > 1000 && row < 2000;
    return sample;
  });
}

/// Closed, or as a killed recorder leaves it: FILE.partial. @return its name
std::string recorded(const Folder& folder, bool closed) {
  auto writer = RecordingWriter::create(folder.file(), samples::header());
  EXPECT_TRUE(writer) << writer.error().text();
  for (std::uint64_t row = 0; row < 5000; ++row) EXPECT_TRUE((*writer)->append(samples::plainStep(row)));
  if (!closed) return partialOf(folder.file());
  EXPECT_TRUE((*writer)->close());
  return folder.file();
}

TEST(Progress, APartTellsItsShareOfTheWhole) {
  Listener listener;
  const Progress part = partOf(listener.progress(), 0.5, 0.75);
  EXPECT_TRUE(tellProgress(part, 0.0));
  EXPECT_TRUE(tellProgress(part, 1.0));
  EXPECT_EQ(listener.told, (std::vector{0.5, 0.75}));
  EXPECT_TRUE(tellProgress({}, 0.5));
  EXPECT_TRUE(tellProgress(partOf({}, 0.0, 1.0), 0.5));
  listener.most = 1;
  EXPECT_FALSE(tellProgress(part, 0.0));
}

TEST(Progress, TheSearchForTouchesTellsAndEnds) {
  const FakeRecording recording = fiveSeconds();
  Listener all;
  ASSERT_TRUE(exports::findTouches(recording, all.progress()));
  all.expectRising();
  Listener some{.most = 2, .told = {}};
  EXPECT_FALSE(exports::findTouches(recording, some.progress()));
  EXPECT_EQ(some.told.size(), 2U);
}

TEST(Progress, AReportTellsAndLeavesNoFileWhenEnded) {
  const FakeRecording recording = fiveSeconds();
  const Folder folder;
  Listener all;
  for (const char* name : {"r.html", "r.pdf"}) ASSERT_TRUE(report::writeReport(recording, folder.file(name), false));
  ASSERT_TRUE(report::writeReport(recording, folder.file("r.html"), true, all.progress()));
  all.expectRising();
  for (std::size_t most = 1; most <= all.told.size(); ++most) {
    Listener some{.most = most, .told = {}};
    EXPECT_FALSE(report::writeReport(recording, folder.file("ended.html"), false, some.progress())) << most;
    EXPECT_EQ(some.told.size(), most);
  }
  EXPECT_EQ(namesIn(folder.path()), (std::vector<std::string>{"r.html", "r.pdf"}));
}

TEST(Progress, CheckingARecordingTellsAndEnds) {
  const Folder folder;
  const std::string file = recorded(folder, false);
  Listener all;
  const auto checked = verify(file, all.progress());
  ASSERT_TRUE(checked) << checked.error().text();
  EXPECT_TRUE(checked->intact());
  all.expectRising();
  Listener some{.most = 3, .told = {}};
  EXPECT_FALSE(verify(file, some.progress()));
  EXPECT_EQ(some.told.size(), 3U);
}

/// Ends the recovery at moments from its first to its last; then lets it be.
void expectRecoveryEndsWithoutATrace(const Folder& folder, const std::string& file, RecoverResult at_last) {
  const std::string before = contentOf(file);
  const Folder elsewhere;
  const std::string name = std::filesystem::path(file).filename();
  std::filesystem::copy(file, elsewhere.file(name));
  Listener whole;
  ASSERT_TRUE(recover(elsewhere.file(), whole.progress()));
  whole.expectRising();
  ASSERT_GT(whole.told.size(), 20U);
  for (std::size_t back = whole.told.size(); back-- > 0; back -= back / 4) {
    Listener some{.most = whole.told.size() - back, .told = {}};
    ASSERT_FALSE(recover(file, some.progress()));
    ASSERT_EQ(some.told.size(), some.most);
    ASSERT_EQ(namesIn(folder.path()), std::vector<std::string>{name}) << some.most;
    ASSERT_TRUE(contentOf(file) == before) << some.most;
  }
  const auto outcome = recover(file);
  ASSERT_TRUE(outcome) << outcome.error().text();
  EXPECT_EQ(outcome->result, at_last);
  EXPECT_EQ(outcome->steps + outcome->lost_steps, 5000U);
}

TEST(Progress, RecoveryOfASoundRecordingEndsWithoutATrace) {
  const Folder folder;
  expectRecoveryEndsWithoutATrace(folder, recorded(folder, false), RecoverResult::whole);
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"a.h5"});
}

TEST(Progress, RecoveryOfADamagedRecordingEndsWithoutATrace) {
  const Folder folder;
  const std::string file = recorded(folder, true);
  damageChunk(file, "/telemetry", 7);
  expectRecoveryEndsWithoutATrace(folder, file, RecoverResult::part_lost);
  EXPECT_EQ(namesIn(folder.path()), (std::vector<std::string>{"a.h5", "a.h5.damaged"}));
}

}  // namespace
}  // namespace fyd::recording
