// Checksums of recordings and exported files, by ISA-L.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fyd {

/// CRC32C (Castagnoli): of every block of a recording.
[[nodiscard]] std::uint32_t crc32c(std::span<const std::byte> bytes);

/// CRC-32 as PNG, gzip and MCAP define it.
[[nodiscard]] std::uint32_t crc32(std::span<const std::byte> bytes);

}  // namespace fyd
