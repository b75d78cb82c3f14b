// Sealed datagrams of a running session: ChaCha20-Poly1305 [RFC 8439], one key per direction, counter as nonce.
//
//   0   0xFD           mark of FYD Link
//   1   0x15           version 1 in the high four bits, kind 5 (sealed) in the low four
//   2   u16            session: first two bytes of the handshake's transcript hash, to sort datagrams cheaply
//   4   u48            counter, from 0, one more with each datagram of this direction
//   10  …              message, encrypted;   then 16 bytes of tag
//
// Nonce: four zero bytes, then the counter as u64. Bytes 0 to 9 are authenticated as well. Everything little-endian.
// The opener remembers the last 1024 counters: each is taken once, older ones never. Nothing allocates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/protocol/datagram.h"
#include "core/protocol/link/link_refusal.h"
#include "core/protocol/link/noise.h"
#include "core/protocol/link/secret.h"

namespace fyd::protocol {

inline constexpr std::uint8_t kLinkMark = 0xFD;
inline constexpr std::uint8_t kLinkVersion = 1;
enum class LinkKind : std::uint8_t { hello = 1, challenge = 2, call = 3, answer = 4, sealed = 5 };
[[nodiscard]] constexpr std::uint8_t versionAndKind(LinkKind kind) {
  return static_cast<std::uint8_t>((kLinkVersion << 4) | static_cast<std::uint8_t>(kind));
}
/// The mark, the version and a kind, in this order of refusal; the kind when all is well.
struct LinkSorted {
  LinkKind kind{};
  LinkRefusal refusal = LinkRefusal::none;
};
[[nodiscard]] LinkSorted sortDatagram(Bytes datagram);

inline constexpr std::size_t kSealHeader = 10;
inline constexpr std::size_t kSealOverhead = kSealHeader + kTagSize;
/// No datagram of FYD Link is longer.
inline constexpr std::size_t kMaximumLinkDatagram = 1'320;
inline constexpr std::uint64_t kLastCounter = (std::uint64_t{1} << 48) - 1;

/// Which of the last 1024 counters were taken.
class ReplayWindow {
 public:
  static constexpr std::uint64_t kSize = 1024;
  /// none, repeated or behind
  [[nodiscard]] LinkRefusal check(std::uint64_t counter) const;
  /// Only for a counter that `check` passed and whose datagram proved authentic.
  void take(std::uint64_t counter);
  /// One more than the newest taken; 0 before the first.
  [[nodiscard]] std::uint64_t next() const { return next_; }

 private:
  std::array<std::uint64_t, kSize / 64> taken_{};
  std::uint64_t next_ = 0;
};

class Sealer {
 public:
  Sealer() = default;
  Sealer(const SecretBytes<32>& key, std::uint16_t session, std::uint64_t first_counter = 0)
      : key_(key), session_(session), counter_(first_counter) {}

  /// Where the message to be sealed is written into `packet`.
  [[nodiscard]] static std::span<std::uint8_t> messagePart(std::span<std::uint8_t> packet) {
    return packet.subspan(kSealHeader);
  }
  /// Seals the `size` bytes there in place. @return the datagram's size; 0 when it does not fit or the counter is used
  /// up (after 2⁴⁸ datagrams: a new session is needed, a counter is never used twice)
  [[nodiscard]] std::size_t seal(std::span<std::uint8_t> packet, std::size_t size);
  [[nodiscard]] bool exhausted() const { return counter_ > kLastCounter; }
  [[nodiscard]] std::uint64_t counter() const { return counter_; }

 private:
  SecretBytes<32> key_;
  std::uint16_t session_ = 0;
  std::uint64_t counter_ = 0;
};

struct Opened {
  Bytes message;
  std::uint64_t counter = 0;
  LinkRefusal refusal = LinkRefusal::none;
  [[nodiscard]] bool ok() const { return refusal == LinkRefusal::none; }
};

class Opener {
 public:
  Opener() = default;
  Opener(const SecretBytes<32>& key, std::uint16_t session) : key_(key), session_(session) {}

  /// Checks, decrypts into `out` and marks the counter as taken. What is refused changes nothing.
  [[nodiscard]] Opened open(Bytes datagram, std::span<std::uint8_t> out);
  [[nodiscard]] const ReplayWindow& window() const { return window_; }

 private:
  SecretBytes<32> key_;
  std::uint16_t session_ = 0;
  ReplayWindow window_;
};

}  // namespace fyd::protocol
