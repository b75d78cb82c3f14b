// The recorder with its thread and a real file.
#include <fstream>

#include <opencv2/core.hpp>

#include "core/recording/format/step_compare.h"
#include "core/recording/writer/step_history.h"
#include "core/replay/replay.h"
#include "tests/integration/recording/recorder_replay_fixture.h"
#include "tests/wait.h"

namespace fyd::recording {
namespace {

using testing::HasSubstr;

TEST_F(Recorded, EverythingSinceTheStartIsInTheFile) {
  startRecorder();
  run(0.2);
  ASSERT_TRUE(
      recorder->begin({.path = file("a.h5"), .operator_name = "Ada", .subject = "S1", .tags = {"soft", "dry"}}));
  EXPECT_EQ(recorder->status().state, RecorderState::recording);
  run(2.3);
  ASSERT_TRUE(recorder->note(NoteKind::bookmark, "here"));
  ASSERT_TRUE(recorder->end());
  const RecorderStatus status = recorder->status();
  EXPECT_EQ(status.state, RecorderState::idle);
  EXPECT_EQ(status.samples, samples.size());
  EXPECT_EQ(status.lost, 0U);
  EXPECT_EQ(status.differences, 0U);
  EXPECT_GT(status.bytes, 100'000U);
  EXPECT_TRUE(std::isfinite(status.commit_p99_ms));

  const auto recording = open("a.h5");
  ASSERT_TRUE(recording);
  const RecordingInfo& info = recording->info();
  EXPECT_EQ(info.wholeness, Wholeness::whole);
  EXPECT_EQ(info.committed_samples, samples.size());
  EXPECT_EQ(info.gaps, 0U);
  EXPECT_EQ(info.header.operator_name, "Ada");
  EXPECT_THAT(info.header.tags, testing::ElementsAre("soft", "dry"));
  EXPECT_EQ(info.header.id.size(), 32U);
  EXPECT_THAT(info.header.started_utc, testing::MatchesRegex("20[0-9-]+T[0-9:]+\\.[0-9][0-9][0-9]Z"));
  std::vector<pipeline::TelemetrySample> read(samples.size());
  ASSERT_TRUE(recording->telemetry(0, read));
  for (std::size_t i = 0; i < read.size(); ++i) {
    ASSERT_TRUE(sameStep(read[i], {}, samples[i], {})) << "row " << i;
  }
  const auto notes = recording->notes();
  ASSERT_TRUE(notes);
  ASSERT_EQ(notes->size(), 1U);
  EXPECT_EQ(notes->front().text, "here");
}

TEST_F(Recorded, TheFileBeginsTenSecondsBeforeTheStart) {
  startRecorder({.pre_trigger_s = 3.0});
  run(7.5);
  ASSERT_TRUE(recorder->begin({.path = file("late.h5")}));
  run(0.5);
  ASSERT_TRUE(recorder->end());
  const auto recording = open("late.h5");
  ASSERT_TRUE(recording);
  const auto first = recording->step(0);
  ASSERT_TRUE(first);
  EXPECT_EQ(first->telemetry.step % StepHistory::kStepsPerChunk, 1U) << "it begins at a snapshot";
  const double before_s = 0.001 * static_cast<double>(7501 - first->telemetry.step);
  EXPECT_GE(before_s, 3.0);
  EXPECT_LE(before_s, 4.1);
  EXPECT_EQ(recording->info().committed_samples, 8000 - first->telemetry.step + 1);
  EXPECT_FALSE(recording->info().header.step_state.empty());
}

TEST_F(Recorded, ASecondRecordingHasTheSecondsBeforeItAsWell) {
  startRecorder();
  run(1.0);
  ASSERT_TRUE(recorder->begin({.path = file("one.h5")}));
  run(1.0);
  ASSERT_TRUE(recorder->end());
  ASSERT_TRUE(recorder->begin({.path = file("two.h5")}));
  run(0.5);
  ASSERT_TRUE(recorder->end());
  EXPECT_EQ(open("one.h5")->info().committed_samples, 2000U);
  EXPECT_EQ(open("two.h5")->info().committed_samples, 2500U);
}

TEST_F(Recorded, LeftToItselfItClosesTheFile) {
  startRecorder();
  run(0.1);
  ASSERT_TRUE(recorder->begin({.path = file("left.h5")}));
  run(0.4);
  recorder->shutDown();
  const auto recording = open("left.h5");
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->info().wholeness, Wholeness::whole);
  EXPECT_EQ(recording->info().committed_samples, 500U);
}

TEST_F(Recorded, AFileThatCannotBeMadeIsAnErrorAtOnceAndNothingChanges) {
  startRecorder();
  run(0.1);
  const auto nowhere = recorder->begin({.path = file("no/such/folder/a.h5")});
  ASSERT_FALSE(nowhere);
  EXPECT_THAT(nowhere.error().text(), HasSubstr("no/such/folder"));
  EXPECT_EQ(recorder->status().state, RecorderState::idle);
  EXPECT_FALSE(recorder->begin({}));
  EXPECT_FALSE(recorder->end()) << "nothing is recorded";
  std::ofstream(file("mine.h5")) << "precious";
  EXPECT_FALSE(recorder->begin({.path = file("mine.h5")})) << "nothing is written over";
  EXPECT_EQ(std::filesystem::file_size(file("mine.h5")), 8U);
  ASSERT_TRUE(recorder->begin({.path = file("good.h5")}));
  const auto again = recorder->begin({.path = file("other.h5")});
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().text(), HasSubstr("good.h5"));
  ASSERT_TRUE(recorder->end());
}

TEST_F(Recorded, ADiskThatIsFullAlreadyIsAnError) {
  startRecorder({.smallest_free_MB = 1e9});
  run(0.1);
  const auto begun = recorder->begin({.path = file("full.h5")});
  ASSERT_FALSE(begun);
  EXPECT_THAT(begun.error().text(), HasSubstr("MB left"));
}

TEST_F(Recorded, StepsThatWereLostAreAGapAndNoReplayPassesIt) {
  startRecorder();
  drop = [](std::uint64_t step) { return step > 700 && step <= 750; };
  run(0.5);
  ASSERT_TRUE(recorder->begin({.path = file("gap.h5")}));
  run(1.0);
  ASSERT_TRUE(recorder->end());
  const auto recording = open("gap.h5");
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->info().gaps, 50U);
  EXPECT_EQ(recording->info().committed_samples, 1450U);
  const auto result = replay::replay(*recording, {});
  ASSERT_TRUE(result) << result.error().text();
  EXPECT_FALSE(result->identical);
  EXPECT_EQ(result->different, 0U);
  EXPECT_EQ(result->samples, 700U);
}

