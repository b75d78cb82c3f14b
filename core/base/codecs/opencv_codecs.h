// What the library of coders offers to core/base/codecs/codecs.cpp, which loads it.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace cv {
class Mat;
template <typename T>
class Size_;
class VideoCapture;
class VideoWriter;
}  // namespace cv

namespace fyd::codecs {

struct OpenCvCodecs {
  bool (*encode)(const std::string& ending, const cv::Mat& picture, std::vector<unsigned char>& coded,
                 const std::vector<int>& parameters);
  void (*decode)(const cv::Mat& bytes, int flags, cv::Mat& picture);
  cv::VideoCapture* (*capture)();
  cv::VideoWriter* (*writer)(const std::string& path, const std::array<char, 4>& codec, double rate_Hz,
                             const cv::Size_<int>& size, bool colour);
};

/// The one symbol of the library: `const OpenCvCodecs* fyd_opencv_codecs()`.
inline constexpr const char* kCodecsSymbol = "fyd_opencv_codecs";
using CodecsFunction = const OpenCvCodecs* (*)();

}  // namespace fyd::codecs
