// Every decoder of FYD Link's messages on any bytes: refused, or in range and the same bytes when written again.
#include "core/protocol/link/link_codec.h"

#include "core/protocol/link/link_handshake.h"
#include "tests/fuzz/fuzz.h"

using namespace fyd;
using namespace fyd::protocol;

namespace {

const PositionCode kCode = *PositionCode::make(asOnTheWire(TouchpadHello{}.workspace));
std::array<std::uint8_t, kMaximumLinkMessage> again;

void requireSame(Bytes message, std::size_t size) {
  fuzz::require(size == message.size() && std::ranges::equal(Bytes(again).first(size), message));
}

template <class Decoded>
void requirePlain(Bytes message, LinkTime at, const Decoded& decoded) {
  if (decoded.ok()) requireSame(message, encodeLink(decoded.value, at, again));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes message(data, size);
  if (const auto hello = decodeRobotHello(message); hello.ok()) requireSame(message, encodeHello(hello.value, again));
  if (const auto hello = decodeTouchpadHello(message); hello.ok()) {
    fuzz::require(PositionCode::make(hello.value.workspace).has_value());
    requireSame(message, encodeHello(hello.value, again));
  }
  const auto envelope = decodeEnvelope(message);
  if (!envelope.ok()) return 0;
  const LinkTime at = envelope.value.sent_us;
  switch (envelope.value.type) {
    case LinkMessage::touch:
      if (const auto touch = decodeTouch(envelope.value, kCode); touch.ok()) {
        fuzz::require(touch.value.position_mm.finite());
        requireSame(message, encodeLink(touch.value, kCode, at, again));
      }
      break;
    case LinkMessage::state:
      if (const auto state = decodeState(envelope.value, kCode); state.ok()) {
        fuzz::require(state.value.robot.stiffness_N_per_mm >= 0.0 && state.value.robot.position_mm.finite());
        for (const auto& sample : state.value.accelerations) fuzz::require(sample.acceleration_g.finite());
        requireSame(message, encodeLink(state.value, kCode, at, again));
      }
      break;
    case LinkMessage::command: requirePlain(message, at, decodeCommand(envelope.value)); break;
    case LinkMessage::command_ack: requirePlain(message, at, decodeCommandAck(envelope.value)); break;
    case LinkMessage::heartbeat: requirePlain(message, at, decodeHeartbeat(envelope.value)); break;
    case LinkMessage::info: requirePlain(message, at, decodeInfo(envelope.value)); break;
    case LinkMessage::goodbye: requirePlain(message, at, decodeGoodbye(envelope.value)); break;
    case LinkMessage::image: requirePlain(message, at, decodeImageFragment(envelope.value)); break;
  }
  return 0;
}
