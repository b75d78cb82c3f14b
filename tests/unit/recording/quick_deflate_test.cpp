// The fast compressor: zlib and OpenCV read its output, and damaged data are refused.
#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "core/recording/file/picture_png.h"
#include "core/recording/file/quick_deflate.h"

namespace fyd::recording {
namespace {

std::vector<std::byte> mixture(std::size_t count) {
  std::mt19937 random(3);
  std::vector<std::byte> out(count);
  for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<std::byte>(i % 50 < 25 ? random() : i / 50);
  return out;
}

TEST(QuickDeflate, GivesBackEverySize) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{272}, std::size_t{100'000}}) {
    const auto plain = mixture(count);
    std::vector<std::byte> packed;
    ASSERT_TRUE(quickDeflate(plain, packed));
    std::vector<std::byte> back(count);
    const auto done = quickInflate(packed, back);
    ASSERT_TRUE(done) << done.error().text();
    EXPECT_EQ(back, plain);
  }
}

TEST(QuickDeflate, DamagedOrCutBytesAreAnErrorNeverAnotherText) {
  const auto plain = mixture(5'000);
  std::vector<std::byte> packed;
  ASSERT_TRUE(quickDeflate(plain, packed));
  std::vector<std::byte> back(plain.size());
  for (std::size_t i = 0; i < packed.size(); i += 7) {
    auto damaged = packed;
    damaged[i] ^= std::byte{0x10};
    EXPECT_TRUE(!quickInflate(damaged, back) || back == plain) << i;
    EXPECT_FALSE(quickInflate(std::span(packed).first(i), back)) << i;
  }
  std::vector<std::byte> other(plain.size() - 1);
  EXPECT_FALSE(quickInflate(packed, other));
  other.resize(plain.size() + 1);
  EXPECT_FALSE(quickInflate(packed, other));
}

TEST(PicturePng, IsReadBackExactlyByOpenCv) {
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1}) {
    cv::Mat large(61, 83, type);
    cv::randu(large, 0, 255);
    const cv::Mat part = large(cv::Rect(3, 5, 41, 37));  // rows that do not follow one another
    const cv::Mat back = cv::imdecode(encodePng(part), cv::IMREAD_UNCHANGED);
    ASSERT_EQ(back.type(), type);
    ASSERT_EQ(back.size(), part.size());
    EXPECT_EQ(cv::norm(back, part, cv::NORM_INF), 0.0);
  }
  EXPECT_TRUE(encodePng({}).empty());
  EXPECT_TRUE(encodePng(cv::Mat(4, 4, CV_64FC2)).empty());
}

}  // namespace
}  // namespace fyd::recording
