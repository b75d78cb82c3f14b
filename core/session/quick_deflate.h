// zlib's format (RFC 1950), written and read several times quicker than zlib does it: what compresses a recording. Any
// other reader of the format takes it; the same data grow by a tenth or less beside zlib's own quickest level.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/error.h"

namespace fyd::session {

/// Replaces what is in `out`.
[[nodiscard]] Result<void> quickDeflate(std::span<const std::byte> plain, std::vector<std::byte>& out);

/// @return an error unless `packed` is whole, its checksum right, and fills `out` exactly
[[nodiscard]] Result<void> quickInflate(std::span<const std::byte> packed, std::span<std::byte> out);

/// CRC-32 as PNG has it.
[[nodiscard]] std::uint32_t crc32Png(std::span<const std::byte> bytes);

}  // namespace fyd::session
