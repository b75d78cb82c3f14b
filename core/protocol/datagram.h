// One datagram to send; the bytes belong to whoever made it.
#pragma once

#include <cstdint>
#include <span>

#include "core/protocol/endpoint.h"

namespace fyd::protocol {

using Bytes = std::span<const std::uint8_t>;

struct Datagram {
  Bytes bytes;
  Endpoint to;
};

}  // namespace fyd::protocol
