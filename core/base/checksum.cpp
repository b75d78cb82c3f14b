#include "core/base/checksum.h"

#include <isa-l/crc.h>

#include <algorithm>

namespace fyd {
namespace {

constexpr std::size_t kAtOnce = std::size_t{1} << 30U;  // the library takes an int

std::uint8_t* bytesOf(std::span<const std::byte> bytes) {
  return const_cast<std::uint8_t*>(reinterpret_cast<const std::uint8_t*>(bytes.data()));  // it only reads them
}

}  // namespace

// The library leaves inverting the start value and the result to the caller.
std::uint32_t crc32c(std::span<const std::byte> bytes) {
  std::uint32_t crc = 0xFFFFFFFFU;
  while (!bytes.empty()) {
    const auto piece = bytes.first(std::min(bytes.size(), kAtOnce));
    crc = crc32_iscsi(bytesOf(piece), static_cast<int>(piece.size()), crc);
    bytes = bytes.subspan(piece.size());
  }
  return ~crc;
}

std::uint32_t crc32(std::span<const std::byte> bytes) { return crc32_gzip_refl(0, bytesOf(bytes), bytes.size()); }

}  // namespace fyd
