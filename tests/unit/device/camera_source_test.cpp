#include "core/device/camera_source.h"

#include <cstdio>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "core/device/pacer.h"

namespace fyd::device {
namespace {

namespace fs = std::filesystem;

class CameraSource : public ::testing::Test {
 protected:
  CameraSource() : folder_(fs::temp_directory_path() / fmt::format("fyd_camera_{}", ::getpid())) {
    fs::create_directories(folder_);
  }
  ~CameraSource() override { fs::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Frames whose grey is 10, 20, 30 …
  void writeVideo(const std::string& name, int frames, double rate_Hz) const {
    cv::VideoWriter writer(path(name), cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), rate_Hz, {320, 240});
    ASSERT_TRUE(writer.isOpened());
    for (int i = 1; i <= frames; ++i) writer.write(cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(10.0 * i)));
  }
  void writePicture(const std::string& name, int grey, int type = CV_8UC1) const {
    ASSERT_TRUE(cv::imwrite(path(name), cv::Mat(240, 320, type, cv::Scalar::all(grey))));
  }

  static std::string errorOf(const std::string& source) {
    const auto camera = openCamera(source);
    return camera ? "opened " + (*camera)->description() : camera.error().message;
  }
  static int greyOf(const CameraFrame& frame) {
    return frame.picture.at<std::uint8_t>(120, 160 * frame.picture.channels());
  }

  fs::path folder_;
};

using ::testing::HasSubstr;

TEST_F(CameraSource, SaysWhatItLookedForAndWhatThereIs) {
  EXPECT_THAT(errorOf("97"), HasSubstr("camera device 97: there is no /dev/video97; capture devices found: "));
  EXPECT_THAT(errorOf("/dev/video97"),
              HasSubstr("camera device '/dev/video97': there is none; capture devices found: "));
  EXPECT_THAT(errorOf(path("missing.avi")),
              HasSubstr("missing.avi': no such file or folder; expected a device number"));
  EXPECT_THAT(errorOf(""), HasSubstr("camera '': no such file"));
  EXPECT_THAT(errorOf("-1"), HasSubstr("camera '-1': no such file"));
  EXPECT_THAT(errorOf("/dev/null"), HasSubstr("camera device '/dev/null': does not open"));
  EXPECT_THAT(errorOf(folder_.string()), HasSubstr("no pictures; expected .png"));
  EXPECT_THAT(errorOf("http://127.0.0.1:9/none.mjpg"),
              HasSubstr("camera stream 'http://127.0.0.1:9/none.mjpg': does not open"));
  std::ofstream(path("letter.avi")) << "this is no video\n";
  EXPECT_THAT(errorOf(path("letter.avi")), HasSubstr("letter.avi': does not open; expected a video"));
}

TEST_F(CameraSource, FolderGivesItsPicturesByNameAndStartsAgain) {
  writePicture("b.png", 20);
  writePicture("a.PNG", 10);
  writePicture("c.pgm", 0);  // black: passed on
  std::ofstream(path("notes.txt")) << "no picture";
  auto camera = openCamera(folder_.string());
  ASSERT_TRUE(camera) << camera.error().message;
  EXPECT_THAT((*camera)->description(), HasSubstr("3 pictures at 30 fps, repeating"));
  Instant last{};
  for (const int grey : {10, 20, 0, 10}) {
    const auto frame = (*camera)->next();
    ASSERT_TRUE(frame) << frame.error().message;
    EXPECT_EQ(greyOf(*frame), grey);
    EXPECT_EQ(frame->picture.depth(), CV_8U);
    EXPECT_GT(frame->taken, last);
    last = frame->taken;
  }
}

TEST_F(CameraSource, AnUnreadablePictureIsNamedAndTheNextOneFollows) {
  std::ofstream(path("a.png")) << "broken";
  writePicture("b.png", 20, CV_16UC1);
  auto camera = openCamera(folder_.string());
  ASSERT_TRUE(camera);
  const auto broken = (*camera)->next();
  ASSERT_FALSE(broken);
  EXPECT_THAT(broken.error().message, HasSubstr("a.png' is not a picture"));
  const auto frame = (*camera)->next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->picture.depth(), CV_8U) << "16-bit pictures come as 8 bit";
  EXPECT_EQ(frame->number, 1U);
}

