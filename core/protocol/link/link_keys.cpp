#include "core/protocol/link/link_keys.h"

#include <algorithm>
#include <array>
#include <optional>

#include <sodium/crypto_generichash.h>
#include <sodium/crypto_kdf.h>

namespace fyd::protocol {
namespace {

constexpr std::string_view kFirsts = "bdfghjklmnprstvz";
constexpr std::string_view kMiddles = "aeio";
constexpr std::string_view kLasts = "ao";
constexpr std::size_t kWordLetters = 4;
constexpr unsigned kWordBits = 11;
constexpr unsigned kChecksumBits = 15;
constexpr std::string_view kFileHead = "fyd-link-key 1";
constexpr std::string_view kMasterKey = "FYD Link pairing code, version 1";
constexpr char kKdfContext[] = "FYDLink1";

static_assert(kPairingWords * kWordBits == 128 + kChecksumBits);
static_assert(kMasterKey.size() == crypto_generichash_KEYBYTES);
static_assert(sizeof kKdfContext == crypto_kdf_CONTEXTBYTES + 1);

void appendWord(std::string& out, unsigned index) {
  out += kFirsts[(index >> 7) & 15U];
  out += kMiddles[(index >> 5) & 3U];
  out += kFirsts[(index >> 1) & 15U];
  out += kLasts[index & 1U];
}

std::optional<unsigned> indexOf(std::string_view word) {
  if (word.size() != kWordLetters) return {};
  const auto place = [](std::string_view letters, char letter) {
    return letters.find(letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter);
  };
  const std::array<std::size_t, kWordLetters> places{place(kFirsts, word[0]), place(kMiddles, word[1]),
                                                     place(kFirsts, word[2]), place(kLasts, word[3])};
  if (std::ranges::find(places, std::string_view::npos) != places.end()) return {};
  return static_cast<unsigned>((places[0] << 7) | (places[1] << 5) | (places[2] << 1) | places[3]);
}

unsigned checksum(const SecretBytes<16>& code) {
  SecretBytes<crypto_generichash_BYTES_MIN> hash;
  crypto_generichash(hash.data(), hash.size(), code.data(), code.size(), nullptr, 0);
  return ((unsigned{hash.data()[0]} << 8) | hash.data()[1]) >> 1;
}

// Bit `index` of code and checksum, counted from the highest.
bool bitOf(const SecretBytes<16>& code, unsigned check, unsigned index) {
  if (index < 128) return ((code.data()[index / 8] >> (7 - index % 8)) & 1U) != 0;
  return ((check >> (kChecksumBits - 1 - (index - 128))) & 1U) != 0;
}

bool separates(char c) { return c == ' ' || c == '-' || c == '\t' || c == '\r' || c == '\n'; }

}  // namespace

LinkKey LinkKey::generate(RandomSource random) {
  prepareCryptography();
  SecretBytes<16> code;
  random(code.view());
  return fromCode(code);
}

LinkKey LinkKey::fromCode(const SecretBytes<16>& code) {
  prepareCryptography();
  LinkKey key;
  key.code_ = code;
  SecretBytes<32> master;
  crypto_generichash(master.data(), master.size(), code.data(), code.size(),
                     reinterpret_cast<const std::uint8_t*>(kMasterKey.data()), kMasterKey.size());
  std::uint64_t number = 1;
  for (SecretBytes<32>* derived : {&key.handshake_, &key.hello_, &key.challenge_, &key.fingerprint_}) {
    crypto_kdf_derive_from_key(derived->data(), derived->size(), number++, kKdfContext, master.data());
  }
  return key;
}

Result<LinkKey> LinkKey::parseWords(std::string_view text) {
  SecretBytes<16> code;
  unsigned check = 0;
  std::size_t words = 0;
  while (!text.empty()) {
    if (separates(text.front())) {
      text.remove_prefix(1);
      continue;
    }
    const auto end = std::ranges::find_if(text, separates);
    const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(word.size());
    const auto index = indexOf(word);
    if (!index) return fail("pairing code: word {} is not a pairing word; check its spelling", words + 1);
    for (unsigned i = 0; i < kWordBits && words < kPairingWords; ++i) {
      const bool bit = ((*index >> (kWordBits - 1 - i)) & 1U) != 0;
      const std::size_t place = words * kWordBits + i;
      if (place < 128) {
        code.data()[place / 8] =
            static_cast<std::uint8_t>(code.data()[place / 8] | ((bit ? 1U : 0U) << (7 - place % 8)));
      } else {
        check = (check << 1) | (bit ? 1U : 0U);
      }
    }
    ++words;
  }
  if (words != kPairingWords) return fail("pairing code: {} words; expected {}", words, kPairingWords);
  prepareCryptography();
  if (check != checksum(code)) {
    return fail("pairing code: the checksum does not fit; a word is another than it was, or the order is");
  }
  return fromCode(code);
}

Result<LinkKey> LinkKey::parseFile(std::string_view text, std::string_view name) {
  bool head_seen = false;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    std::string_view content = text.substr(0, end);
    const std::string_view rest = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    if (content.ends_with('\r')) content.remove_suffix(1);
    if (!head_seen) {
      text = rest;
      if (content.empty() || content.starts_with('#')) continue;
      if (content != kFileHead) return fail("{}, line {}: expected \"{}\"", name, line, kFileHead);
      head_seen = true;
      continue;
    }
    auto key = parseWords(text);
    if (!key) return fail("{}, from line {}: {}", name, line, key.error().message);
    return key;
  }
  return fail("{}: no {}; expected \"{}\" and {} words", name, head_seen ? say("pairing code") : say("key"), kFileHead,
              kPairingWords);
}

std::string LinkKey::words() const {
  const unsigned check = checksum(code_);
  std::string out;
  out.reserve(kPairingWords * (kWordLetters + 1));  // growing would leave an unwiped copy in a smaller buffer
  for (unsigned word = 0; word < kPairingWords; ++word) {
    unsigned index = 0;
    for (unsigned i = 0; i < kWordBits; ++i)
      index = (index << 1) | (bitOf(code_, check, word * kWordBits + i) ? 1U : 0U);
    if (word > 0) out += ' ';
    appendWord(out, index);
  }
  return out;
}

std::string LinkKey::fileText() const {
  std::string code = words();
  std::string out;
  out.reserve(300);
  out += "# Key of FYD Link. Who has it can drive the robot and the touchpad: keep it as you keep a password.\n";
  out += kFileHead;
  out += '\n';
  out += code;
  out += '\n';
  wipe(code);
  return out;
}

std::string LinkKey::fingerprint() const {
  const std::uint8_t* f = fingerprint_.data();
  return fmt::format("{:02x}{:02x}{:02x}{:02x}", f[0], f[1], f[2], f[3]);
}

void wipe(std::string& text) {
  sodium_memzero(text.data(), text.size());
  text.clear();
}

}  // namespace fyd::protocol
