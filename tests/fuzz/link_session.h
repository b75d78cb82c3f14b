// A session of FYD Link in the middle, whose other end is the fuzzer: it has the keys, so that its messages reach the
// decoders and the state machine behind the seal.
#pragma once

#include <vector>

#include "core/protocol/byte_io.h"
#include "core/protocol/link/link_robot_end.h"
#include "core/protocol/link/link_touchpad_end.h"
#include "tests/fuzz/fuzz.h"

namespace fyd::fuzz {

using namespace fyd::protocol;

inline void countingRandom(std::span<std::uint8_t> out) {
  static std::uint8_t next = 1;
  for (auto& byte : out) byte = next++;
}

inline LinkKey fuzzKey() { return LinkKey::fromCode(SecretBytes<16>{}); }

inline Endpoint fuzzPeer(std::uint16_t port = 1) {
  Endpoint endpoint;
  endpoint.port = port;
  return endpoint;
}

/// Seals what the fuzzer wants to say. Its first byte is the message's type, the rest its body; the time is good.
inline std::vector<std::uint8_t> sealed(Sealer& sealer, std::span<const std::uint8_t> content, LinkTime now_us) {
  std::vector<std::uint8_t> packet(kMaximumLinkDatagram);
  ByteWriter writer(Sealer::messagePart(packet));
  writer.u8(content.empty() ? 0 : content[0]);
  writer.u48(now_us);
  writer.bytes(content.empty() ? content : content.subspan(1));
  packet.resize(sealer.seal(packet, writer.size()));
  return packet;
}

}  // namespace fyd::fuzz
