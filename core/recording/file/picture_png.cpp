#include "core/recording/file/picture_png.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>

#include <opencv2/core.hpp>

#include "core/base/checksum.h"
#include "core/base/codecs/codecs.h"
#include "core/recording/file/quick_deflate.h"

namespace fyd::recording {
namespace {

constexpr std::array<std::uint8_t, 8> kPngSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
constexpr std::uint8_t kDepth_bit = 8;
constexpr std::uint8_t kGrey = 0;
constexpr std::uint8_t kColour = 2;
constexpr std::byte kSubFilter{1};  // each byte less its left neighbour: as good as any on a noisy sensor, and quick

void putNumber(std::vector<std::uint8_t>& out, std::uint32_t value) {
  for (const int shift : {24, 16, 8, 0}) out.push_back(static_cast<std::uint8_t>(value >> shift));
}

void putChunk(std::vector<std::uint8_t>& out, std::string_view name, std::span<const std::byte> body) {
  putNumber(out, static_cast<std::uint32_t>(body.size()));
  const std::size_t start = out.size();
  out.insert(out.end(), name.begin(), name.end());
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(body.data());
  out.insert(out.end(), bytes, bytes + body.size());
  putNumber(out, crc32(std::as_bytes(std::span(out).subspan(start))));
}

// OpenCV keeps blue first, PNG red first.
void swapColours(std::span<std::byte> row) {
  for (std::size_t i = 0; i + 2 < row.size(); i += 3) std::swap(row[i], row[i + 2]);
}

std::vector<std::byte> filtered(const cv::Mat& picture) {
  const auto channels = static_cast<std::size_t>(picture.channels());
  const std::size_t width = static_cast<std::size_t>(picture.cols) * channels;
  std::vector<std::byte> out((width + 1) * static_cast<std::size_t>(picture.rows));
  std::vector<std::byte> row(width);
  for (int y = 0; y < picture.rows; ++y) {
    std::memcpy(row.data(), picture.ptr(y), width);
    if (channels == 3) swapColours(row);
    std::byte* to = out.data() + static_cast<std::size_t>(y) * (width + 1);
    *to++ = kSubFilter;
    std::copy_n(row.data(), channels, to);
    for (std::size_t i = channels; i < width; ++i)
      to[i] = static_cast<std::byte>(std::to_integer<unsigned>(row[i]) - std::to_integer<unsigned>(row[i - channels]));
  }
  return out;
}

std::vector<std::uint8_t> encodeOther(const cv::Mat& picture) {
  std::vector<std::uint8_t> out;
  try {
    codecs::encodePicture(".png", picture, out);
  } catch (const cv::Exception&) {  // a depth or number of channels that the format does not know
    out.clear();
  }
  return out;
}

}  // namespace

std::vector<std::uint8_t> encodePng(const cv::Mat& picture) {
  if (picture.empty()) return {};
  if (picture.type() != CV_8UC1 && picture.type() != CV_8UC3) return encodeOther(picture);
  std::vector<std::byte> packed;
  if (!quickDeflate(filtered(picture), packed)) return encodeOther(picture);
  std::vector<std::uint8_t> head;
  putNumber(head, static_cast<std::uint32_t>(picture.cols));
  putNumber(head, static_cast<std::uint32_t>(picture.rows));
  head.insert(head.end(), {kDepth_bit, picture.channels() == 1 ? kGrey : kColour, 0, 0, 0});
  std::vector<std::uint8_t> out(kPngSignature.begin(), kPngSignature.end());
  putChunk(out, "IHDR", std::as_bytes(std::span(head)));
  putChunk(out, "IDAT", packed);
  putChunk(out, "IEND", {});
  return out;
}

}  // namespace fyd::recording
