// One flipped bit in a table of one row: the steps are kept, missing rows are named, and no replay is reported
// identical.
#include "core/recording/reader/recording_health.h"
#include "core/recording/recovery/recover.h"
#include "core/recording/recovery/verify.h"
#include "core/replay/replay.h"
#include "tests/integration/recording/recorder_replay_fixture.h"
#include "tests/unit/recording/recording_damage.h"
#include "tests/unit/recording/recording_samples.h"

namespace fyd::recording {
namespace {

using samples::chunkOf;
using samples::flipBit;
using testing::HasSubstr;

class RecoverMissing : public Recorded {
 protected:
  void record(double seconds) {
    startRecorder();
    run(1.0);
    ASSERT_TRUE(recorder->begin({.path = file("a.h5")}));
    run(seconds);
    ASSERT_TRUE(recorder->end());
    recorder->shutDown();
    const auto whole = open("a.h5");
    ASSERT_TRUE(whole);
    all = whole->info().committed_samples;
    ASSERT_GT(all, 2000U);
    const auto replayed = replay::replay(*whole, {});
    ASSERT_TRUE(replayed) << replayed.error().text();
    ASSERT_TRUE(replayed->identical);
  }
  std::uint64_t all = 0;
};

TEST_F(RecoverMissing, ATableOfOneRow) {
  record(2.0);
  flipBit(file("a.h5"), chunkOf(file("a.h5"), "/inputs/motor_reference", 0).first + 17, 4);
  EXPECT_FALSE(verify(file("a.h5"))->intact());
  EXPECT_FALSE(replay::replay(*open("a.h5"), {}));
  const auto outcome = recover(file("a.h5"));
  ASSERT_TRUE(outcome) << outcome.error().text();
  EXPECT_EQ(outcome->result, RecoverResult::part_lost);
  EXPECT_EQ(outcome->steps, all);
  EXPECT_EQ(outcome->lost_steps, 0U);
  ASSERT_EQ(outcome->missing.size(), 1U);
  EXPECT_EQ(outcome->missing[0].table, "/inputs/motor_reference");
  EXPECT_EQ(outcome->missing[0].first, 0U);
  EXPECT_EQ(outcome->missing[0].count, all);
  EXPECT_TRUE(verify(file("a.h5"))->intact());

  const auto kept = open("a.h5");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->info().header.missing, outcome->missing);
  EXPECT_EQ(healthOf(kept->info()).word, "gaps");
  EXPECT_THAT(healthOf(kept->info()).reason.text(), HasSubstr("/inputs/motor_reference"));
  const auto original = Recording::open(outcome->kept);
  ASSERT_TRUE(original);
  pipeline::TelemetrySample was;
  pipeline::TelemetrySample is;
  for (std::uint64_t row = 0; row < all; ++row) {
    ASSERT_TRUE((*original)->telemetry(row, std::span(&was, 1)));
    ASSERT_TRUE(kept->telemetry(row, std::span(&is, 1)));
    ASSERT_TRUE(samples::same(was, is)) << row;
  }
  const auto step = kept->step(all / 2);
  ASSERT_TRUE(step) << step.error().text();
  EXPECT_EQ(step->missing, bitOf(Table::motor_reference));
  EXPECT_EQ(missingTables(*step), std::vector<std::string>{"/inputs/motor_reference"});

  const auto replayed = replay::replay(*kept, {});
  ASSERT_TRUE(replayed) << replayed.error().text();
  EXPECT_FALSE(replayed->identical);
  EXPECT_EQ(replayed->samples, all);
  EXPECT_THAT(replayed->why_not_exact.text(), HasSubstr("/inputs/motor_reference is lost"));
}

TEST_F(RecoverMissing, WhatWasLostOnceIsStillNamedAfterASecondRecovery) {
  record(2.0);
  flipBit(file("a.h5"), chunkOf(file("a.h5"), "/inputs/motor_reference", 0).first + 17, 4);
  ASSERT_EQ(recover(file("a.h5"))->result, RecoverResult::part_lost);
  samples::damageChunk(file("a.h5"), "/telemetry", 3);
  const auto again = recover(file("a.h5"));
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again->steps, all - 250);
  samples::damageChunk(file("a.h5"), "/telemetry", 5);
  const auto third = recover(file("a.h5"));
  ASSERT_TRUE(third) << third.error().text();
  const auto kept = open("a.h5");
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->info().gaps, 500U);
  std::map<std::string, std::uint64_t> lost;
  for (const MissingRows& rows : kept->info().header.missing) lost[rows.table] += rows.count;
  EXPECT_EQ(lost, (std::map<std::string, std::uint64_t>{{"/telemetry", 500}, {"/inputs/motor_reference", all - 500}}));
}

