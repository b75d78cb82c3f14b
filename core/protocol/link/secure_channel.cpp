#include "core/protocol/link/secure_channel.h"

#include <sodium/crypto_aead_chacha20poly1305.h>

#include "core/protocol/byte_io.h"

namespace fyd::protocol {
namespace {

using Nonce = std::array<std::uint8_t, crypto_aead_chacha20poly1305_ietf_NPUBBYTES>;

Nonce nonceOf(std::uint64_t counter) {
  Nonce nonce{};
  ByteWriter writer(nonce);
  writer.u32(0);
  writer.little<8>(counter);
  return nonce;
}

}  // namespace

LinkSorted sortDatagram(Bytes datagram) {
  if (datagram.size() < 2 || datagram[0] != kLinkMark) return {.refusal = LinkRefusal::magic};
  if ((datagram[1] >> 4) != kLinkVersion) return {.refusal = LinkRefusal::version};
  const std::uint8_t kind = datagram[1] & 0x0FU;
  if (kind < static_cast<std::uint8_t>(LinkKind::hello) || kind > static_cast<std::uint8_t>(LinkKind::sealed)) {
    return {.refusal = LinkRefusal::kind};
  }
  return {.kind = static_cast<LinkKind>(kind)};
}

LinkRefusal ReplayWindow::check(std::uint64_t counter) const {
  if (counter >= next_) return LinkRefusal::none;
  if (next_ - counter > kSize) return LinkRefusal::behind;
  const std::uint64_t slot = counter % kSize;
  return ((taken_[slot / 64] >> (slot % 64)) & 1U) != 0 ? LinkRefusal::repeated : LinkRefusal::none;
}

void ReplayWindow::take(std::uint64_t counter) {
  if (counter >= next_) {
    // Slots that now stand for counters never seen are cleared.
    if (counter - next_ >= kSize) {
      taken_ = {};
    } else {
      for (std::uint64_t c = next_; c < counter; ++c) taken_[c % kSize / 64] &= ~(std::uint64_t{1} << (c % 64));
    }
    next_ = counter + 1;
  }
  taken_[counter % kSize / 64] |= std::uint64_t{1} << (counter % 64);
}

std::size_t Sealer::seal(std::span<std::uint8_t> packet, std::size_t size) {
  if (exhausted() || size == 0 || packet.size() < size + kSealOverhead) return 0;
  ByteWriter header(packet.first(kSealHeader));
  header.u8(kLinkMark);
  header.u8(versionAndKind(LinkKind::sealed));
  header.u16(session_);
  header.u48(counter_);
  const Nonce nonce = nonceOf(counter_++);
  std::uint8_t* message = packet.data() + kSealHeader;
  crypto_aead_chacha20poly1305_ietf_encrypt(message, nullptr, message, size, packet.data(), kSealHeader, nullptr,
                                            nonce.data(), key_.data());
  return size + kSealOverhead;
}

Opened Opener::open(Bytes datagram, std::span<std::uint8_t> out) {
  const LinkSorted sorted = sortDatagram(datagram);
  if (sorted.refusal != LinkRefusal::none) return {.refusal = sorted.refusal};
  if (sorted.kind != LinkKind::sealed) return {.refusal = LinkRefusal::kind};
  if (datagram.size() <= kSealOverhead || out.size() < datagram.size() - kSealOverhead) {
    return {.refusal = LinkRefusal::size};
  }
  ByteReader header(datagram.subspan(2));
  if (header.u16() != session_) return {.refusal = LinkRefusal::session};
  const std::uint64_t counter = header.u48();
  if (const LinkRefusal refusal = window_.check(counter); refusal != LinkRefusal::none) return {.refusal = refusal};
  const Nonce nonce = nonceOf(counter);
  const Bytes sealed = datagram.subspan(kSealHeader);
  if (crypto_aead_chacha20poly1305_ietf_decrypt(out.data(), nullptr, nullptr, sealed.data(), sealed.size(),
                                                datagram.data(), kSealHeader, nonce.data(), key_.data()) != 0) {
    return {.refusal = LinkRefusal::key};
  }
  window_.take(counter);
  return {.message = out.first(sealed.size() - kTagSize), .counter = counter};
}

}  // namespace fyd::protocol
