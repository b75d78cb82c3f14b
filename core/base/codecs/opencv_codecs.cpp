// The only file that is linked to OpenCV's coders: a library of its own (core/base/codecs/codecs.h says why).
#include "core/base/codecs/opencv_codecs.h"

#include <atomic>
#include <climits>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

extern "C" {
#include <libavutil/mem.h>
}

namespace {

using fyd::codecs::OpenCvCodecs;

/// FFmpeg makes a packet as long as the stream says it is, to 2 GB. This is more than a decoded picture of the most
/// pixels that a camera may have (96 MB). A coder's own buffers may be larger: while a video is written, anything goes.
constexpr std::size_t kLargestRead_bytes = std::size_t{128} << 20U;
std::atomic<int> g_writers{0};

void limitBlocks() { av_max_alloc(g_writers > 0 ? INT_MAX : kLargestRead_bytes); }

struct Counted {
  Counted() { ++g_writers, limitBlocks(); }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  ~Counted() { --g_writers, limitBlocks(); }
};

/// Counted before FFmpeg is asked for a coder, and until it has given it back.
class Writer final : Counted, public cv::VideoWriter {
 public:
  using cv::VideoWriter::VideoWriter;
};

constexpr OpenCvCodecs kCodecs{
    .encode = [](const std::string& ending, const cv::Mat& picture, std::vector<unsigned char>& coded,
                 const std::vector<int>& parameters) { return cv::imencode(ending, picture, coded, parameters); },
    .decode = [](const cv::Mat& bytes, int flags, cv::Mat& picture) { picture = cv::imdecode(bytes, flags); },
    .capture =
        [] {
          limitBlocks();
          return new cv::VideoCapture;
        },
    .writer = [](const std::string& path, const std::array<char, 4>& codec, double rate_Hz, const cv::Size& size,
                 bool colour) -> cv::VideoWriter* {
      const int fourcc = cv::VideoWriter::fourcc(codec[0], codec[1], codec[2], codec[3]);
      return new Writer(path, cv::CAP_FFMPEG, fourcc, rate_Hz, size, {cv::VIDEOWRITER_PROP_IS_COLOR, colour ? 1 : 0});
    },
};

}  // namespace

extern "C" __attribute__((visibility("default"))) const OpenCvCodecs* fyd_opencv_codecs() { return &kCodecs; }
