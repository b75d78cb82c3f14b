// Bytes that must not outlive their use: wiped on destruction, never printed, not comparable by accident.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <sodium/utils.h>

namespace fyd::protocol {

template <std::size_t Size>
class SecretBytes {
 public:
  SecretBytes() = default;
  explicit SecretBytes(std::span<const std::uint8_t, Size> bytes) {
    for (std::size_t i = 0; i < Size; ++i) bytes_[i] = bytes[i];
  }
  SecretBytes(const SecretBytes&) = default;
  SecretBytes& operator=(const SecretBytes&) = default;
  ~SecretBytes() { sodium_memzero(bytes_.data(), Size); }

  [[nodiscard]] const std::uint8_t* data() const { return bytes_.data(); }
  [[nodiscard]] std::uint8_t* data() { return bytes_.data(); }
  [[nodiscard]] static constexpr std::size_t size() { return Size; }
  [[nodiscard]] std::span<const std::uint8_t, Size> view() const { return bytes_; }
  [[nodiscard]] std::span<std::uint8_t, Size> view() { return bytes_; }

 private:
  std::array<std::uint8_t, Size> bytes_{};
};

/// Fills with random bytes; the ends take it as a parameter so that a test vector can be computed.
using RandomSource = void (*)(std::span<std::uint8_t> out);
/// The system's generator through libsodium.
void systemRandom(std::span<std::uint8_t> out);
/// Must have been called before any other function of libsodium; idempotent, cheap, thread-safe.
/// Ends the program when the system has no randomness: without it nothing may go on.
void prepareCryptography();

}  // namespace fyd::protocol
