// The secret both ends of FYD Link share: a pairing code of 128 random bits, as 13 words or as a key file.
//
//   code   128 random bits ‖ 15 bits of BLAKE2b over them = 143 bits = 13 words of 11 bits, highest bits first
//   word   consonant (4 bits), vowel (2), consonant (4), final vowel (1): "bado", "zivo"; a table of syllables, no list
//   master = BLAKE2b-256(code, key "FYD Link pairing code, version 1")
//   keys   = crypto_kdf(master, context "FYDLink1", number): 1 handshake, 2 hello, 3 challenge, 4 fingerprint
//
// A key file is text: comment lines that begin with '#', the line "fyd-link-key 1", the line with the words.
// Messages of errors never contain a word of a code. What holds a code or a key wipes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/protocol/link/secret.h"

namespace fyd::protocol {

inline constexpr std::size_t kPairingWords = 13;

class LinkKey {
 public:
  [[nodiscard]] static LinkKey generate(RandomSource random = systemRandom);
  [[nodiscard]] static LinkKey fromCode(const SecretBytes<16>& code);
  /// Words in any case, separated by spaces, hyphens or line ends.
  /// @return an error: number of words, which word is not one (by its place), or a checksum that does not fit
  [[nodiscard]] static Result<LinkKey> parseWords(std::string_view text);
  /// @param name of the file, for the error
  [[nodiscard]] static Result<LinkKey> parseFile(std::string_view text, std::string_view name);

  /// For the operator's eyes and the key file; the caller wipes it (see `wipe`).
  [[nodiscard]] std::string words() const;
  [[nodiscard]] std::string fileText() const;
  /// Eight hexadecimal digits by which two people compare their keys without telling them.
  [[nodiscard]] std::string fingerprint() const;

  [[nodiscard]] const SecretBytes<32>& handshakeKey() const { return handshake_; }
  [[nodiscard]] const SecretBytes<32>& helloKey() const { return hello_; }
  [[nodiscard]] const SecretBytes<32>& challengeKey() const { return challenge_; }

 private:
  LinkKey() = default;
  SecretBytes<16> code_;
  SecretBytes<32> handshake_;
  SecretBytes<32> hello_;
  SecretBytes<32> challenge_;
  SecretBytes<32> fingerprint_;
};

/// Overwrites text that held words.
void wipe(std::string& text);

}  // namespace fyd::protocol