TEST_F(CameraSource, AnEmptiedFolderIsAnErrorAndItsReturnIsSeen) {
  writePicture("a.png", 10);
  auto camera = openCamera(folder_.string());
  ASSERT_TRUE(camera);
  ASSERT_TRUE((*camera)->next());
  fs::remove(path("a.png"));
  EXPECT_FALSE((*camera)->next());
  writePicture("b.png", 30);
  const auto frame = (*camera)->next();
  ASSERT_TRUE(frame) << frame.error().message;
  EXPECT_EQ(greyOf(*frame), 30);
}

TEST_F(CameraSource, VideoPlaysAtItsOwnRateAndStartsAgain) {
  writeVideo("three.avi", 3, 50.0);
  auto camera = openCamera(path("three.avi"));
  ASSERT_TRUE(camera) << camera.error().message;
  EXPECT_THAT((*camera)->description(), HasSubstr("320 × 240 at 50 fps, repeating"));
  Instant first{};
  for (int i = 0; i < 7; ++i) {
    const auto frame = (*camera)->next();
    ASSERT_TRUE(frame) << frame.error().message;
    EXPECT_NEAR(greyOf(*frame), 10 * (i % 3 + 1), 2) << "frame " << i;
    EXPECT_EQ(frame->number, static_cast<std::uint64_t>(i + 1));
    if (i == 0) first = frame->taken;
    EXPECT_GE(frame->taken - first, std::chrono::milliseconds(20) * i - std::chrono::milliseconds(20)) << "not faster";
  }
}

TEST_F(CameraSource, AVideoThatVanishesFailsAndComesBack) {
  writeVideo("short.avi", 1, 100.0);
  auto camera = openCamera(path("short.avi"));
  ASSERT_TRUE(camera);
  ASSERT_TRUE((*camera)->next());
  fs::rename(path("short.avi"), path("elsewhere.avi"));
  const auto gone = (*camera)->next();
  ASSERT_FALSE(gone);
  EXPECT_THAT(gone.error().message, HasSubstr("short.avi"));
  fs::rename(path("elsewhere.avi"), path("short.avi"));
  const auto back = (*camera)->next();
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->number, 2U);
}

TEST_F(CameraSource, AStreamThatEndsFailsAndIsOpenedAgainLater) {
  writeVideo("stream.avi", 2, 100.0);
  auto camera = openCamera("file://" + path("stream.avi"));
  ASSERT_TRUE(camera) << camera.error().message;
  ASSERT_TRUE((*camera)->next());
  ASSERT_TRUE((*camera)->next());
  const auto ended = (*camera)->next();
  ASSERT_FALSE(ended) << "a stream does not repeat";
  EXPECT_THAT(ended.error().message, HasSubstr("stream.avi': gives no picture any more"));
  const Instant before = Clock::now();
  const auto again = (*camera)->next();
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->number, 3U);
  EXPECT_GE(Clock::now() - before, std::chrono::milliseconds(900)) << "not in a busy loop";
}

TEST_F(CameraSource, FailuresAreNotPrintedByLibraries) {
  ::testing::internal::CaptureStderr();
  std::ofstream(path("letter.avi")) << "this is no video\n";
  EXPECT_FALSE(openCamera(path("letter.avi")));
  EXPECT_FALSE(openCamera("/dev/null"));
  EXPECT_FALSE(openCamera("rtsp://127.0.0.1:9/none"));
  std::fflush(stderr);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(Pacer, RatesThatMakeNoSenseCountAsTheUsualOne) {
  EXPECT_EQ(Pacer(25.0).rate_Hz(), 25.0);
  EXPECT_EQ(Pacer(0.0).rate_Hz(), 30.0);
  EXPECT_EQ(Pacer(-1.0).rate_Hz(), 30.0);
  EXPECT_EQ(Pacer(std::nan("")).rate_Hz(), 30.0);
  EXPECT_EQ(Pacer(90000.0).rate_Hz(), 30.0) << "a container's time base, not a rate";
  EXPECT_EQ(Pacer(0.1).rate_Hz(), 1.0) << "next() must not wait longer than about a second";
}

}  // namespace
}  // namespace fyd::device
