// A file of text or a picture, read as a whole.
#pragma once

#include <cstdint>
#include <string>

#include "core/base/error.h"

namespace fyd {

inline constexpr std::uint64_t kLargestWholeFile_bytes = 64ULL << 20U;

/// What may be read besides a regular file. A pipe whose writer never ends is waited for, until `endSignal`.
enum class FileKind : std::uint8_t { regular, pipe_too };

/// @return an error with the path and the reason: not there, not readable, a folder, a device or a pipe where only a
/// file is taken, larger than `largest_bytes`
[[nodiscard]] Result<std::string> readWholeFile(const std::string& path,
                                                std::uint64_t largest_bytes = kLargestWholeFile_bytes,
                                                FileKind kind = FileKind::regular);

}  // namespace fyd
