// Compression of a recording: zlib's format [RFC 1950], written and read several times faster than by zlib. Any other
// reader of the format can read it; the output is at most a tenth larger than that of zlib's own fastest level.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/error.h"

namespace fyd::recording {

/// Replaces what is in `out`.
[[nodiscard]] Result<void> quickDeflate(std::span<const std::byte> plain, std::vector<std::byte>& out);

/// @return an error unless `packed` is whole, its checksum right, and fills `out` exactly
[[nodiscard]] Result<void> quickInflate(std::span<const std::byte> packed, std::span<std::byte> out);

}  // namespace fyd::recording
