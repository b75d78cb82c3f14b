#include "core/base/codecs/codecs.h"

#include <fstream>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

namespace fyd::codecs {
namespace {

/// Names of the files mapped into this program.
std::string mapped() {
  std::ifstream maps("/proc/self/maps");
  return {std::istreambuf_iterator<char>(maps), {}};
}

TEST(Codecs, AreLoadedWhenTheyAreNeeded) {
  ASSERT_EQ(mapped().find("libopencv_imgcodecs"), std::string::npos);
  ASSERT_TRUE(load());
  EXPECT_NE(mapped().find("libopencv_imgcodecs"), std::string::npos);
  EXPECT_NE(mapped().find("libopencv_videoio"), std::string::npos);
}

TEST(Codecs, APngIsThePictureThatWasCoded) {
  cv::Mat picture(7, 5, CV_16UC1);
  for (int i = 0; i < 35; ++i) picture.at<std::uint16_t>(i / 5, i % 5) = static_cast<std::uint16_t>(1871 * i);
  std::vector<std::uint8_t> coded;
  ASSERT_TRUE(encodePicture(".png", picture, coded));
  const cv::Mat again = decodePicture(coded, cv::IMREAD_UNCHANGED);
  ASSERT_EQ(again.type(), CV_16UC1);
  ASSERT_EQ(again.size(), picture.size());
  for (int i = 0; i < 35; ++i) EXPECT_EQ(again.at<std::uint16_t>(i / 5, i % 5), 1871 * i % 65536);
}

TEST(Codecs, WhatIsNoPictureIsEmptyOrOpenCvsOwnError) {
  EXPECT_TRUE(decodePicture(std::vector<std::uint8_t>(100, 0x42), cv::IMREAD_UNCHANGED).empty());
  std::vector<std::uint8_t> coded;
  EXPECT_THROW(encodePicture(".nothing", cv::Mat(2, 2, CV_8UC1), coded), cv::Exception);
}

}  // namespace
}  // namespace fyd::codecs
