// Pictures that declare a huge size, or are of another kind than recorded, are refused by their header.
#include "core/recording/file/picture_decode.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <string>

#include "core/recording/file/picture_png.h"
#include "core/recording/file/recording_hdf5.h"

namespace fyd::recording {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes encoded(const char* kind, const cv::Mat& picture, const std::vector<int>& options = {}) {
  Bytes out;
  cv::imencode(kind, picture, out, options);
  return out;
}

std::string errorOf(const Bytes& bytes) {
  try {
    (void)decodePicture(bytes, "the picture");
  } catch (const RecordingFailure& failure) {
    return failure.message.text();
  }
  return "";
}

TEST(PictureDecode, KnowsTheSizeOfWhatIsRecorded) {
  for (const int kind : {CV_8UC1, CV_8UC3}) {
    const cv::Mat picture(123, 457, kind, cv::Scalar(7, 8, 9));
    for (const Bytes& bytes : {encoded(".jpg", picture), encodePng(picture), encoded(".png", picture)}) {
      ASSERT_TRUE(pictureSize(bytes));
      EXPECT_EQ(*pictureSize(bytes), picture.size());
      EXPECT_EQ(decodePicture(bytes, "").size(), picture.size());
    }
  }
  EXPECT_TRUE(decodePicture({}, "").empty());
}

TEST(PictureDecode, AVastPictureIsRefusedWithItsSize) {
  Bytes png = encodePng(cv::Mat(16, 16, CV_8UC1, cv::Scalar(0)));
  png[18] = 0x75;  // 16 + 0x7500 wide
  png[22] = 0x75;
  EXPECT_THAT(errorOf(png), testing::HasSubstr("the picture: 29968 × 29968 pixels; at most 33554432 are read"));
  png[16] = 0xFF;
  EXPECT_NE(errorOf(png), "");
  Bytes jpeg = encoded(".jpg", cv::Mat(16, 16, CV_8UC1, cv::Scalar(0)));
  for (auto at = jpeg.begin(); at + 9 < jpeg.end(); ++at)
    if (at[0] == 0xFF && at[1] == 0xC0) at[5] = at[7] = 0xFF;  // the frame's height and width
  EXPECT_THAT(errorOf(jpeg), testing::HasSubstr("65296 × 65296 pixels"));
}

TEST(PictureDecode, ASmallFrameThatOnlyALengthLeadsToDoesNotHideTheOneThatIsDecoded) {
  const Bytes real = encoded(".jpg", cv::Mat(64, 48, CV_8UC1, cv::Scalar(9)), {cv::IMWRITE_JPEG_PROGRESSIVE, 1});
  Bytes bytes{0xFF, 0xD8, 0xFF, 0x01};  // TEM: a decoder goes on at the next marker
  bytes.insert(bytes.end(), real.begin() + 2, real.end());
  const std::size_t marker_as_length = std::size_t{bytes[4]} << 8U | bytes[5];
  bytes.resize(4 + marker_as_length);
  bytes.insert(bytes.end(), {0xFF, 0xC0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0});  // 8 × 8, baseline
  EXPECT_FALSE(pictureSize(bytes));
  EXPECT_NE(errorOf(bytes), "");
}

TEST(PictureDecode, MoreScansThanABaselinePictureHasAreRefused) {
  const Bytes whole = encoded(".jpg", cv::Mat(64, 64, CV_8UC3, cv::Scalar(1, 2, 3)));
  const Bytes marker{0xFF, 0xDA};
  const auto scan =
      std::search(whole.begin(), whole.end(), marker.begin(), marker.end());  // clang 14 has not that of ranges
  ASSERT_NE(scan, whole.end());
  const auto ofScans = [&](std::size_t scans) {
    Bytes out(whole.begin(), scan);
    for (std::size_t i = 0; i < scans; ++i) {  // each of one component, and empty: decoded as zeros
      const auto component = static_cast<std::uint8_t>(1 + i % 3);
      out.insert(out.end(), {0xFF, 0xDA, 0, 8, 1, component, 0, 0, 63, 0});
    }
    out.insert(out.end(), {0xFF, 0xD9});
    return out;
  };
  EXPECT_EQ(errorOf(ofScans(3)), "") << "one for each component";
  EXPECT_NE(errorOf(ofScans(30)), "");
}

TEST(PictureDecode, KindsThatAreNotRecordedAreRefused) {
  const cv::Mat picture(64, 64, CV_8UC3, cv::Scalar(1, 2, 3));
  EXPECT_NE(errorOf(encoded(".jpg", picture, {cv::IMWRITE_JPEG_PROGRESSIVE, 1})), "");
  for (const char* kind : {".bmp", ".tiff", ".ppm"}) EXPECT_NE(errorOf(encoded(kind, picture)), "") << kind;
  EXPECT_NE(errorOf(Bytes(100, 0xFF)), "");
  const Bytes whole = encoded(".jpg", picture);
  for (std::size_t keep = 0; keep < whole.size(); keep += 3)
    (void)errorOf(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(keep)));
}

}  // namespace
}  // namespace fyd::recording
