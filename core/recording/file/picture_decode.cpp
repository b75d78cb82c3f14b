#include "core/recording/file/picture_decode.h"

#include <algorithm>
#include <array>
#include <opencv2/imgcodecs.hpp>

#include "core/base/codecs/codecs.h"
#include "core/recording/file/recording_hdf5.h"

namespace fyd::recording {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kPng{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::array<std::uint8_t, 4> kHead{'I', 'H', 'D', 'R'};
constexpr std::array<std::uint8_t, 2> kJpeg{0xFF, 0xD8};

template <std::size_t N>
bool stands(Bytes bytes, std::size_t at, const std::array<std::uint8_t, N>& wanted) {
  return bytes.size() >= at + N &&
         std::equal(wanted.begin(), wanted.end(), bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

std::uint32_t bigEndian(Bytes bytes) {
  std::uint32_t value = 0;
  for (const std::uint8_t byte : bytes) value = value << 8U | byte;
  return value;
}

std::optional<cv::Size> sized(std::uint32_t width, std::uint32_t height) {
  constexpr std::uint32_t kLongestSide = 1U << 20U;  // so that their product cannot overflow
  if (width == 0 || height == 0 || width > kLongestSide || height > kLongestSide) return std::nullopt;
  return cv::Size(static_cast<int>(width), static_cast<int>(height));
}

constexpr std::uint8_t kMarker = 0xFF;

/// Whether a length follows the marker, for every decoder. Behind others (FF01, FFD0…FFD7) a decoder goes on with the
/// next marker, which may be another frame than the one that stands where a length would lead.
bool hasLength(std::uint8_t kind) {
  constexpr std::uint8_t kHuffman = 0xC4, kArithmetic = 0xCC, kQuantization = 0xDB, kRestart = 0xDD;
  constexpr std::uint8_t kApplication = 0xE0, kLastApplication = 0xEF, kComment = 0xFE;
  return kind == kHuffman || kind == kArithmetic || kind == kQuantization || kind == kRestart || kind == kComment ||
         (kind >= kApplication && kind <= kLastApplication);
}

/// Whether no more scans follow than a baseline picture has components: each scan is as much work as the whole picture.
bool hasFewScans(Bytes bytes) {
  constexpr std::uint8_t kScan = 0xDA;
  constexpr int kMostScans = 4;
  int scans = 0;
  for (std::size_t at = 0; at + 1 < bytes.size(); ++at)
    if (bytes[at] == kMarker && bytes[at + 1] == kScan && ++scans > kMostScans) return false;
  return true;
}

/// Follows the markers up to the frame header (SOF). Refuses progressive JPEGs, which may hold a thousand full scans.
std::optional<cv::Size> jpegSize(Bytes bytes) {
  constexpr std::uint8_t kBaseline = 0xC0;
  for (std::size_t at = 2; at + 9 <= bytes.size();) {
    const std::uint8_t kind = bytes[at + 1];
    if (bytes[at] != kMarker) return std::nullopt;
    if (kind == kMarker) {  // filling
      ++at;
      continue;
    }
    if (kind == kBaseline) {
      if (!hasFewScans(bytes.subspan(at))) return std::nullopt;
      return sized(bigEndian(bytes.subspan(at + 7, 2)), bigEndian(bytes.subspan(at + 5, 2)));
    }
    const std::uint32_t length = bigEndian(bytes.subspan(at + 2, 2));  // counts itself
    if (!hasLength(kind) || length < 2) return std::nullopt;
    at += 2 + length;
  }
  return std::nullopt;
}

}  // namespace

std::optional<cv::Size> pictureSize(Bytes bytes) {
  constexpr std::size_t kHeadAt = 12, kSizeAt = 16, kSizeEnd = 24;
  if (stands(bytes, 0, kPng) && stands(bytes, kHeadAt, kHead) && bytes.size() >= kSizeEnd)
    return sized(bigEndian(bytes.subspan(kSizeAt, 4)), bigEndian(bytes.subspan(kSizeAt + 4, 4)));
  if (stands(bytes, 0, kJpeg)) return jpegSize(bytes);
  return std::nullopt;
}

cv::Mat decodePicture(Bytes bytes, const char* what) {
  if (bytes.empty()) return {};
  const auto size = pictureSize(bytes);
  if (!size) failHard("{}: its {} bytes are no picture as the recorder writes it", what, bytes.size());
  if (static_cast<std::int64_t>(size->width) * size->height > kMostPixels)
    failHard("{}: {} × {} pixels; at most {} are read", what, size->width, size->height, kMostPixels);
  cv::Mat picture;
  try {
    picture = codecs::decodePicture(bytes, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception& error) {
    failHard(about(what, verbatim(error.what())));
  }
  if (picture.empty()) failHard("{}: its {} bytes are no picture", what, bytes.size());
  return picture;
}

}  // namespace fyd::recording
