// Camera sources and picture decoding: folders, videos, streams, damaged and hostile pictures.
#include "core/device/camera/camera_source.h"

#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include "core/device/camera/picture_decoder.h"
#include "core/device/pacer.h"
#include "core/device/stable_name.h"

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
    return camera ? "opened " + (*camera)->description().text() : camera.error().text();
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
  ASSERT_TRUE(camera) << camera.error().text();
  EXPECT_THAT((*camera)->description().text(), HasSubstr("3 pictures at 30 fps, repeating"));
  Instant last{};
  for (const int grey : {10, 20, 0, 10}) {
    const auto frame = (*camera)->next();
    ASSERT_TRUE(frame) << frame.error().text();
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
  EXPECT_THAT(broken.error().text(), HasSubstr("a.png' is not a picture"));
  const auto frame = (*camera)->next();
  ASSERT_TRUE(frame);
  EXPECT_EQ(frame->picture.depth(), CV_8U) << "16-bit pictures come as 8 bit";
  EXPECT_EQ(frame->number, 1U);
}

/// A noisy grey picture as a JPEG, and what happens to it on its way.
std::vector<std::uint8_t> jpegOf(int seed, int quality = 92) {
  cv::Mat picture(240, 320, CV_8UC1);
  cv::RNG random(static_cast<std::uint64_t>(seed));
  random.fill(picture, cv::RNG::NORMAL, 200, 3);
  std::vector<std::uint8_t> out;
  cv::imencode(".jpg", picture, out, {cv::IMWRITE_JPEG_QUALITY, quality});
  return out;
}
void write(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}
std::vector<std::uint8_t> cut(std::vector<std::uint8_t> bytes, double share) {
  bytes.resize(static_cast<std::size_t>(share * static_cast<double>(bytes.size())));
  return bytes;
}

TEST_F(CameraSource, AThirdOfAPictureIsRefusedWhateverItsKind) {
  for (const char* ending : {".png", ".jpg", ".bmp", ".pgm", ".tif"}) {
    std::vector<std::uint8_t> whole;
    ASSERT_TRUE(cv::imencode(ending, cv::imdecode(jpegOf(1), cv::IMREAD_GRAYSCALE), whole));
    write(path(std::string("a") + ending), whole);
    ASSERT_TRUE(readPicture(path(std::string("a") + ending))) << ending;
    for (const double share : {0.0, 0.01, 0.34, 0.9, 0.999}) {
      write(path(std::string("a") + ending), cut(whole, share));
      const auto read = readPicture(path(std::string("a") + ending));
      EXPECT_FALSE(read) << share << " of a " << ending;
    }
    fs::remove(path(std::string("a") + ending));
  }
  write(path("a.jpg"), cut(jpegOf(1), 0.34));
  auto camera = openCamera(folder_.string());
  ASSERT_TRUE(camera);
  const auto frame = (*camera)->next();
  ASSERT_FALSE(frame);
  EXPECT_THAT(frame.error().text(), HasSubstr("a.jpg' is not a picture that can be read: Premature end of JPEG"));
}

TEST(PictureDecoder, WholeJpegsOfEveryUsualKindAreRead) {
  cv::Mat colour(240, 320, CV_8UC3);
  cv::RNG(7).fill(colour, cv::RNG::NORMAL, 200, 3);
  for (const int quality : {10, 50, 75, 92, 100}) {
    for (const int progressive : {0, 1}) {
      for (const int restart : {0, 20}) {
        for (const int channels : {1, 3}) {
          cv::Mat picture = colour;
          if (channels == 1) cv::extractChannel(colour, picture, 0);
          std::vector<std::uint8_t> bytes;
          ASSERT_TRUE(cv::imencode(".jpg", picture, bytes,
                                   {cv::IMWRITE_JPEG_QUALITY, quality, cv::IMWRITE_JPEG_PROGRESSIVE, progressive,
                                    cv::IMWRITE_JPEG_RST_INTERVAL, restart}));
          for (const std::size_t padding : {0U, 1U, 100U}) {  // as drivers and containers add
            bytes.resize(bytes.size() + padding);
            const auto read = decodeJpeg(bytes);
            ASSERT_TRUE(read) << quality << progressive << restart << channels << ": " << read.error().text();
            EXPECT_EQ(read->channels(), channels);
            EXPECT_LT(cv::norm(*read, cv::imdecode(bytes, cv::IMREAD_ANYCOLOR), cv::NORM_INF), 3.0);
          }
        }
      }
    }
  }
}

