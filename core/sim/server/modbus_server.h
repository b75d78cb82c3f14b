// Serves the simulated touchpad's registers over Modbus TCP or RTU; framing by libmodbus. Holding registers from 0;
// functions 0x03, 0x06, 0x10, 0x17; unit 1 (over TCP also 0 and 255), others are not answered. One thread per server.
#pragma once

#include <atomic>
#include <list>
#include <memory>
#include <random>
#include <string>
#include <thread>

#include "core/base/error.h"
#include "core/protocol/endpoint.h"
#include "core/sim/server/serial_end.h"
#include "core/sim/server/touchpad_electronics.h"

// NOLINTBEGIN(bugprone-reserved-identifier): the names are libmodbus's
struct _modbus;
struct _modbus_mapping_t;
// NOLINTEND(bugprone-reserved-identifier)

namespace fyd::sim {

/// One line with one libmodbus context: answers what arrives, with the faults of the plan.
class ModbusResponder {
 public:
  /// @param context is taken over, but not its file
  ModbusResponder(std::shared_ptr<TouchpadElectronics> electronics, _modbus* context, bool tcp);
  ~ModbusResponder();
  ModbusResponder(const ModbusResponder&) = delete;
  ModbusResponder& operator=(const ModbusResponder&) = delete;

  /// Receives one request and answers it. @return false when the connection has ended
  [[nodiscard]] bool serve();

 private:
  void answer(const std::uint8_t* request, int length);
  [[nodiscard]] ModbusException obey(const std::uint8_t* pdu, int length, Instant now);
  /// Over TCP. @return false: it does not come, or the length that the request says is none
  [[nodiscard]] bool readRest(const std::uint8_t* request, int length);
  void sendGarbage();

  std::shared_ptr<TouchpadElectronics> electronics_;
  _modbus* context_;
  _modbus_mapping_t* mapping_;
  bool tcp_;
  int master_;  // number of this connection
  std::mt19937 random_{1};
};

class ModbusTcpServer {
 public:
  /// @param local port 0: any. @return an error when the port is taken
  [[nodiscard]] static Result<std::unique_ptr<ModbusTcpServer>> start(const protocol::Endpoint& local,
                                                                      std::shared_ptr<TouchpadElectronics> electronics);
  ~ModbusTcpServer();  ///< closes every connection, also in the middle of a transaction

  [[nodiscard]] const protocol::Endpoint& local() const { return local_; }

 private:
  static constexpr std::size_t kMaximumClients = 8;  ///< a further one waits until another leaves

  struct Client;
  struct Sockets;
  ModbusTcpServer(std::unique_ptr<Sockets> sockets, protocol::Endpoint local,
                  std::shared_ptr<TouchpadElectronics> electronics);
  void accept();
  void serve(std::list<Client>::iterator client);

  std::unique_ptr<Sockets> sockets_;
  protocol::Endpoint local_;
  std::shared_ptr<TouchpadElectronics> electronics_;
  std::jthread thread_;
};

class ModbusRtuServer {
 public:
  [[nodiscard]] static Result<std::unique_ptr<ModbusRtuServer>> start(const std::string& path, int baud,
                                                                      std::shared_ptr<TouchpadElectronics> electronics);

 private:
  ModbusRtuServer(SerialEnd line, const std::string& path, int baud, std::shared_ptr<TouchpadElectronics> electronics);
  void run(const std::stop_token& stop);

  SerialEnd line_;
  std::unique_ptr<ModbusResponder> responder_;
  std::jthread thread_;
};

}  // namespace fyd::sim
