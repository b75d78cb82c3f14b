// The two self-descriptions of link_codec.h.
#include "core/protocol/link/link_codec.h"
#include "core/protocol/link/link_fields.h"

namespace fyd::protocol {
namespace {

constexpr std::uint32_t kKnownCapabilities = 15;

}  // namespace

Workspace asOnTheWire(const Workspace& workspace) {
  std::array<std::uint8_t, 28> bytes{};
  ByteWriter writer(bytes);
  fields::writeWorkspace(writer, workspace);
  ByteReader reader(bytes);
  Workspace out;
  return fields::readWorkspace(reader, out) ? out : workspace;
}

std::size_t encodeHello(const RobotHello& hello, std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  writer.u48(hello.sent_us);
  fields::writeRates(writer, hello.rates);
  fields::writeWorkspace(writer, hello.workspace);
  writer.u32(hello.capabilities & kKnownCapabilities);
  fields::writeText(writer, hello.text, kMaximumRobotText);
  return writer.size();
}

LinkDecoded<RobotHello> decodeRobotHello(Bytes payload) {
  ByteReader in(payload);
  RobotHello hello;
  hello.sent_us = in.u48();
  bool good = fields::readRates(in, hello.rates);
  good = fields::readWorkspace(in, hello.workspace) && good;
  hello.capabilities = in.u32();
  good = (hello.capabilities & ~kKnownCapabilities) == 0 && good;
  good = fields::readText(in, kMaximumRobotText, hello.text) && good;
  return fields::finished(in, hello, good);
}

std::size_t encodeHello(const TouchpadHello& hello, std::span<std::uint8_t> out) {
  ByteWriter writer(out);
  writer.u8(static_cast<std::uint8_t>(hello.status));
  writer.u48(hello.sent_us);
  writer.u48(hello.echo_us);
  writer.u32(hello.held_us);
  fields::writeRates(writer, hello.rates);
  fields::writeWorkspace(writer, hello.workspace);
  writer.u32(hello.capabilities & kKnownCapabilities);
  fields::writeBoard(writer, hello.k_vib, hello.reference_ticks, hello.board_text);
  return writer.size();
}

LinkDecoded<TouchpadHello> decodeTouchpadHello(Bytes payload) {
  ByteReader in(payload);
  TouchpadHello hello;
  const std::uint8_t status = in.u8();
  hello.status = static_cast<CallStatus>(status);
  bool good = status <= static_cast<std::uint8_t>(CallStatus::second_robot);
  hello.sent_us = in.u48();
  hello.echo_us = in.u48();
  hello.held_us = in.u32();
  good = fields::readRates(in, hello.rates) && good;
  good = fields::readWorkspace(in, hello.workspace) && good;
  hello.capabilities = in.u32();
  good = (hello.capabilities & ~kKnownCapabilities) == 0 && good;
  good = fields::readBoard(in, hello.k_vib, hello.reference_ticks, hello.board_text) && good;
  return fields::finished(in, hello, good);
}

}  // namespace fyd::protocol
