// Decodes the pictures of a recording. A small PNG can declare a very large picture, so the size in its header is
// checked before anything is decompressed.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <opencv2/core/mat.hpp>

namespace fyd::recording {

/// Larger pictures are neither recorded nor read: 8192 × 4096 is four times what a 4K camera gives.
inline constexpr std::int64_t kMostPixels = std::int64_t{8192} * 4096;

/// Size from the header of a PNG or of a baseline JPEG, the two kinds that are recorded; nothing for anything else.
[[nodiscard]] std::optional<cv::Size> pictureSize(std::span<const std::uint8_t> bytes);

/// @param what it is, for the error. @return an empty picture for no bytes
/// @throws RecordingFailure for what is no picture, of another kind, or too large
[[nodiscard]] cv::Mat decodePicture(std::span<const std::uint8_t> bytes, const char* what);

}  // namespace fyd::recording
