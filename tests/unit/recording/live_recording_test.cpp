// One recording while it is written, without the recorder's thread: what it does when steps are lost, when its disk
// fails, and with pictures whose clock stands.
#include <cerrno>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "core/pipeline/pipeline.h"
#include "core/recording/file/recording_place.h"
#include "core/recording/reader/recording_salvage.h"
#include "core/recording/writer/live_recording.h"
#include "refusal.h"
#include "tests/temporary_folder.h"
#include "troubled_disk.h"

namespace fyd::recording {
namespace {

using testing::HasSubstr;

class Live : public testing::Test {
 protected:
  static constexpr std::chrono::milliseconds kPeriod{1};

  void push(int count) {
    for (int i = 0; i < count; ++i) {
      pipeline::Inputs inputs;
      inputs.now = begun + kPeriod * pushed++;
      const pipeline::Outputs& outputs = pipeline.step(inputs);
      follower.push({.inputs = inputs, .outputs = outputs});
    }
  }
  void pushAndTake(int count) {
    push(count);
    follower.take();
  }
  void offer(Instant taken, std::uint64_t number) {
    cv::Mat picture(48, 64, CV_8UC1);
    cv::randu(picture, 0, 255);
    pictures.add({.picture = picture, .region_px = {10, 5, 40, 30}, .taken = taken, .number = number});
  }
  std::unique_ptr<LiveRecording> open(const std::string& path, double whole_pictures_Hz = 10.0) {
    auto opened = LiveRecording::open(path, {.started = begun},
                                      {.smallest_free_MB = 10.0, .whole_pictures_Hz = whole_pictures_Hz},
                                      {.steps = follower, .pictures = pictures, .station = station}, disk);
    EXPECT_TRUE(opened) << (opened ? "" : opened.error().text());
    return opened ? std::move(*opened) : nullptr;
  }

