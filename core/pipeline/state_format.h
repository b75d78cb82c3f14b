// Format of a saved state: its header and the encoding of strings. Included only by files that write or read
// states.
//
//   header      magic, digest of the local model, digest and length of all that follows
//   parameters  u16 how many; each: its id, u8 how many values, the values; a choice: 255 and its word
//   modules     u16 how many; each: its name, u16 the version of its content
//   content     of each module in that order
//
// A string is stored as one byte with its length, then its bytes; integers and doubles as in core/base/archive.h.
#pragma once

#include <array>
#include <cstdint>
#include <sstream>
#include <string>
#include <string_view>

#include <sodium/crypto_generichash.h>

#include "core/base/archive.h"
#include "core/base/error.h"

namespace fyd::pipeline {

using Digest = std::array<std::uint8_t, crypto_generichash_BYTES_MIN>;

[[nodiscard]] inline Digest digestOf(std::string_view text) {
  Digest digest{};
  crypto_generichash(digest.data(), digest.size(), reinterpret_cast<const unsigned char*>(text.data()), text.size(),
                     nullptr, 0);
  return digest;
}

struct StateHeader {
  std::array<char, 8> mark{'F', 'Y', 'D', 's', 't', 'a', 't', '2'};
  Digest local_model{};
  Digest content{};
  std::uint64_t content_bytes = 0;

  static constexpr std::size_t kBytes = 8 + 2 * sizeof(Digest) + 8;

  template <class Archive>
  void serialize(Archive& archive) {
    archive(mark, local_model, content, content_bytes);
  }
};

/// Stored in place of the number of values for a choice; its word follows.
inline constexpr std::uint8_t kWordFollows = 255;

inline void writeText(StateWriter& archive, std::string_view text) {
  if (text.size() > 255) throw std::length_error("a text too long for a state");
  archive(static_cast<std::uint8_t>(text.size()));
  archive.saveBinary(text.data(), static_cast<std::streamsize>(text.size()));
}

inline std::string readText(StateReader& archive) {
  std::uint8_t length = 0;
  archive(length);
  std::string text(length, '\0');
  archive.loadBinary(text.data(), length);
  return text;
}

/// The header followed by the content.
[[nodiscard]] inline std::string withHeader(const Digest& local_model, std::string_view content) {
  std::ostringstream bytes;
  StateWriter archive(bytes);
  archive(StateHeader{.local_model = local_model, .content = digestOf(content), .content_bytes = content.size()});
  return std::move(bytes).str().append(content);
}

}  // namespace fyd::pipeline
