#include "core/device/camera/picture_decoder.h"

#include <memory>
#include <vector>

#include <turbojpeg.h>
#include <opencv2/imgcodecs.hpp>

#include "core/base/codecs/codecs.h"
#include "core/base/whole_file.h"

namespace fyd::device {
namespace {

constexpr std::int64_t kMostPixels = 32'000'000;

struct Close {
  void operator()(void* decoder) const { tjDestroy(decoder); }
};
using Decoder = std::unique_ptr<void, Close>;

bool isJpeg(std::span<const std::uint8_t> bytes) { return bytes.size() > 1 && bytes[0] == 0xFF && bytes[1] == 0xD8; }

}  // namespace

Result<cv::Mat> decodeJpeg(std::span<const std::uint8_t> bytes, cv::Size expected) {
  // A new decoder each time: an old one would decode a picture that lost its tables with those of the picture before.
  const Decoder decoder(tjInitDecompress());
  if (!decoder) return fail("no JPEG decoder: {}", verbatim(tjGetErrorStr2(nullptr)));
  const auto refused = [&] { return fail(verbatim(tjGetErrorStr2(decoder.get()))); };
  int width = 0;
  int height = 0;
  int subsampling = 0;
  int colours = 0;
  if (tjDecompressHeader3(decoder.get(), bytes.data(), bytes.size(), &width, &height, &subsampling, &colours) != 0) {
    return refused();
  }
  if (std::int64_t{width} * height > kMostPixels) {
    return fail("{} × {} pixels, expected at most {}", width, height, kMostPixels);
  }
  if (!expected.empty() && cv::Size(width, height) != expected) {
    return fail("{} × {} pixels, expected {} × {}", width, height, expected.width, expected.height);
  }
  const bool grey = colours == TJCS_GRAY;
  cv::Mat picture(height, width, grey ? CV_8UC1 : CV_8UC3);
  if (tjDecompress2(decoder.get(), bytes.data(), bytes.size(), picture.data, width, static_cast<int>(picture.step),
                    height, grey ? TJPF_GRAY : TJPF_BGR, TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS) != 0) {
    return refused();
  }
  return picture;
}

Result<cv::Mat> readPicture(const std::string& path) {
  const auto refused = [&] { return fail("'{}' is not a picture that can be read", path); };
  const auto text = readWholeFile(path);
  if (!text) return tl::unexpected(text.error());
  const std::span bytes(reinterpret_cast<const std::uint8_t*>(text->data()), text->size());
  if (isJpeg(bytes)) {
    auto decoded = decodeJpeg(bytes);
    if (!decoded) return fail("'{}' is not a picture that can be read: {}", path, decoded.error().message);
    return decoded;
  }
  if (bytes.empty()) return refused();
  cv::Mat picture;
  try {  // these decoders refuse a file that is cut short; PNG has checksums besides
    picture = codecs::decodePicture(bytes, cv::IMREAD_ANYCOLOR);
  } catch (const cv::Exception&) {  // larger than OpenCV's limit
    picture.release();
  }
  if (picture.empty()) return refused();
  return picture;
}

}  // namespace fyd::device
