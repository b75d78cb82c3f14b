// The handshake Noise_NNpsk0_25519_ChaChaPoly_SHA256 ([Noise], revision 34), on libsodium's
// primitives: two ephemeral X25519 keys and one pre-shared key.
//
//   → psk, e    first message:  initiator's public key, payload sealed under the pre-shared key and e
//   ← e, ee     second message: responder's public key, payload sealed under both and the shared secret
//
// Every byte of both messages and of the prologue is mixed into the hash that each seal covers: a difference
// between what the two ends saw makes the seal fail. Afterwards each direction has a key of its own. Nothing allocates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/protocol/datagram.h"
#include "core/protocol/link/secret.h"

namespace fyd::protocol {

inline constexpr std::size_t kPublicKeySize = 32;
inline constexpr std::size_t kTagSize = 16;
/// A handshake message is this much longer than its payload.
inline constexpr std::size_t kNoiseOverhead = kPublicKeySize + kTagSize;

using PublicKey = std::array<std::uint8_t, kPublicKeySize>;

struct EphemeralKey {
  SecretBytes<32> secret;
  PublicKey open{};

  [[nodiscard]] static EphemeralKey make(RandomSource random);
};

/// What a finished handshake leaves: a key per direction and the transcript's hash.
struct SessionKeys {
  SecretBytes<32> from_initiator;
  SecretBytes<32> from_responder;
  std::array<std::uint8_t, 32> transcript{};
};

/// One handshake, one side. Call in the order first, second, keys; a failed read leaves it useless.
class NoiseHandshake {
 public:
  NoiseHandshake(const SecretBytes<32>& shared_key, Bytes prologue);

  /// Each returns bytes written into `out`; 0 when that is too short, or (second) the peer's key is unsound.
  std::size_t writeFirst(const EphemeralKey& own, Bytes payload, std::span<std::uint8_t> out);
  std::size_t writeSecond(const EphemeralKey& own, Bytes payload, std::span<std::uint8_t> out);
  /// Each returns the payload, opened into `out`; nothing when it is not authentic or `out` is too short.
  [[nodiscard]] std::optional<Bytes> readFirst(Bytes message, std::span<std::uint8_t> out);
  [[nodiscard]] std::optional<Bytes> readSecond(const EphemeralKey& own, Bytes message, std::span<std::uint8_t> out);
  [[nodiscard]] SessionKeys keys() const;

  /// Of the other end, once read.
  [[nodiscard]] const PublicKey& peer() const { return peer_; }

 private:
  void mixHash(Bytes data);
  void mixKey(Bytes data);
  [[nodiscard]] bool mixShared(const SecretBytes<32>& own);
  std::size_t seal(Bytes payload, std::span<std::uint8_t> out);
  std::optional<Bytes> open(Bytes sealed, std::span<std::uint8_t> out);

  std::array<std::uint8_t, 32> hash_{};
  SecretBytes<32> chaining_;
  SecretBytes<32> key_;
  PublicKey peer_{};
};

}  // namespace fyd::protocol
