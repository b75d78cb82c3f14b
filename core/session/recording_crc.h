// CRC32C (Castagnoli), the checksum of every block of a recording.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fyd::session {

[[nodiscard]] std::uint32_t crc32c(std::span<const std::byte> bytes);
/// The same without the processor's help; for machines without it, and for tests.
[[nodiscard]] std::uint32_t crc32cInSoftware(std::span<const std::byte> bytes);

}  // namespace fyd::session
