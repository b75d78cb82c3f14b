// Datagrams of the classic protocol as text, which they are made of (manual/protocol-classic.md).
#pragma once

#include <string>
#include <string_view>

#include "core/protocol/datagram.h"

namespace fyd::protocol {

/// Of a text that outlives them.
inline Bytes bytesOf(std::string_view text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}
inline std::string text(Bytes packet) { return {packet.begin(), packet.end()}; }

/// A touch at 10, −5, −2 mm with 1 N.
inline constexpr std::string_view kTouch = "?0'00010:1'00005:1'00002:0'10000.\n";

}  // namespace fyd::protocol
