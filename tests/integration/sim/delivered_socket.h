// A UDP socket of an end in virtual time: what one sends has arrived at the other when `send` returns. The kernel alone
// does not promise that: on a busy machine loopback delivers later, and a virtual clock goes on meanwhile.
#pragma once

#include <array>
#include <span>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/protocol/udp_socket.h"
#include "tests/wait.h"

namespace fyd::sim {

class DeliveredSocket {
 public:
  DeliveredSocket() : socket_(protocol::UdpSocket::open(protocol::parseEndpoint("127.0.0.1:0").value()).value()) {}

  [[nodiscard]] const protocol::Endpoint& local() const { return socket_.local(); }
  /// For a test in real time; not together with `receive`.
  [[nodiscard]] protocol::UdpSocket& socket() { return socket_; }

  void send(std::span<const std::uint8_t> bytes, DeliveredSocket& to) {
    ASSERT_EQ(socket_.send(bytes, to.local()), protocol::SendOutcome::sent);
    to.await(local());
  }
  /// Gives each datagram that has arrived, in order, and its sender.
  template <class Take>
  void receive(Take&& take) {
    for (const auto& [bytes, from] : std::exchange(arrived_, {})) take(std::span<const std::uint8_t>(bytes), from);
  }

 private:
  void await(const protocol::Endpoint& from) {
    for (;;) {
      const auto got = socket_.receive(buffer_, kPatience);
      ASSERT_TRUE(got) << "what was sent over loopback has not arrived";
      if (got->from != from) continue;  // a stranger, whose datagram was meant for this port's last owner
      arrived_.emplace_back(std::vector(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(got->size)),
                            got->from);
      return;
    }
  }

  protocol::UdpSocket socket_;
  std::vector<std::pair<std::vector<std::uint8_t>, protocol::Endpoint>> arrived_;
  std::array<std::uint8_t, 4096> buffer_{};
};

}  // namespace fyd::sim
