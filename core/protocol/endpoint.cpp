#include "core/protocol/endpoint.h"

#include <algorithm>
#include <charconv>

#include <asio/ip/address.hpp>

namespace fyd::protocol {
namespace {

Result<std::uint16_t> parsePort(std::string_view text, std::string_view whole) {
  unsigned value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || problem != std::errc() || end != text.data() + text.size() || value > 65'535) {
    return fail("address \"{}\": port \"{}\" is not a whole number from 0 to 65535", whole, text);
  }
  return static_cast<std::uint16_t>(value);
}

}  // namespace

Result<Endpoint> parseEndpoint(std::string_view text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) {
    return fail("address \"{}\": no port; expected HOST:PORT such as 127.0.0.1:3490 or [::1]:3490", text);
  }
  std::string_view host = text.substr(0, colon);
  const bool bracketed = host.size() >= 2 && host.front() == '[' && host.back() == ']';
  if (bracketed) host = host.substr(1, host.size() - 2);
  if (!bracketed && host.find(':') != std::string_view::npos) {
    return fail("address \"{}\": an IPv6 address stands in brackets, such as [::1]:3490", text);
  }
  const Result<std::uint16_t> port = parsePort(text.substr(colon + 1), text);
  if (!port) return tl::unexpected(port.error());

  std::error_code problem;
  const asio::ip::address address =
      asio::ip::make_address(host == "localhost" ? "127.0.0.1" : std::string(host), problem);
  if (problem || address.is_v6() != bracketed) {
    return fail("address \"{}\": \"{}\" is not an {} address (names other than localhost are not looked up)", text,
                host, bracketed ? "IPv6" : "IPv4");
  }
  if (const std::size_t percent = host.find('%'); percent != std::string_view::npos) {
    if (!address.to_v6().is_link_local()) {
      return fail("address \"{}\": only a link-local address (fe80::…) has an interface after %", text);
    }
    if (address.to_v6().scope_id() == 0) {
      return fail("address \"{}\": there is no network interface \"{}\"", text, host.substr(percent + 1));
    }
  }
  Endpoint endpoint;
  endpoint.port = *port;
  endpoint.v6 = address.is_v6();
  if (endpoint.v6) {
    endpoint.address = address.to_v6().to_bytes();
    endpoint.scope = static_cast<std::uint32_t>(address.to_v6().scope_id());
  } else {
    std::ranges::copy(address.to_v4().to_bytes(), endpoint.address.begin());
  }
  return endpoint;
}

std::string toString(const Endpoint& endpoint) {
  if (endpoint.v6) {
    return fmt::format("[{}]:{}", asio::ip::address_v6(endpoint.address, endpoint.scope).to_string(), endpoint.port);
  }
  const auto& a = endpoint.address;
  return fmt::format("{}.{}.{}.{}:{}", a[0], a[1], a[2], a[3], endpoint.port);
}

}  // namespace fyd::protocol
