// The only file that is linked to OpenCV's coders: a library of its own (core/base/codecs/codecs.h says why).
#include "core/base/codecs/opencv_codecs.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

namespace {

using fyd::codecs::OpenCvCodecs;

constexpr OpenCvCodecs kCodecs{
    .encode = [](const std::string& ending, const cv::Mat& picture, std::vector<unsigned char>& coded,
                 const std::vector<int>& parameters) { return cv::imencode(ending, picture, coded, parameters); },
    .decode = [](const cv::Mat& bytes, int flags, cv::Mat& picture) { picture = cv::imdecode(bytes, flags); },
    .capture = [] { return new cv::VideoCapture; },
    .writer =
        [](const std::string& path, const std::array<char, 4>& codec, double rate_Hz, const cv::Size& size,
           bool colour) {
          const int fourcc = cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]);
          return new cv::VideoWriter(path, cv::CAP_FFMPEG, fourcc, rate_Hz, size,
                                     {cv::VIDEOWRITER_PROP_IS_COLOR, colour ? 1 : 0});
        },
};

}  // namespace

extern "C" __attribute__((visibility("default"))) const OpenCvCodecs* fyd_opencv_codecs() { return &kCodecs; }
