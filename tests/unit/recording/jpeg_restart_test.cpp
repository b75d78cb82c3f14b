// A JPEG with restart markers, as some cameras write it.
#include <algorithm>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "core/recording/file/picture_decode.h"

namespace fyd::recording {
namespace {

TEST(JpegRestart, TheIntervalBeforeTheFrameIsSteppedOver) {
  cv::Mat picture(48, 64, CV_8UC1);
  cv::randu(picture, 0, 255);
  std::vector<std::uint8_t> bytes;
  ASSERT_TRUE(cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_RST_INTERVAL, 2}));
  const std::vector<std::uint8_t> interval{0xFF, 0xDD, 0, 4, 0, 2};  // DRI: its length, and two blocks
  ASSERT_NE(std::search(bytes.begin(), bytes.end(), interval.begin(), interval.end()), bytes.end());
  EXPECT_EQ(pictureSize(bytes), picture.size());
  // libjpeg puts it behind the frame; other encoders before.
  bytes.insert(bytes.begin() + 2, interval.begin(), interval.end());  // behind SOI
  EXPECT_EQ(pictureSize(bytes), picture.size());
  EXPECT_EQ(cv::norm(decodePicture(bytes, ""), cv::imdecode(bytes, cv::IMREAD_UNCHANGED), cv::NORM_INF), 0.0);
}

}  // namespace
}  // namespace fyd::recording
