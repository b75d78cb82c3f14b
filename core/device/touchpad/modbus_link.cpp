#include "core/device/touchpad/modbus_link.h"

#include <array>
#include <cerrno>
#include <charconv>

#include <modbus/modbus.h>
#include <poll.h>
#include <unistd.h>

#include "core/device/in_use.h"
#include "core/device/serial_port.h"

namespace fyd::device {
namespace {

constexpr std::string_view kTcpPrefix = "modbus-tcp:";
constexpr std::string_view kRtuPrefix = "modbus-rtu:";
constexpr Duration kLongestDrain = std::chrono::milliseconds(500);

std::string hostOf(const protocol::Endpoint& endpoint) {
  const std::string text = protocol::toString(endpoint);
  std::string host = text.substr(0, text.rfind(':'));
  if (host.starts_with('[')) host = host.substr(1, host.size() - 2);
  return host;
}

std::uint32_t secondsOf(Duration d) {
  return static_cast<std::uint32_t>(std::chrono::duration_cast<std::chrono::seconds>(d).count());
}
std::uint32_t microsecondsOf(Duration d) {
  return static_cast<std::uint32_t>(std::chrono::duration_cast<std::chrono::microseconds>(d).count() % 1'000'000);
}

/// What an exception answer of the device means; empty when `problem` is none.
Message exceptionText(int problem) {
  switch (problem) {
    case EMBXILFUN: return say("exception 1: it does not know this function; is it a touchpad with this register map?");
    case EMBXILADD: return say("exception 2: it has no such register; is it a touchpad with this register map?");
    case EMBXILVAL: return say("exception 3: it refuses the value");
    case EMBXSFAIL: return say("exception 4: it failed; see the touchpad's own display or log");
    case EMBXACK: return say("exception 5: it needs longer");
    case EMBXSBUSY: return {MessageKind::device, kDrivenElsewhere};
    case EMBXNACK: return say("exception 7: it cannot do this");
    case EMBXMEMPAR: return say("exception 8: memory parity error");
    case EMBXGPATH: return say("exception 10: the gateway has no path to it");
    case EMBXGTAR: return say("exception 11: the gateway gets no answer from it; is it switched on?");
    default: return {};
  }
}

bool portIsGone(int problem) {
  return problem == EIO || problem == ENXIO || problem == ENODEV || problem == EBADF || problem == EPIPE;
}

Message failureText(int problem, Duration timeout) {
  switch (problem) {
    case ETIMEDOUT: return say("no answer in {:.0f} ms; is it switched on and connected?", toMilliseconds(timeout));
    case ECONNREFUSED: return say("nothing listens there; is the touchpad on and the port right?");
    case ECONNRESET:
    case EPIPE: return say("the touchpad closed the connection");
    case EMBBADCRC: return say("an answer with a wrong checksum; is the speed right and the line terminated?");
    case EMBBADDATA: return say("an answer that does not fit the question");
    case EMBBADSLAVE: return say("an answer of another unit");
    case MODBUS_ENOBASE:
    case MODBUS_ENOBASE + MODBUS_EXCEPTION_NOT_DEFINED:
    case EMBBADEXC: return say("an exception with a number that Modbus does not have");
    default: return verbatim(modbus_strerror(problem));
  }
}

}  // namespace

Result<ModbusAddress> parseModbusAddress(const std::string& text) {
  ModbusAddress out;
  const std::size_t comma = text.find(kSerialDemand);
  const std::string place = text.substr(0, comma);
  if (comma != std::string::npos) {
    out.serial = text.substr(comma + kSerialDemand.size());
    if (out.serial.empty() || out.serial.size() > kLongestSerial) {
      return fail("'{}': expected a serial number of 1 to {} characters behind serial=", text, kLongestSerial);
    }
  }
  if (place.starts_with(kTcpPrefix)) {
    auto host = protocol::parseEndpoint(std::string_view(place).substr(kTcpPrefix.size()));
    if (!host) return fail(about(text, host.error().message));
    out.host = *host;
    return out;
  }
  if (!place.starts_with(kRtuPrefix) || place.size() == kRtuPrefix.size()) {
    return fail("'{}': expected modbus-tcp:HOST:PORT or modbus-rtu:TTY[:BAUD]", text);
  }
  out.tcp = false;
  out.port = place.substr(kRtuPrefix.size());
  const std::size_t colon = out.port.rfind(':');
  // Names in /dev/serial/by-path contain colons: only digits after the last one are a speed.
  if (colon != std::string::npos) {
    const char* first = out.port.data() + colon + 1;
    const char* last = out.port.data() + out.port.size();
    const auto [end, problem] = std::from_chars(first, last, out.baud);
    if (problem == std::errc() && end == last && out.baud >= 1200)
      out.port.resize(colon);
    else
      out.baud = ModbusAddress{}.baud;
  }
  return out;
}

std::string toString(const ModbusAddress& address) {
  if (address.tcp) return fmt::format("{}{}", kTcpPrefix, protocol::toString(address.host));
  return fmt::format("{}{}:{}", kRtuPrefix, address.port, address.baud);
}

void ModbusLink::Free::operator()(_modbus* context) const {
  modbus_close(context);
  modbus_free(context);
}

ModbusLink::ModbusLink(ModbusAddress address, Duration response_timeout, Duration quiet)
    : address_(std::move(address)), response_timeout_(response_timeout), quiet_(quiet), name_(toString(address_)) {}

ModbusLink::~ModbusLink() = default;

Result<void> ModbusLink::makeContext() {
  if (address_.tcp) {
    const std::string host = hostOf(address_.host);
    context_.reset(address_.host.v6 ? modbus_new_tcp_pi(host.c_str(), std::to_string(address_.host.port).c_str())
                                    : modbus_new_tcp(host.c_str(), address_.host.port));
    return {};
  }
  if (speedConstant(address_.baud) == B0) return fail("{}: {} Bd is no speed of this system", name_, address_.baud);
  const auto path = resolveDevice(address_.port, address_.by_id);
  if (!path) return tl::unexpected(path.error());
  if (::access(path->c_str(), R_OK | W_OK) != 0) return fail(explainPort(*path, errno));
  context_.reset(modbus_new_rtu(path->c_str(), address_.baud, 'N', 8, 1));
  return {};
}

Result<void> ModbusLink::open() {
  close();
  if (auto made = makeContext(); !made) return made;
  if (!context_) return fail("{}: cannot be opened: {}", name_, verbatim(modbus_strerror(errno)));
  modbus_t* const context = context_.get();
  modbus_set_slave(context, address_.unit);
  modbus_set_error_recovery(context, MODBUS_ERROR_RECOVERY_NONE);
  modbus_set_response_timeout(context, secondsOf(response_timeout_), microsecondsOf(response_timeout_));
  modbus_set_byte_timeout(context, 0, 0);  // none: the whole answer within the time above, however it trickles
  if (modbus_connect(context) != 0) {
    const int problem = errno;
    context_.reset();
    if (!address_.tcp) return fail(explainPort(address_.port, problem));
    // A connection that is not made in time ends with one of these.
    const bool late = problem == ETIMEDOUT || problem == EINPROGRESS;
    return fail(about(name_, failureText(late ? ETIMEDOUT : problem, response_timeout_)));
  }
  if (address_.tcp) return {};
  if (auto claimed = claim(); !claimed) {
    context_.reset();
    return claimed;
  }
  recover();  // what an earlier program left on the line
  return {};
}

Result<void> ModbusLink::claim() {
  const int file = modbus_get_socket(context_.get());
  if (auto alone = claimPort(file, address_.port); !alone) return alone;
  return checkSpeed(file, address_.baud, address_.port);
}

void ModbusLink::close() { context_.reset(); }

void ModbusLink::recover() {
  if (!context_) return;
  if (address_.tcp) {
    close();
    return;
  }
  const int file = modbus_get_socket(context_.get());
  const Instant latest = Clock::now() + std::max(kLongestDrain, quiet_);
  std::array<std::uint8_t, 256> waste{};
  pollfd ready{.fd = file, .events = POLLIN, .revents = 0};
  const int quiet_ms = static_cast<int>(std::ceil(toMilliseconds(quiet_)));
  while (Clock::now() < latest && ::poll(&ready, 1, quiet_ms) > 0) {
    if (::read(file, waste.data(), waste.size()) <= 0) break;
  }
  modbus_flush(context_.get());
}

Result<void> ModbusLink::finish(int done, std::size_t expected, const Message& what, std::uint16_t address) {
  if (done == static_cast<int>(expected)) return {};
  const int problem = done < 0 ? errno : EMBBADDATA;
  const Message exception = exceptionText(problem);
  if (!exception.empty()) return fail("{}: {} at register {}: {}", name_, what, address, exception);
  if (!address_.tcp && portIsGone(problem)) {
    close();
    return fail(explainPort(address_.port, EIO));
  }
  recover();
  return fail(about(name_, failureText(problem, response_timeout_)));
}

Result<void> ModbusLink::read(std::uint16_t address, std::span<std::uint16_t> out) {
  if (!context_) return fail("{}: not open", name_);
  const int done = modbus_read_registers(context_.get(), address, static_cast<int>(out.size()), out.data());
  return finish(done, out.size(), say("reading"), address);
}

Result<void> ModbusLink::write(std::uint16_t address, std::span<const std::uint16_t> values) {
  if (!context_) return fail("{}: not open", name_);
  const int done = modbus_write_registers(context_.get(), address, static_cast<int>(values.size()), values.data());
  return finish(done, values.size(), say("writing"), address);
}

Result<void> ModbusLink::writeAndRead(std::uint16_t write_address, std::span<const std::uint16_t> values,
                                      std::uint16_t read_address, std::span<std::uint16_t> out) {
  if (!context_) return fail("{}: not open", name_);
  const int done =
      modbus_write_and_read_registers(context_.get(), write_address, static_cast<int>(values.size()), values.data(),
                                      read_address, static_cast<int>(out.size()), out.data());
  return finish(done, out.size(), say("a cycle"), write_address);
}

}  // namespace fyd::device
