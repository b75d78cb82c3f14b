// The four datagrams that open a session of FYD Link; the robot calls, the touchpad answers.
//
//   hello      robot → touchpad   FD 11 | nonce 16 | zero 16   | MAC 16                       50 bytes
//   challenge  touchpad → robot   FD 12 | nonce 16 | cookie 16 | MAC 16                       50 bytes
//   call       robot → touchpad   FD 13 | cookie 16 | Noise message 1 (payload: RobotHello)
//   answer     touchpad → robot   FD 14 | Noise message 2 (payload: TouchpadHello)
//
// MAC = BLAKE2b-128 over everything before it, keyed by the hello or the challenge key: the touchpad does not answer
// a sender without the key. Prologue of the handshake: the call's first 18 bytes. The touchpad keeps nothing of a
// hello: the cookie is a MAC of the sender's address and the 5 s slot of its own time under a secret of its own, taken
// in that slot and the next. Nothing allocates.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "core/protocol/datagram.h"
#include "core/protocol/link/link_keys.h"
#include "core/protocol/link/link_messages.h"
#include "core/protocol/link/noise.h"
#include "core/protocol/link/secure_channel.h"

namespace fyd::protocol {

inline constexpr std::size_t kHelloSize = 50;
inline constexpr std::size_t kCallHeader = 18;
inline constexpr std::size_t kAnswerHeader = 2;

using HelloNonce = std::array<std::uint8_t, 16>;
using Cookie = std::array<std::uint8_t, 16>;
using HelloBytes = std::array<std::uint8_t, kHelloSize>;

[[nodiscard]] HelloBytes makeHello(const LinkKey& key, const HelloNonce& nonce);
/// @return size, key or none; `nonce` only with none
[[nodiscard]] LinkRefusal readHello(const LinkKey& key, Bytes datagram, HelloNonce& nonce);
[[nodiscard]] HelloBytes makeChallenge(const LinkKey& key, const HelloNonce& nonce, const Cookie& cookie);
/// @return size, key, cookie (another hello's) or none; `cookie` only with none
[[nodiscard]] LinkRefusal readChallenge(const LinkKey& key, Bytes datagram, const HelloNonce& nonce, Cookie& cookie);

class CookieJar {
 public:
  static constexpr LinkTime kSlot_us = 5'000'000;
  explicit CookieJar(RandomSource random) { random(secret_.view()); }
  [[nodiscard]] Cookie make(const Endpoint& from, LinkTime now_us) const { return inSlot(from, now_us / kSlot_us); }
  [[nodiscard]] bool good(Bytes cookie, const Endpoint& from, LinkTime now_us) const;

 private:
  [[nodiscard]] Cookie inSlot(const Endpoint& from, std::uint64_t slot) const;
  SecretBytes<32> secret_;
};

/// The robot's half of one call.
class Caller {
 public:
  Caller(const LinkKey& key, const Cookie& cookie, RandomSource random);
  /// The call. @return its size
  [[nodiscard]] std::size_t write(Bytes payload, std::span<std::uint8_t> out);
  /// The answer's payload, opened into `out`; nothing when it is not the answer to this call.
  [[nodiscard]] std::optional<Bytes> read(Bytes datagram, std::span<std::uint8_t> out);
  /// After a successful read.
  [[nodiscard]] SessionKeys keys() const { return noise_.keys(); }

 private:
  std::array<std::uint8_t, kCallHeader> header_{};
  EphemeralKey own_;
  NoiseHandshake noise_;
};

/// The touchpad's half of one call.
class Callee {
 public:
  /// @param datagram a call of at least kCallHeader bytes
  Callee(const LinkKey& key, Bytes datagram) : noise_(key.handshakeKey(), datagram.first(kCallHeader)) {}
  [[nodiscard]] std::optional<Bytes> read(Bytes datagram, std::span<std::uint8_t> out) {
    return noise_.readFirst(datagram.subspan(kCallHeader), out);
  }
  /// @return the answer's size; 0 when the caller's key is unsound
  [[nodiscard]] std::size_t write(Bytes payload, RandomSource random, std::span<std::uint8_t> out);
  [[nodiscard]] SessionKeys keys() const { return noise_.keys(); }

 private:
  NoiseHandshake noise_;
};

[[nodiscard]] inline std::uint16_t sessionOf(const SessionKeys& keys) {
  return static_cast<std::uint16_t>(keys.transcript[0] | (keys.transcript[1] << 8));
}

}  // namespace fyd::protocol
