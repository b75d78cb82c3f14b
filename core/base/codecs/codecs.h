// OpenCV's coders of pictures and videos, loaded when they are first needed.
//
// They bring some 180 other libraries with them (GDAL, FFmpeg, GStreamer), which took five sixths of each start of a
// program. Whoever needs the coders in real time calls load() before.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

#include "core/base/error.h"

namespace cv {
class VideoCapture;
class VideoWriter;
}  // namespace cv

namespace fyd::codecs {

/// So that none of the functions below takes longer the first time.
/// @return an error when the library of the coders is not there or not whole
[[nodiscard]] Result<void> load();

// What follows throws cv::Exception where OpenCV does, and when the coders' own library is not installed.

/// cv::imencode. @param ending with its dot: ".png", ".jpg"
bool encodePicture(const std::string& ending, const cv::Mat& picture, std::vector<std::uint8_t>& coded,
                   const std::vector<int>& parameters = {});

/// cv::imdecode. @return empty: no picture that OpenCV knows @param flags cv::ImreadModes
[[nodiscard]] cv::Mat decodePicture(std::span<const std::uint8_t> bytes, int flags);

/// A closed one; all that it does is virtual, so that its header is enough.
[[nodiscard]] std::unique_ptr<cv::VideoCapture> videoCapture();

/// One that writes by FFmpeg; not open where it cannot.
/// @param codec its four characters: "FFV1", "MJPG"
[[nodiscard]] std::unique_ptr<cv::VideoWriter> videoWriter(const std::string& path, const std::array<char, 4>& codec,
                                                           double rate_Hz, cv::Size size, bool colour);

}  // namespace fyd::codecs
