#include "core/protocol/link/link_handshake.h"

#include <algorithm>

#include <sodium/crypto_generichash.h>
#include <sodium/crypto_verify_16.h>

#include "core/protocol/byte_io.h"

namespace fyd::protocol {
namespace {

constexpr std::size_t kMac = 16;
constexpr std::size_t kNonceAt = 2;
constexpr std::size_t kCookieAt = 18;
constexpr std::size_t kMacAt = kHelloSize - kMac;

using Mac = std::array<std::uint8_t, kMac>;

Mac macOf(const SecretBytes<32>& key, Bytes bytes) {
  Mac mac{};
  crypto_generichash(mac.data(), mac.size(), bytes.data(), bytes.size(), key.data(), key.size());
  return mac;
}

HelloBytes make(LinkKind kind, const SecretBytes<32>& key, const HelloNonce& nonce, const Cookie& cookie) {
  HelloBytes out{};
  out[0] = kLinkMark;
  out[1] = versionAndKind(kind);
  std::ranges::copy(nonce, out.begin() + kNonceAt);
  std::ranges::copy(cookie, out.begin() + kCookieAt);
  std::ranges::copy(macOf(key, Bytes(out).first(kMacAt)), out.begin() + kMacAt);
  return out;
}

LinkRefusal checkMac(const SecretBytes<32>& key, Bytes datagram) {
  if (datagram.size() != kHelloSize) return LinkRefusal::size;
  const Mac mac = macOf(key, datagram.first(kMacAt));
  return crypto_verify_16(mac.data(), datagram.data() + kMacAt) == 0 ? LinkRefusal::none : LinkRefusal::key;
}

template <std::size_t Size>
void copyFrom(Bytes datagram, std::size_t at, std::array<std::uint8_t, Size>& out) {
  std::ranges::copy(datagram.subspan(at, Size), out.begin());
}

std::array<std::uint8_t, kCallHeader> callHeader(const Cookie& cookie) {
  std::array<std::uint8_t, kCallHeader> out{kLinkMark, versionAndKind(LinkKind::call)};
  std::ranges::copy(cookie, out.begin() + 2);
  return out;
}

}  // namespace

HelloBytes makeHello(const LinkKey& key, const HelloNonce& nonce) {
  return make(LinkKind::hello, key.helloKey(), nonce, {});
}

LinkRefusal readHello(const LinkKey& key, Bytes datagram, HelloNonce& nonce) {
  const LinkRefusal refusal = checkMac(key.helloKey(), datagram);
  if (refusal == LinkRefusal::none) copyFrom(datagram, kNonceAt, nonce);
  return refusal;
}

HelloBytes makeChallenge(const LinkKey& key, const HelloNonce& nonce, const Cookie& cookie) {
  return make(LinkKind::challenge, key.challengeKey(), nonce, cookie);
}

LinkRefusal readChallenge(const LinkKey& key, Bytes datagram, const HelloNonce& nonce, Cookie& cookie) {
  const LinkRefusal refusal = checkMac(key.challengeKey(), datagram);
  if (refusal != LinkRefusal::none) return refusal;
  if (!std::ranges::equal(datagram.subspan(kNonceAt, nonce.size()), nonce)) return LinkRefusal::cookie;
  copyFrom(datagram, kCookieAt, cookie);
  return LinkRefusal::none;
}

Cookie CookieJar::inSlot(const Endpoint& from, std::uint64_t slot) const {
  std::array<std::uint8_t, 8 + 16 + 4 + 2 + 1> bytes{};
  ByteWriter writer(bytes);
  writer.little<8>(slot);
  writer.bytes(from.address);
  writer.u32(from.scope);
  writer.u16(from.port);
  writer.u8(from.v6 ? 1 : 0);
  return macOf(secret_, bytes);
}

bool CookieJar::good(Bytes cookie, const Endpoint& from, LinkTime now_us) const {
  const std::uint64_t slot = now_us / kSlot_us;
  const Cookie present = inSlot(from, slot);
  const Cookie last = inSlot(from, slot - 1);
  return cookie.size() == present.size() && (crypto_verify_16(cookie.data(), present.data()) == 0 ||
                                             (slot > 0 && crypto_verify_16(cookie.data(), last.data()) == 0));
}

Caller::Caller(const LinkKey& key, const Cookie& cookie, RandomSource random)
    : header_(callHeader(cookie)), own_(EphemeralKey::make(random)), noise_(key.handshakeKey(), header_) {}

std::size_t Caller::write(Bytes payload, std::span<std::uint8_t> out) {
  if (out.size() < kCallHeader) return 0;
  std::ranges::copy(header_, out.begin());
  const std::size_t size = noise_.writeFirst(own_, payload, out.subspan(kCallHeader));
  return size == 0 ? 0 : kCallHeader + size;
}

std::optional<Bytes> Caller::read(Bytes datagram, std::span<std::uint8_t> out) {
  if (datagram.size() < kAnswerHeader) return {};
  // What does not open leaves this call as it was: the true answer may still come.
  NoiseHandshake attempt = noise_;
  const auto payload = attempt.readSecond(own_, datagram.subspan(kAnswerHeader), out);
  if (payload) noise_ = attempt;
  return payload;
}

std::size_t Callee::write(Bytes payload, RandomSource random, std::span<std::uint8_t> out) {
  if (out.size() < kAnswerHeader) return 0;
  out[0] = kLinkMark;
  out[1] = versionAndKind(LinkKind::answer);
  const std::size_t size = noise_.writeSecond(EphemeralKey::make(random), payload, out.subspan(kAnswerHeader));
  return size == 0 ? 0 : kAnswerHeader + size;
}

}  // namespace fyd::protocol