TEST_F(CameraSource, ThePasswordOfAUrlIsNotShown) {
  EXPECT_EQ(withoutSecrets("rtsp://lab:s3cret@10.0.0.5/live"), "rtsp://10.0.0.5/live");
  EXPECT_EQ(withoutSecrets("http://lab:s3cr@et@camera:8080"), "http://camera:8080");
  EXPECT_EQ(withoutSecrets("rtsp://lab@[::1]:554/a@b?c=d@e"), "rtsp://[::1]:554/a@b?c=d@e");
  for (const char* whole :
       {"rtsp://10.0.0.5/a@b", "http://camera?user=a@b", "/dev/video0", "id=A@B", "press@home.avi", ""}) {
    EXPECT_EQ(withoutSecrets(whole), whole);
  }
}

TEST(PictureDecoder, HostileSizesAndNoJpegAreRefused) {
  std::vector<std::uint8_t> bytes = jpegOf(1);
  for (std::size_t i = 0; i + 8 < bytes.size(); ++i) {
    if (bytes[i] != 0xFF || bytes[i + 1] != 0xC0) continue;
    std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(i) + 5, 4, std::uint8_t{0xFE});  // height and width
    break;
  }
  EXPECT_THAT(decodeJpeg(bytes).error().text(), HasSubstr("65278 × 65278 pixels, expected at most"));
  EXPECT_THAT(decodeJpeg(jpegOf(1), {10, 10}).error().text(), HasSubstr("pixels, expected 10 × 10"));
  EXPECT_FALSE(decodeJpeg({}));
  const std::array<std::uint8_t, 4> start = {0xFF, 0xD8, 0xFF, 0xE0};
  EXPECT_FALSE(decodeJpeg(start));
}

TEST(DamageWatch, AFewDamagedPicturesAreBorneAndMoreMakeTheSourceUnbelievable) {
  DamageWatch watch;
  watch.saw(true);
  watch.saw(true);
  EXPECT_TRUE(watch.believed());
  watch.saw(true);
  EXPECT_FALSE(watch.believed());
  for (int i = 0; i < 29; ++i) watch.saw(false);
  EXPECT_FALSE(watch.believed());
  watch.saw(false);
  EXPECT_TRUE(watch.believed()) << "the first of the three is 32 pictures ago";
  for (int i = 0; i < 320; ++i) {
    watch.saw(i % 16 == 0);
    EXPECT_TRUE(watch.believed()) << "two in 32";
  }
}

/// A stream over HTTP in which each picture is treated by the test; framing by hand, none of the project's server.
class Stream {
 public:
  using Treat = std::function<std::vector<std::uint8_t>(std::vector<std::uint8_t>, int number)>;
  explicit Stream(Treat treat) : treat_(std::move(treat)), listener_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    (void)::bind(listener_, reinterpret_cast<sockaddr*>(&address), sizeof address);
    ::listen(listener_, 4);
    socklen_t size = sizeof address;
    ::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }
  ~Stream() {
    thread_.request_stop();
    ::shutdown(listener_, SHUT_RDWR);
    thread_.join();
    ::close(listener_);
  }
  [[nodiscard]] std::string url() const { return fmt::format("http://127.0.0.1:{}/", port_); }

 private:
  void run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      const int reader = ::accept(listener_, nullptr, nullptr);
      if (reader < 0) return;
      std::array<char, 2000> request{};
      (void)::recv(reader, request.data(), request.size(), 0);
      std::string out = "HTTP/1.0 200 OK\r\nContent-Type: multipart/x-mixed-replace; boundary=picture\r\n\r\n";
      while (!stop.stop_requested()) {
        const int number = ++pictures_;
        const auto jpeg = treat_(jpegOf(number), number);
        out += fmt::format("--picture\r\nContent-Type: image/jpeg\r\nContent-Length: {}\r\n\r\n", jpeg.size());
        out.append(jpeg.begin(), jpeg.end());
        out += "\r\n";
        if (::send(reader, out.data(), out.size(), MSG_NOSIGNAL) < 0) break;
        out.clear();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      ::close(reader);
    }
  }
  Treat treat_;
  int listener_;
  std::uint16_t port_ = 0;
  int pictures_ = 0;
  std::jthread thread_;
};

TEST(CameraStream, ADamagedPictureIsPassedOverAndCounted) {
  Stream stream([](const std::vector<std::uint8_t>& jpeg, int n) { return n % 20 == 10 ? cut(jpeg, 0.34) : jpeg; });
  auto camera = openCamera(stream.url());
  ASSERT_TRUE(camera) << camera.error().text();
  for (int i = 0; i < 60; ++i) {
    const auto frame = (*camera)->next();
    ASSERT_TRUE(frame) << frame.error().text();
    cv::Scalar mean, deviation;
    cv::meanStdDev(frame->picture, mean, deviation);
    EXPECT_NEAR(deviation[0], 3.0, 1.0) << "no grey filling";
  }
  EXPECT_GE((*camera)->damaged(), 2U);
  EXPECT_LE((*camera)->damaged(), 4U);
}