TEST_F(Recorded, WithoutAKnownStateTheRecordingSaysSo) {
  startRecorder({.pre_trigger_s = 1.0});
  drop = [](std::uint64_t step) { return step == 100; };
  run(4.0);
  ASSERT_TRUE(recorder->begin({.path = file("blind.h5")}));
  ASSERT_TRUE(recorder->end());
  const auto recording = open("blind.h5");
  ASSERT_TRUE(recording);
  EXPECT_TRUE(recording->info().header.step_state.empty());
  const auto result = replay::replay(*recording, {});
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().text(), HasSubstr("no state"));
}

TEST_F(Recorded, ALoopThatOutrunsTheRecorderNeitherWaitsNorHidesIt) {
  Recorder unread({}, {}, {}, {}, {});  // its thread does not run
  const pipeline::Inputs in;
  const pipeline::Outputs out;
  for (int i = 0; i < 20'000; ++i) unread.push({.inputs = in, .outputs = out});
  unread.start();
  EXPECT_TRUE(comesTrue("lost steps to be told", [&] { return unread.status().lost > 0U; }));
  EXPECT_LT(unread.status().lost, 18'000U) << "two seconds fit at least";
}

TEST_F(Recorded, WholePicturesComeAtTheirRateAndRegionsWithEveryOne) {
  startRecorder({.whole_pictures_Hz = 10.0});
  run(1.0);
  const cv::Rect region(50, 45, 220, 150);
  std::vector<cv::Mat> pictures;
  for (int i = 0; i < 24; ++i) {
    cv::Mat picture(240, 320, CV_8UC1, cv::Scalar(10 * i));
    cv::randu(picture(region), 0, 255);
    pictures.push_back(picture);
    recorder->offerPicture(picture, region, {}, samples.front().now + std::chrono::milliseconds(33 * i),
                           static_cast<std::uint64_t>(i));
  }
  ASSERT_TRUE(recorder->begin({.path = file("wholes.h5")}));
  run(0.3);
  ASSERT_TRUE(recorder->end());
  const auto recording = open("wholes.h5");
  ASSERT_TRUE(recording);
  ASSERT_EQ(recording->info().frames, pictures.size());
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const auto back = recording->picture(i);
    ASSERT_TRUE(back) << back.error().text();
    EXPECT_EQ(cv::norm(back->region, pictures[i](region), cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(back->whole(region), back->region, cv::NORM_INF), 0.0) << "the region is never an older one";
    const int around = back->whole.at<std::uint8_t>(0, 0);
    const auto whole = i / 3 * 3;
    EXPECT_NEAR(around, 10.0 * static_cast<double>(whole), 2.0) << "every third whole at 30 in a second";
  }
}

TEST_F(Recorded, WithNothingKeptFromBeforeTheStartEveryPictureComes) {
  startRecorder({.pre_trigger_s = 0.0});
  run(0.5);
  ASSERT_TRUE(recorder->begin({.path = file("late.h5")}));
  run(0.2);
  const cv::Mat picture(48, 64, CV_8UC1, cv::Scalar(9));
  constexpr std::uint64_t kPictures = 20;
  for (std::uint64_t i = 0; i < kPictures; ++i) {  // each comes after the steps of its moment, as from a camera
    recorder->offerPicture(picture, {}, {}, samples.back().now - std::chrono::milliseconds(30), i);
    run(0.05);
  }
  ASSERT_TRUE(recorder->end());
  EXPECT_EQ(recorder->status().pictures_lost, 0U);
  const auto recording = open("late.h5");
  ASSERT_TRUE(recording);
  EXPECT_EQ(recording->info().frames, kPictures);
}

TEST_F(Recorded, PicturesComeBackAsTheDetectorSawThem) {
  startRecorder();
  run(1.0);
  cv::Mat picture(240, 320, CV_8UC1);
  cv::randu(picture, 0, 255);
  const cv::Rect region(50, 45, 220, 150);
  const Instant taken = samples.back().now - std::chrono::milliseconds(200);
  recorder->offerPicture(picture, region, {.contact = true, .x_mm = 1.5}, taken, 42);
  ASSERT_TRUE(recorder->begin({.path = file("seen.h5")}));
  run(0.3);
  ASSERT_TRUE(recorder->end());
  EXPECT_EQ(recorder->status().pictures, 1U);
  const auto recording = open("seen.h5");
  ASSERT_TRUE(recording);
  ASSERT_EQ(recording->info().frames, 1U);
  const auto back = recording->picture(0);
  ASSERT_TRUE(back) << back.error().text();
  EXPECT_EQ(back->number, 42U);
  EXPECT_EQ(back->region_px, region);
  EXPECT_EQ(back->finger.x_mm, 1.5);
  EXPECT_EQ(cv::norm(back->region, picture(region), cv::NORM_INF), 0.0);
  EXPECT_EQ(back->whole.size(), picture.size());
}

}  // namespace
}  // namespace fyd::recording
