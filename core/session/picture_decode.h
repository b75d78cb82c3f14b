// Pictures of a recording back from their bytes. A kilobyte of PNG can claim to be a gigabyte of picture, so its head
// is asked for the size before anything is unpacked.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <opencv2/core/mat.hpp>

namespace fyd::session {

/// Larger ones are neither recorded nor read: 8192 × 4096 is four times what a 4K camera gives.
inline constexpr std::int64_t kMostPixels = 8192 * 4096;

/// What the head of a PNG or of a baseline JPEG, the two kinds that are recorded, says; nothing for anything else.
[[nodiscard]] std::optional<cv::Size> pictureSize(std::span<const std::uint8_t> bytes);

/// @param what it is, for the error. @return an empty picture for no bytes
/// @throws RecordingFailure for what is no picture, of another kind, or too large
[[nodiscard]] cv::Mat decodePicture(std::span<const std::uint8_t> bytes, const char* what);

}  // namespace fyd::session