TEST(CameraStream, ASourceOfDamagedPicturesIsNotBelievedAndBelievedAgainWhenItIsWhole) {
  std::atomic<bool> damaged{false};
  std::mt19937 random{5};
  Stream stream([&](std::vector<std::uint8_t> jpeg, int) {
    for (int i = 0; i < 8 && damaged; ++i) jpeg[random() % jpeg.size()] = static_cast<std::uint8_t>(random());
    return jpeg;
  });
  auto camera = openCamera(stream.url());
  ASSERT_TRUE(camera) << camera.error().text();
  ASSERT_TRUE((*camera)->next());
  damaged = true;
  int believed = 0;  // of those sent before, and of the damaged ones before three were found
  Result<CameraFrame> frame = (*camera)->next();
  for (; frame; frame = (*camera)->next()) ASSERT_LT(++believed, 60);
  EXPECT_THAT(frame.error().text(), HasSubstr("sends damaged pictures: "));
  for (int i = 0; i < 3; ++i) EXPECT_FALSE((*camera)->next()) << "some of them decode without a warning";
  damaged = false;
  const Instant end = Clock::now() + std::chrono::seconds(20);
  do frame = (*camera)->next();
  while (!frame && Clock::now() < end);
  EXPECT_TRUE(frame) << frame.error().text();
}

TEST_F(CameraSource, DamagedPicturesOfAVideoArePassedOver) {
  writeVideo("film.avi", 40, 400.0);
  std::vector<std::uint8_t> bytes;
  {
    std::ifstream file(path("film.avi"), std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(file), {});
  }
  int wiped = 0;  // the middle of two pictures
  for (std::size_t i = 0, found = 0; i + 300 < bytes.size(); ++i) {
    if (bytes[i] != 0xFF || bytes[i + 1] != 0xD8 || bytes[i + 2] != 0xFF) continue;
    ++found;
    if (found % 20 == 10) {
      std::size_t end = i + 2;
      while (bytes[end] != 0xFF || bytes[end + 1] != 0xD9) ++end;
      std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(end) - 100, 60, std::uint8_t{0x55});
      ++wiped;
    }
  }
  ASSERT_EQ(wiped, 2);
  write(path("film.avi"), bytes);
  auto camera = openCamera(path("film.avi"));
  ASSERT_TRUE(camera) << camera.error().text();
  for (int i = 0; i < 38; ++i) {
    const auto frame = (*camera)->next();
    ASSERT_TRUE(frame) << i << ": " << frame.error().text();
    double least = 0.0, most = 0.0;
    cv::Mat grey;
    cv::extractChannel(frame->picture, grey, 0);
    cv::minMaxLoc(grey, &least, &most);
    EXPECT_LT(most - least, 6.0) << "picture " << i;
  }
  EXPECT_EQ((*camera)->damaged(), 2U);
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
  ASSERT_TRUE(frame) << frame.error().text();
  EXPECT_EQ(greyOf(*frame), 30);
}

TEST_F(CameraSource, VideoPlaysAtItsOwnRateAndStartsAgain) {
  writeVideo("three.avi", 3, 50.0);
  auto camera = openCamera(path("three.avi"));
  ASSERT_TRUE(camera) << camera.error().text();
  EXPECT_THAT((*camera)->description().text(), HasSubstr("320 × 240 at 50 fps, repeating"));
  Instant first{};
  for (int i = 0; i < 7; ++i) {
    const auto frame = (*camera)->next();
    ASSERT_TRUE(frame) << frame.error().text();
    EXPECT_NEAR(greyOf(*frame), 10 * (i % 3 + 1), 2) << "frame " << i;
    EXPECT_EQ(frame->number, static_cast<std::uint64_t>(i) + 1);
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
  EXPECT_THAT(gone.error().text(), HasSubstr("short.avi"));
  fs::rename(path("elsewhere.avi"), path("short.avi"));
  const auto back = (*camera)->next();
  ASSERT_TRUE(back) << back.error().text();
  EXPECT_EQ(back->number, 2U);
}

TEST_F(CameraSource, AStreamThatEndsFailsAndIsOpenedAgainLater) {
  writeVideo("stream.avi", 2, 100.0);
  auto camera = openCamera("file://" + path("stream.avi"));
  ASSERT_TRUE(camera) << camera.error().text();
  ASSERT_TRUE((*camera)->next());
  ASSERT_TRUE((*camera)->next());
  const Instant before = Clock::now();
  const auto ended = (*camera)->next();
  ASSERT_FALSE(ended) << "a stream does not repeat";
  EXPECT_THAT(ended.error().text(), HasSubstr("stream.avi': gives no picture any more"));
  const auto again = (*camera)->next();
  ASSERT_TRUE(again) << again.error().text();
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
