// A few datagrams on their way out, together with their bytes.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "core/base/batch.h"
#include "core/protocol/datagram.h"
#include "core/protocol/link/secure_channel.h"

namespace fyd::protocol {

class Outbox {
 public:
  static constexpr std::size_t kCapacity = 8;

  void clear() { datagrams_.clear(); }
  [[nodiscard]] bool full() const { return datagrams_.full(); }
  /// Where the next datagram is written; only while not full.
  [[nodiscard]] std::span<std::uint8_t> next() { return bytes_[datagrams_.size()]; }
  /// Keeps the first `size` bytes of `next()`; none when that is 0.
  void keep(std::size_t size, const Endpoint& to) {
    if (size == 0 || full()) return;
    static_cast<void>(datagrams_.push({.bytes = Bytes(next()).first(size), .to = to}));
  }
  void add(Bytes bytes, const Endpoint& to) {
    if (full() || bytes.size() > kMaximumLinkDatagram) return;
    std::ranges::copy(bytes, next().begin());
    keep(bytes.size(), to);
  }
  /// Encodes a message into the next datagram and seals it: `write(span)` returns the message's size.
  template <class Write>
  void seal(Sealer& sealer, const Endpoint& to, Write&& write) {
    if (full()) return;
    const std::span<std::uint8_t> packet = next();
    keep(sealer.seal(packet, write(Sealer::messagePart(packet))), to);
  }
  [[nodiscard]] std::span<const Datagram> view() const { return datagrams_.view(); }

 private:
  Batch<Datagram, kCapacity> datagrams_;
  std::array<std::array<std::uint8_t, kMaximumLinkDatagram>, kCapacity> bytes_{};
};

}  // namespace fyd::protocol