  Folder folder;
  std::string path = folder.file();
  const Instant begun = instantAt(100.0);
  pipeline::Pipeline pipeline{pipeline::Parameters()};
  StepFollower follower{{}, {}, 10.0};
  PictureHistory pictures;
  StationSource station;
  std::shared_ptr<TroubledDisk> disk = std::make_shared<TroubledDisk>();
  int pushed = 0;
};

TEST_F(Live, StepsThatTheRingLostAreCountedInTheFile) {
  const auto live = open(path);
  ASSERT_TRUE(live);
  pushAndTake(100);
  ASSERT_TRUE(live->write({}));
  push(20'000);  // more than the ring holds, and nobody takes them
  const std::uint64_t lost = follower.lost();
  ASSERT_GT(lost, 0U);
  ASSERT_TRUE(live->close({}));
  const auto before = Recording::open(path);
  ASSERT_TRUE(before) << before.error().text();
  EXPECT_EQ((*before)->info().committed_samples, 100U);
  EXPECT_EQ((*before)->info().gaps, lost) << "though no later step shows the gap";
}

TEST_F(Live, AfterACommitThatFailedNothingIsTaken) {
  station.link = [] { return LinkRow{.when = instantAt(1.0)}; };
  const auto live = open(path);
  ASSERT_TRUE(live);
  pushAndTake(100);
  ASSERT_TRUE(live->write({}));
  ASSERT_TRUE(live->everySecond(Clock::now()));
  disk->trouble = EIO;
  pushAndTake(150);  // the last of them makes the block that is committed
  EXPECT_THAT(refusal(live->write({})), HasSubstr("Input/output error"));
  disk->trouble = 0;
  EXPECT_THAT(refusal(live->write({{.when = begun, .text = "a note"}})), HasSubstr("nothing more can be recorded"));
  const auto second = live->everySecond(Clock::now() + std::chrono::hours(1));
  ASSERT_FALSE(second) << "the link's row";
  EXPECT_THAT(second.error().text(), HasSubstr("nothing more can be recorded"));
  offer(begun, 1);
  EXPECT_THAT(refusal(live->write({})), HasSubstr("nothing more can be recorded")) << "a picture";
  pushAndTake(1);
  EXPECT_THAT(refusal(live->write({})), HasSubstr("nothing more can be recorded")) << "a step";
  EXPECT_THAT(refusal(live->close({})), HasSubstr("nothing more can be recorded"));
  EXPECT_FALSE(std::filesystem::exists(path));
  const auto left = Recording::open(partialOf(path));
  ASSERT_TRUE(left) << left.error().text();
  EXPECT_EQ((*left)->info().committed_samples, 0U);
  EXPECT_EQ((*left)->info().frames, 0U);
  EXPECT_TRUE((*left)->notes()->empty());
  EXPECT_TRUE((*left)->linkRows()->empty());
}

TEST_F(Live, ADiskThatFailsWhileTheRestIsWrittenLeavesWhatWasCommitted) {
  auto live = open(path);
  ASSERT_TRUE(live);
  pushAndTake(600);
  ASSERT_TRUE(live->write({})) << "400 of them: a turn";
  EXPECT_DOUBLE_EQ(live->committed_s(), 0.249) << "when its last step was taken";
  disk->trouble = ENOSPC;
  EXPECT_THAT(refusal(live->close({})), HasSubstr("No space left on device"));
  live.reset();
  EXPECT_FALSE(std::filesystem::exists(path));
  const auto left = Recording::open(partialOf(path));
  ASSERT_TRUE(left) << left.error().text();
  EXPECT_EQ((*left)->info().committed_samples, 250U);
}

TEST_F(Live, OfAFastCameraNoPictureIsFartherFromAWholeOneThanAReaderLooks) {
  pushAndTake(5000);
  const auto live = open(path, 0.1);
  ASSERT_TRUE(live);
  while (follower.history().unread() > 0) ASSERT_TRUE(live->write({}));
  constexpr std::uint64_t kMany = kFarthestWhole + 10;
  for (std::uint64_t i = 0; i < kMany; ++i) offer(begun + std::chrono::milliseconds(1 + i), i);
  ASSERT_TRUE(live->close({}));
  const auto recording = Recording::open(path);
  ASSERT_TRUE(recording) << recording.error().text();
  ASSERT_EQ((*recording)->info().frames, kMany);
  for (const std::uint64_t i : {kFarthestWhole, kFarthestWhole + 1, kMany - 1}) {
    const auto picture = (*recording)->picture(i);
    ASSERT_TRUE(picture) << picture.error().text();
    EXPECT_FALSE(picture->whole.empty()) << i;
  }
}

TEST_F(Live, PicturesOfOneInstantAndOlderOnesAreEachWhole) {
  pushAndTake(200);
  const auto live = open(path);
  ASSERT_TRUE(live);
  ASSERT_TRUE(live->write({}));
  constexpr std::array kTaken_ms{50, 50, 40, 60};  // a camera's clock that stands, and goes back
  for (std::size_t i = 0; i < kTaken_ms.size(); ++i) offer(begun + std::chrono::milliseconds(kTaken_ms[i]), i);
  ASSERT_TRUE(live->close({}));
  const auto recording = DamagedRecording::open(path);  // gives pictures as they stand in the file
  ASSERT_TRUE(recording) << recording.error().text();
  ASSERT_EQ((*recording)->info().frames, kTaken_ms.size());
  constexpr std::array kWhole{true, true, true, false};  // the last comes 20 ms after one that is
  for (std::size_t i = 0; i < kWhole.size(); ++i) {
    const auto picture = (*recording)->encodedPicture(i);
    ASSERT_TRUE(picture) << picture.error().text();
    EXPECT_EQ(picture->number, i);
    EXPECT_EQ(!picture->whole.empty(), kWhole[i]) << i;
    EXPECT_FALSE(picture->region.empty()) << i;
  }
}

}  // namespace
}  // namespace fyd::recording
