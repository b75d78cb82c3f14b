// An address and port as both ends of a link compare and show it; no socket library needed to hold one.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace fyd::protocol {

struct Endpoint {
  std::array<std::uint8_t, 16> address{};  ///< network order; IPv4 uses the first four bytes
  std::uint32_t scope = 0;                 ///< IPv6 link-local only: the interface's index
  std::uint16_t port = 0;
  bool v6 = false;

  friend bool operator==(const Endpoint&, const Endpoint&) = default;
};

/// Reads "127.0.0.1:3490", "[::1]:3490" or "localhost:3490" (which means 127.0.0.1). Other names are not looked up:
/// a link's partner is named by number, so that no name server can redirect it.
/// @return an error that says which half of the text is wrong and what was expected
[[nodiscard]] Result<Endpoint> parseEndpoint(std::string_view text);

/// The form parseEndpoint reads.
[[nodiscard]] std::string toString(const Endpoint& endpoint);

}  // namespace fyd::protocol