TEST_F(RecoverMissing, StepsThatWereLostAtTheEndStayLostHoweverOftenItIsRecovered) {
  record(3.0);
  const std::uint64_t last = (all - 1) / 250;
  samples::damageChunk(file("a.h5"), "/telemetry", last);
  const auto first = recover(file("a.h5"));
  ASSERT_TRUE(first) << first.error().text();
  ASSERT_EQ(first->lost_steps, all - 250 * last);
  const std::string once = samples::contentOf(file("a.h5"));
  for (const std::size_t cut : {1'000U, 20'000U, 60'000U, 120'000U}) {
    samples::write(file("a.h5"), once.substr(0, once.size() - cut));
    const auto again = recover(file("a.h5"));
    ASSERT_TRUE(again) << cut << ": " << again.error().text();
    const auto kept = open("a.h5");
    ASSERT_TRUE(kept);
    std::uint64_t gone = 0;
    for (const MissingRows& rows : kept->info().header.missing) gone += rows.table == "/telemetry" ? rows.count : 0;
    EXPECT_EQ(kept->info().committed_samples + gone, all) << cut;
    EXPECT_EQ(kept->info().gaps, gone) << cut;
    const auto replayed = replay::replay(*kept, {});
    ASSERT_TRUE(replayed) << replayed.error().text();
    EXPECT_EQ(replayed->of, all) << cut;
    EXPECT_FALSE(replayed->identical) << cut;
  }
}

TEST_F(RecoverMissing, WithoutTheFirstStepNothingIsReplayedFromAStateThatIsNotItsOwn) {
  record(2.0);
  samples::damageChunk(file("a.h5"), "/telemetry", 0);
  ASSERT_EQ(recover(file("a.h5"))->result, RecoverResult::part_lost);
  const auto replayed = replay::replay(*open("a.h5"), {});
  ASSERT_FALSE(replayed);
  EXPECT_THAT(replayed.error().text(), HasSubstr("no state of the step"));
}

TEST_F(RecoverMissing, AHeaderWhoseChecksumDiffersIsNotTakenForTrue) {
  record(2.0);
  const std::string content = samples::contentOf(file("a.h5"));
  const std::size_t at = content.find("control.kp", kJournalBytes);
  const std::size_t text = at != std::string::npos ? at : content.find("kp", kJournalBytes);
  ASSERT_NE(text, std::string::npos);
  flipBit(file("a.h5"), text, 0);
  EXPECT_FALSE(Recording::open(file("a.h5")));
  const auto outcome = recover(file("a.h5"));
  ASSERT_TRUE(outcome) << outcome.error().text();
  EXPECT_EQ(outcome->result, RecoverResult::part_lost);
  EXPECT_EQ(outcome->steps, all);
  const auto kept = open("a.h5");
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->info().header.missing.size(), 1U);
  EXPECT_EQ(kept->info().header.missing[0].table, "/header");
  EXPECT_FALSE(whyNoExactReplay(kept->info()).empty());
}

TEST_F(RecoverMissing, WhatWasLostIsStillNamedWhenTheHeaderIsDamagedLater) {
  record(2.0);
  flipBit(file("a.h5"), chunkOf(file("a.h5"), "/inputs/motor_reference", 0).first + 17, 4);
  ASSERT_EQ(recover(file("a.h5"))->result, RecoverResult::part_lost);
  const std::size_t text = samples::contentOf(file("a.h5")).find("control.kp", kJournalBytes);
  ASSERT_NE(text, std::string::npos);
  flipBit(file("a.h5"), text, 0);
  ASSERT_TRUE(recover(file("a.h5")));
  const auto kept = open("a.h5");
  ASSERT_TRUE(kept);
  std::map<std::string, std::uint64_t> lost;
  for (const MissingRows& rows : kept->info().header.missing) lost[rows.table] += rows.count;
  EXPECT_EQ(lost, (std::map<std::string, std::uint64_t>{{"/header", 1}, {"/inputs/motor_reference", all}}));
}

}  // namespace
}  // namespace fyd::recording
