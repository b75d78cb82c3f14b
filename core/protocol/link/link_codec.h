// FYD Link's messages on the wire, before they are sealed: little-endian, byte for byte as resources/manual/protocol.md
// says. Every message begins with
//   1 byte   type in the low five bits, flags of its optional fields in the high three
//   6 bytes  the sender's time, µs
//
// Writing saturates: magnitudes are held at their field's limits, what is not a number is written as zero (a touch
// with a position that is not finite: not in contact). Reading is strict: exactly the bytes the type needs, every
// field in its range, unused bits zero; anything else is refused and nothing of it is used.
// Pure functions; none allocates or throws. Text and image bytes of what is read point into the input.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/protocol/link/link_messages.h"
#include "core/protocol/link/link_refusal.h"

namespace fyd::protocol {

inline constexpr std::size_t kLinkEnvelope = 7;
inline constexpr std::size_t kMaximumLinkMessage = 1'260;  ///< bytes of any message

/// Type and time of a message; `flags` in the low three bits.
struct LinkEnvelope {
  LinkMessage type{};
  std::uint8_t flags = 0;
  LinkTime sent_us = 0;
  Bytes body;
};

/// Each writes a whole message and returns its size; 0 when it does not fit, which kMaximumLinkMessage rules out.
[[nodiscard]] std::size_t encodeLink(const LinkTouch& touch, const PositionCode& code, LinkTime sent_us,
                                     std::span<std::uint8_t> out);
[[nodiscard]] std::size_t encodeLink(const LinkState& state, const PositionCode& code, LinkTime sent_us,
                                     std::span<std::uint8_t> out);
[[nodiscard]] std::size_t encodeLink(const LinkCommand& command, LinkTime sent_us, std::span<std::uint8_t> out);
[[nodiscard]] std::size_t encodeLink(const LinkCommandAck& ack, LinkTime sent_us, std::span<std::uint8_t> out);
[[nodiscard]] std::size_t encodeLink(const LinkHeartbeat& beat, LinkTime sent_us, std::span<std::uint8_t> out);
[[nodiscard]] std::size_t encodeLink(const LinkInfo& info, LinkTime sent_us, std::span<std::uint8_t> out);
[[nodiscard]] std::size_t encodeLink(const LinkGoodbye& goodbye, LinkTime sent_us, std::span<std::uint8_t> out);
[[nodiscard]] std::size_t encodeLink(const LinkImageFragment& fragment, LinkTime sent_us, std::span<std::uint8_t> out);

[[nodiscard]] LinkDecoded<LinkEnvelope> decodeEnvelope(Bytes message);
[[nodiscard]] LinkDecoded<LinkTouch> decodeTouch(const LinkEnvelope& message, const PositionCode& code);
[[nodiscard]] LinkDecoded<LinkState> decodeState(const LinkEnvelope& message, const PositionCode& code);
[[nodiscard]] LinkDecoded<LinkCommand> decodeCommand(const LinkEnvelope& message);
[[nodiscard]] LinkDecoded<LinkCommandAck> decodeCommandAck(const LinkEnvelope& message);
[[nodiscard]] LinkDecoded<LinkHeartbeat> decodeHeartbeat(const LinkEnvelope& message);
[[nodiscard]] LinkDecoded<LinkInfo> decodeInfo(const LinkEnvelope& message);
[[nodiscard]] LinkDecoded<LinkGoodbye> decodeGoodbye(const LinkEnvelope& message);
[[nodiscard]] LinkDecoded<LinkImageFragment> decodeImageFragment(const LinkEnvelope& message);

/// The self-descriptions, which travel inside the handshake and have no envelope.
[[nodiscard]] std::size_t encodeHello(const RobotHello& hello, std::span<std::uint8_t> out);
[[nodiscard]] std::size_t encodeHello(const TouchpadHello& hello, std::span<std::uint8_t> out);
[[nodiscard]] LinkDecoded<RobotHello> decodeRobotHello(Bytes payload);
[[nodiscard]] LinkDecoded<TouchpadHello> decodeTouchpadHello(Bytes payload);

/// The workspace as its 32-bit numbers say it on the wire: both ends must code positions by the same one.
[[nodiscard]] Workspace asOnTheWire(const Workspace& workspace);

/// Bytes of a touch message before sealing.
[[nodiscard]] std::size_t touchMessageSize(unsigned bits_per_axis, const TouchFields& fields);

}  // namespace fyd::protocol
