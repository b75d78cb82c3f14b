#include "core/sim/server/modbus_server.h"

#include <algorithm>
#include <cerrno>

#include <list>

#include <modbus/modbus.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/steady_timer.hpp>

#include "core/base/system_reason.h"

namespace fyd::sim {
namespace {

constexpr Duration kNextAccept = std::chrono::milliseconds(100);  // after one that failed
constexpr Duration kRestOfRequest = std::chrono::milliseconds(50);
constexpr std::uint8_t kReadHolding = 0x03;
constexpr std::uint8_t kWriteSingle = 0x06;
constexpr std::uint8_t kWriteMultiple = 0x10;
constexpr std::uint8_t kWriteAndRead = 0x17;
constexpr std::uint8_t kFirstException = 0x80;

std::atomic<int> next_master{1};

constexpr std::size_t kTcpUnitAt = 6;  // behind transaction, protocol and length

/// Over TCP a touchpad is reached by its address: a master need not know its unit.
bool isOurs(std::uint8_t unit) { return unit == protocol::kModbusUnit || unit == 0 || unit == MODBUS_TCP_SLAVE; }

int word(const std::uint8_t* bytes) { return (bytes[0] << 8) | bytes[1]; }

asio::ip::tcp::endpoint listeningAt(const protocol::Endpoint& local) {
  if (!local.v6) {
    asio::ip::address_v4::bytes_type bytes{};
    std::copy_n(local.address.begin(), bytes.size(), bytes.begin());
    return {asio::ip::address_v4(bytes), local.port};
  }
  return {asio::ip::address_v6(local.address, local.scope), local.port};
}

}  // namespace

ModbusResponder::ModbusResponder(std::shared_ptr<TouchpadElectronics> electronics, modbus_t* context, bool tcp)
    : electronics_(std::move(electronics)),
      context_(context),
      mapping_(modbus_mapping_new_start_address(0, 0, 0, 0, 0, RegisterBank::kSize, 0, 0)),
      tcp_(tcp),
      master_(next_master++) {
  const auto rest_us =
      static_cast<std::uint32_t>(std::chrono::duration_cast<std::chrono::microseconds>(kRestOfRequest).count());
  modbus_set_byte_timeout(context_, 0, rest_us);
  modbus_set_indication_timeout(context_, 0, rest_us);
}

ModbusResponder::~ModbusResponder() {
  electronics_->forget(master_);
  modbus_mapping_free(mapping_);
  modbus_free(context_);
}

bool ModbusResponder::serve() {
  std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> request{};
  const int length = modbus_receive(context_, request.data());
  if (length > 0) {
    if (tcp_ && !readRest(request.data(), length)) return false;
    // libmodbus passes over another unit's request on a serial line only.
    if (tcp_ && !isOurs(request[kTcpUnitAt])) return true;
    answer(request.data(), length);
    return true;
  }
  if (length == 0) return true;  // for another unit
  if (tcp_) return false;        // a TCP stream that lost its framing cannot go on
  modbus_flush(context_);
  return true;
}

/// Of a function that libmodbus does not know it reads no data: they would be taken for the next request.
bool ModbusResponder::readRest(const std::uint8_t* request, int length) {
  std::array<std::uint8_t, MODBUS_TCP_MAX_ADU_LENGTH> rest{};
  // The length counts from the unit on and stands before it.
  int left = int{kTcpUnitAt} + word(request + kTcpUnitAt - 2) - length;
  if (left < 0 || left > static_cast<int>(rest.size())) return false;
  while (left > 0) {
    pollfd line{.fd = modbus_get_socket(context_), .events = POLLIN, .revents = 0};
    if (::poll(&line, 1, static_cast<int>(toMilliseconds(kRestOfRequest))) <= 0) return false;
    const ssize_t got = ::recv(line.fd, rest.data(), static_cast<std::size_t>(left), MSG_DONTWAIT);
    if (got <= 0) return false;
    left -= static_cast<int>(got);
  }
  return true;
}

ModbusException ModbusResponder::obey(const std::uint8_t* pdu, int length, Instant now) {
  const std::uint8_t function = pdu[0];
  int read_at = -1;
  int read_count = 0;
  int write_at = -1;
  int write_count = 0;
  const std::uint8_t* values = nullptr;
  switch (function) {
    case kReadHolding:
      read_at = word(pdu + 1);
      read_count = word(pdu + 3);
      break;
    case kWriteSingle:
      write_at = word(pdu + 1);
      write_count = 1;
      values = pdu + 3;
      break;
    case kWriteMultiple:
      write_at = word(pdu + 1);
      write_count = word(pdu + 3);
      values = pdu + 6;
      break;
    case kWriteAndRead:
      read_at = word(pdu + 1);
      read_count = word(pdu + 3);
      write_at = word(pdu + 5);
      write_count = word(pdu + 7);
      values = pdu + 10;
      break;
    default: return ModbusException::illegal_function;
  }
  if (read_at >= 0) {
    if (read_count < 1 || read_count > MODBUS_MAX_READ_REGISTERS) return ModbusException::illegal_value;
    if (!RegisterBank::readable(read_at, read_count)) return ModbusException::illegal_address;
  }
  if (write_at < 0) return ModbusException::none;
  const std::ptrdiff_t bytes = 2 * std::ptrdiff_t{write_count};
  const bool whole = values + bytes <= pdu + length && (function == kWriteSingle || values[-1] == bytes);
  if (write_count < 1 || write_count > MODBUS_MAX_WRITE_REGISTERS || !whole) return ModbusException::illegal_value;
  std::array<std::uint16_t, MODBUS_MAX_WRITE_REGISTERS> words{};
  const auto count = static_cast<std::size_t>(write_count);
  for (std::size_t i = 0; i < count; ++i) words[i] = static_cast<std::uint16_t>(word(values + 2 * i));
  return electronics_->write(master_, write_at, {words.data(), count}, now);
}

void ModbusResponder::answer(const std::uint8_t* request, int length) {
  const Instant now = electronics_->clock();
  const FaultPlan& faults = electronics_->faults();
  electronics_->advanceTo(now);
  if (!electronics_->powered(now) || faults.active(TouchpadFault::silence, now)) return;
  const int head = modbus_get_header_length(context_);
  const int tail = tcp_ ? 0 : 2;  // checksum
  // The number of an exception's answer is no request's; libmodbus would answer it with that of a good answer.
  if (request[head] >= kFirstException) return;
  const ModbusException exception = obey(request + head, length - head - tail, now);
  if (electronics_->answersLate(now)) std::this_thread::sleep_for(kLateBy);
  if (faults.active(TouchpadFault::garbage, now)) {
    sendGarbage();
    return;
  }
  if (exception != ModbusException::none) {
    modbus_reply_exception(context_, request, static_cast<unsigned int>(exception));
    return;
  }
  RegisterBank::Image image{};
  electronics_->fill(image, master_, now);
  std::ranges::copy(image, mapping_->tab_registers);
  modbus_reply(context_, request, length, mapping_);
}

void ModbusResponder::sendGarbage() {
  std::array<std::uint8_t, 40> waste{};
  for (std::uint8_t& byte : waste) byte = static_cast<std::uint8_t>(random_());
  const std::size_t size = 1 + random_() % waste.size();
  [[maybe_unused]] const ssize_t ignored = tcp_ ? ::send(modbus_get_socket(context_), waste.data(), size, MSG_NOSIGNAL)
                                                : ::write(modbus_get_socket(context_), waste.data(), size);
}

/// A connection: its socket, and what answers on it.
struct ModbusTcpServer::Client {
  Client(asio::ip::tcp::socket accepted, std::shared_ptr<TouchpadElectronics> electronics, modbus_t* context)
      : socket(std::move(accepted)), responder(std::move(electronics), context, true) {}
  asio::ip::tcp::socket socket;
  ModbusResponder responder;
};

/// The sockets; only the thread touches them once it runs.
struct ModbusTcpServer::Sockets {
  asio::io_context io;
  asio::ip::tcp::acceptor acceptor{io};
  asio::steady_timer pause{io};
  std::list<Client> clients;
  bool accepting = false;
};

Result<std::unique_ptr<ModbusTcpServer>> ModbusTcpServer::start(const protocol::Endpoint& local,
                                                                std::shared_ptr<TouchpadElectronics> electronics) {
  std::unique_ptr<Sockets> sockets;
  protocol::Endpoint bound = local;
  try {
    sockets = std::make_unique<Sockets>();
    const auto address = listeningAt(local);
    sockets->acceptor.open(address.protocol());
    sockets->acceptor.set_option(asio::socket_base::reuse_address(true));
    sockets->acceptor.bind(address);
    sockets->acceptor.listen(static_cast<int>(kMaximumClients));
    bound.port = sockets->acceptor.local_endpoint().port();
  } catch (const std::system_error& problem) {
    return fail("Modbus TCP {}: cannot listen: {}", protocol::toString(local), systemReason(problem.code()));
  }
  return std::unique_ptr<ModbusTcpServer>(new ModbusTcpServer(std::move(sockets), bound, std::move(electronics)));
}

ModbusTcpServer::ModbusTcpServer(std::unique_ptr<Sockets> sockets, protocol::Endpoint local,
                                 std::shared_ptr<TouchpadElectronics> electronics)
    : sockets_(std::move(sockets)), local_(local), electronics_(std::move(electronics)) {
  accept();
  thread_ = std::jthread([this] { sockets_->io.run(); });
}

ModbusTcpServer::~ModbusTcpServer() {
  sockets_->io.stop();
  thread_.join();
}

void ModbusTcpServer::accept() {
  if (sockets_->accepting || sockets_->clients.size() >= kMaximumClients) return;
  sockets_->accepting = true;
  sockets_->acceptor.async_accept([this](const std::error_code& problem, asio::ip::tcp::socket socket) {
    if (problem) {  // no free file, as a rule: asking again at once would only take the processor
      sockets_->pause.expires_after(kNextAccept);
      sockets_->pause.async_wait([this](const std::error_code&) {
        sockets_->accepting = false;
        accept();
      });
      return;
    }
    sockets_->accepting = false;
    modbus_t* context = modbus_new_tcp(nullptr, local_.port);
    if (context != nullptr) {
      std::error_code ignored;
      socket.set_option(asio::ip::tcp::no_delay(true), ignored);
      modbus_set_socket(context, socket.native_handle());
      sockets_->clients.emplace_back(std::move(socket), electronics_, context);
      serve(std::prev(sockets_->clients.end()));
    }
    accept();
  });
}

void ModbusTcpServer::serve(std::list<Client>::iterator client) {
  client->socket.async_wait(asio::socket_base::wait_read, [this, client](const std::error_code& problem) {
    if (!problem && client->responder.serve()) return serve(client);
    sockets_->clients.erase(client);
    accept();
  });
}

Result<std::unique_ptr<ModbusRtuServer>> ModbusRtuServer::start(const std::string& path, int baud,
                                                                std::shared_ptr<TouchpadElectronics> electronics) {
  auto line = SerialEnd::open(path, baud);
  if (!line) return tl::unexpected(line.error());
  return std::unique_ptr<ModbusRtuServer>(new ModbusRtuServer(std::move(*line), path, baud, std::move(electronics)));
}

ModbusRtuServer::ModbusRtuServer(SerialEnd line, const std::string& path, int baud,
                                 std::shared_ptr<TouchpadElectronics> electronics)
    : line_(std::move(line)) {
  modbus_t* context = modbus_new_rtu(path.c_str(), baud, 'N', 8, 1);
  modbus_set_slave(context, protocol::kModbusUnit);
  modbus_set_socket(context, line_.file());
  responder_ = std::make_unique<ModbusResponder>(std::move(electronics), context, false);
  thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void ModbusRtuServer::run(const std::stop_token& stop) {
  while (!stop.stop_requested()) {
    if (line_.waitForBytes()) static_cast<void>(responder_->serve());
  }
}

}  // namespace fyd::sim
