#include "core/protocol/udp_socket.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <ctime>
#include <system_error>
#include <utility>

#include <poll.h>

#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/udp.hpp>

#include "core/base/system_reason.h"

namespace fyd::protocol {
namespace {

using Udp = asio::ip::udp;

constexpr int kReceiveQueue = 4 * 1024 * 1024;  // bytes

Udp::endpoint toAsio(const Endpoint& endpoint) {
  if (endpoint.v6) return {asio::ip::address_v6(endpoint.address, endpoint.scope), endpoint.port};
  asio::ip::address_v4::bytes_type bytes{};
  std::copy_n(endpoint.address.begin(), bytes.size(), bytes.begin());
  return {asio::ip::address_v4(bytes), endpoint.port};
}

Endpoint fromAsio(const Udp::endpoint& from) {
  Endpoint endpoint;
  endpoint.port = from.port();
  endpoint.v6 = from.address().is_v6();
  if (endpoint.v6) {
    endpoint.address = from.address().to_v6().to_bytes();
    endpoint.scope = static_cast<std::uint32_t>(from.address().to_v6().scope_id());
  } else {
    std::ranges::copy(from.address().to_v4().to_bytes(), endpoint.address.begin());
  }
  return endpoint;
}

timespec toTimespec(Duration duration) {
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(duration);
  return {.tv_sec = static_cast<time_t>(seconds.count()), .tv_nsec = static_cast<long>((duration - seconds).count())};
}

}  // namespace

struct UdpSocket::Impl {
  asio::io_context context;
  Udp::socket socket{context};
};

Result<UdpSocket> UdpSocket::open(const Endpoint& local) {
  std::unique_ptr<Impl> impl;
  std::error_code problem;
  const Udp::endpoint wanted = toAsio(local);
  const auto cannot = [&](const Message& what) {
    return fail("UDP {}: {}: {}", toString(local), what, systemReason(problem));
  };
  try {
    impl = std::make_unique<Impl>();  // takes files of its own
  } catch (const std::system_error& failed) {
    problem = failed.code();
    return cannot(say("cannot open a socket"));
  }
  impl->socket.open(wanted.protocol(), problem);
  if (problem) return cannot(say("cannot open a socket"));
  impl->socket.bind(wanted, problem);
  if (problem) {
    return cannot(problem == asio::error::address_in_use ? say("cannot listen, another program holds the port")
                                                         : say("cannot listen"));
  }
  impl->socket.non_blocking(true, problem);
  if (problem) return cannot(say("cannot be set to non-blocking"));
  // A burst of others' datagrams must not push the partner's out of the queue; the system gives what it allows.
  std::error_code ignored;
  impl->socket.set_option(asio::socket_base::receive_buffer_size(kReceiveQueue), ignored);
  const Udp::endpoint bound = impl->socket.local_endpoint(problem);
  if (problem) return cannot(say("cannot tell its own address"));
  return UdpSocket(std::move(impl), fromAsio(bound));
}

UdpSocket::UdpSocket(std::unique_ptr<Impl> impl, const Endpoint& local) : impl_(std::move(impl)), local_(local) {}
UdpSocket::UdpSocket(UdpSocket&&) noexcept = default;
UdpSocket& UdpSocket::operator=(UdpSocket&&) noexcept = default;
UdpSocket::~UdpSocket() = default;

SendOutcome UdpSocket::send(std::span<const std::uint8_t> bytes, const Endpoint& to) {
  std::error_code problem;
  impl_->socket.send_to(asio::buffer(bytes.data(), bytes.size()), toAsio(to), 0, problem);
  if (!problem) return SendOutcome::sent;
  return problem == asio::error::would_block || problem == asio::error::no_buffer_space ? SendOutcome::would_block
                                                                                        : SendOutcome::refused;
}

std::optional<UdpSocket::Received> UdpSocket::receive(std::span<std::uint8_t> buffer, Duration timeout) {
  const Instant deadline = Clock::now() + std::min<Duration>(timeout, std::chrono::hours(1));
  for (;;) {
    std::error_code problem;
    Udp::endpoint from;
    const std::size_t size = impl_->socket.receive_from(asio::buffer(buffer.data(), buffer.size()), from, 0, problem);
    if (!problem) return Received{.size = size, .from = fromAsio(from)};

    const Duration left = deadline - Clock::now();
    if (left <= Duration::zero()) return std::nullopt;
    if (problem != asio::error::would_block) continue;  // an earlier send's ICMP error: reported once, then gone
    const timespec wait = toTimespec(left);
    pollfd ready{.fd = impl_->socket.native_handle(), .events = POLLIN, .revents = 0};
    if (::ppoll(&ready, 1, &wait, nullptr) == 0) return std::nullopt;
  }
}

bool waitForAny(std::span<const UdpSocket* const> sockets, Duration timeout) {
  std::array<pollfd, 32> ready{};
  const std::size_t count = std::min(sockets.size(), ready.size());
  for (std::size_t i = 0; i < count; ++i) {
    ready[i] = {.fd = sockets[i]->impl_->socket.native_handle(), .events = POLLIN, .revents = 0};
  }
  const timespec wait = toTimespec(std::clamp<Duration>(timeout, Duration::zero(), std::chrono::hours(1)));
  return ::ppoll(ready.data(), count, &wait, nullptr) > 0;
}

}  // namespace fyd::protocol
