#include "core/protocol/link/noise.h"

#include <algorithm>
#include <string_view>

#include <sodium/crypto_aead_chacha20poly1305.h>
#include <sodium/crypto_auth_hmacsha256.h>
#include <sodium/crypto_hash_sha256.h>
#include <sodium/crypto_scalarmult.h>

namespace fyd::protocol {
namespace {

constexpr std::string_view kName = "Noise_NNpsk0_25519_ChaChaPoly_SHA256";
// Each key seals one payload only, so its nonce is always the first.
constexpr std::array<std::uint8_t, crypto_aead_chacha20poly1305_ietf_NPUBBYTES> kFirstNonce{};

Bytes bytesOf(std::string_view text) { return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}; }

void hmac(const std::uint8_t* key, Bytes first, Bytes second, std::uint8_t* out) {
  crypto_auth_hmacsha256_state state;
  crypto_auth_hmacsha256_init(&state, key, 32);
  crypto_auth_hmacsha256_update(&state, first.data(), first.size());
  crypto_auth_hmacsha256_update(&state, second.data(), second.size());
  crypto_auth_hmacsha256_final(&state, out);
  sodium_memzero(&state, sizeof state);
}

/// HKDF of the Noise specification: out₁ = HMAC(t, 1), outₙ = HMAC(t, outₙ₋₁ ‖ n), t = HMAC(chaining, input).
template <std::size_t Outputs>
std::array<SecretBytes<32>, Outputs> derive(const SecretBytes<32>& chaining, Bytes input) {
  SecretBytes<32> temporary;
  hmac(chaining.data(), input, {}, temporary.data());
  std::array<SecretBytes<32>, Outputs> out;
  for (std::size_t i = 0; i < Outputs; ++i) {
    const std::array<std::uint8_t, 1> number{static_cast<std::uint8_t>(i + 1)};
    hmac(temporary.data(), i == 0 ? Bytes{} : Bytes(out[i - 1].view()), number, out[i].data());
  }
  return out;
}

}  // namespace

EphemeralKey EphemeralKey::make(RandomSource random) {
  EphemeralKey key;
  random(key.secret.view());
  crypto_scalarmult_base(key.open.data(), key.secret.data());
  return key;
}

NoiseHandshake::NoiseHandshake(const SecretBytes<32>& shared_key, Bytes prologue) {
  crypto_hash_sha256(hash_.data(), bytesOf(kName).data(), kName.size());
  std::ranges::copy(hash_, chaining_.data());
  mixHash(prologue);
  const auto [chaining, mixed, key] = derive<3>(chaining_, shared_key.view());
  chaining_ = chaining;
  mixHash(mixed.view());
  key_ = key;
}

void NoiseHandshake::mixHash(Bytes data) {
  crypto_hash_sha256_state state;
  crypto_hash_sha256_init(&state);
  crypto_hash_sha256_update(&state, hash_.data(), hash_.size());
  crypto_hash_sha256_update(&state, data.data(), data.size());
  crypto_hash_sha256_final(&state, hash_.data());
}

void NoiseHandshake::mixKey(Bytes data) {
  const auto [chaining, key] = derive<2>(chaining_, data);
  chaining_ = chaining;
  key_ = key;
}

bool NoiseHandshake::mixShared(const SecretBytes<32>& own) {
  SecretBytes<32> shared;
  // Fails for the few public keys that would make the shared secret zero whatever the own key is.
  if (crypto_scalarmult(shared.data(), own.data(), peer_.data()) != 0) return false;
  mixKey(shared.view());
  return true;
}

std::size_t NoiseHandshake::seal(Bytes payload, std::span<std::uint8_t> out) {
  const std::size_t size = payload.size() + kTagSize;
  if (out.size() < size) return 0;
  crypto_aead_chacha20poly1305_ietf_encrypt(out.data(), nullptr, payload.data(), payload.size(), hash_.data(),
                                            hash_.size(), nullptr, kFirstNonce.data(), key_.data());
  mixHash(out.first(size));
  return size;
}

std::optional<Bytes> NoiseHandshake::open(Bytes sealed, std::span<std::uint8_t> out) {
  if (sealed.size() < kTagSize || out.size() < sealed.size() - kTagSize) return {};
  if (crypto_aead_chacha20poly1305_ietf_decrypt(out.data(), nullptr, nullptr, sealed.data(), sealed.size(),
                                                hash_.data(), hash_.size(), kFirstNonce.data(), key_.data()) != 0) {
    return {};
  }
  mixHash(sealed);
  return out.first(sealed.size() - kTagSize);
}

std::size_t NoiseHandshake::writeFirst(const EphemeralKey& own, Bytes payload, std::span<std::uint8_t> out) {
  if (out.size() < kNoiseOverhead + payload.size()) return 0;
  std::ranges::copy(own.open, out.begin());
  mixHash(own.open);
  mixKey(own.open);
  return kPublicKeySize + seal(payload, out.subspan(kPublicKeySize));
}

std::optional<Bytes> NoiseHandshake::readFirst(Bytes message, std::span<std::uint8_t> out) {
  if (message.size() < kNoiseOverhead) return {};
  std::ranges::copy(message.first(kPublicKeySize), peer_.begin());
  mixHash(peer_);
  mixKey(peer_);
  return open(message.subspan(kPublicKeySize), out);
}

std::size_t NoiseHandshake::writeSecond(const EphemeralKey& own, Bytes payload, std::span<std::uint8_t> out) {
  if (out.size() < kNoiseOverhead + payload.size()) return 0;
  std::ranges::copy(own.open, out.begin());
  mixHash(own.open);
  mixKey(own.open);
  if (!mixShared(own.secret)) return 0;
  return kPublicKeySize + seal(payload, out.subspan(kPublicKeySize));
}

std::optional<Bytes> NoiseHandshake::readSecond(const EphemeralKey& own, Bytes message, std::span<std::uint8_t> out) {
  if (message.size() < kNoiseOverhead) return {};
  std::ranges::copy(message.first(kPublicKeySize), peer_.begin());
  mixHash(peer_);
  mixKey(peer_);
  if (!mixShared(own.secret)) return {};
  return open(message.subspan(kPublicKeySize), out);
}

SessionKeys NoiseHandshake::keys() const {
  const auto [initiator, responder] = derive<2>(chaining_, {});
  return {.from_initiator = initiator, .from_responder = responder, .transcript = hash_};
}

}  // namespace fyd::protocol
