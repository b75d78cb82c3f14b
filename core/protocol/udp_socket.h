// One bound UDP socket: datagrams out without blocking, datagrams in with a time-out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/base/time.h"
#include "core/protocol/endpoint.h"

namespace fyd::protocol {

/// No datagram of either protocol is longer; a longer one is delivered cut to the caller's buffer.
inline constexpr std::size_t kMaximumDatagram = 65'536;

enum class SendOutcome : std::uint8_t {
  sent,
  would_block,  ///< the socket's buffer is full; nothing was sent
  refused,      ///< the network says no: unreachable, interface down, port closed, datagram too long
};

/// Used by one thread at a time. Sending and receiving do not allocate.
class UdpSocket {
 public:
  /// @param local port 0 asks for any free port
  /// @return an error that names the address and the system's reason (port taken, no such address, no permission)
  [[nodiscard]] static Result<UdpSocket> open(const Endpoint& local);

  UdpSocket(UdpSocket&&) noexcept;
  UdpSocket& operator=(UdpSocket&&) noexcept;
  ~UdpSocket();

  /// The address it is bound to, with the port the system chose.
  [[nodiscard]] const Endpoint& local() const { return local_; }

  SendOutcome send(std::span<const std::uint8_t> bytes, const Endpoint& to);

  struct Received {
    std::size_t size = 0;  ///< bytes written into the buffer; datagrams of no bytes exist
    Endpoint from;
  };
  /// Waits at most `timeout` (zero: does not wait) for one datagram. ICMP errors of earlier sends are skipped.
  /// @return nothing when none came
  [[nodiscard]] std::optional<Received> receive(std::span<std::uint8_t> buffer, Duration timeout);

 private:
  struct Impl;
  UdpSocket(std::unique_ptr<Impl> impl, const Endpoint& local);
  friend bool waitForAny(std::span<const UdpSocket* const> sockets, Duration timeout);
  std::unique_ptr<Impl> impl_;
  Endpoint local_;
};

/// Waits at most `timeout` until one of at most 32 sockets has something to receive. @return whether one has
bool waitForAny(std::span<const UdpSocket* const> sockets, Duration timeout);

}  // namespace fyd::protocol
