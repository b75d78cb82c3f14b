// One Modbus connection, TCP or RTU, on libmodbus. Used by one thread at a time: a context belongs to its thread.
//
// What libmodbus 3.1.6 leaves to its caller, done here:
//   - after a lost answer on RTU every later read would return the previous one: the line is drained until it has
//     been silent for the quiet time. The caller proves freshness with a nonce on top of that.
//   - after a time-out on TCP every later read would fail: the connection is closed, a new one starts clean.
//   - a speed it does not know becomes 9600 without an error: the port's speed is read back.
//   - its own reconnecting can loop for ever: it stays off, and the caller opens again.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/base/error.h"
#include "core/base/time.h"
#include "core/device/stable_name.h"
#include "core/protocol/endpoint.h"

struct _modbus;  // NOLINT(bugprone-reserved-identifier): the name is libmodbus's

namespace fyd::device {

struct ModbusAddress {
  bool tcp = true;
  protocol::Endpoint host;  ///< TCP
  std::string port;         ///< RTU: path of the serial port, or "id=SERIAL" of its adapter (stable_name.h)
  int baud = 115'200;       ///< RTU; 8N1
  int unit = 1;
  std::string serial;              ///< that the touchpad must have; empty: any
  std::string by_id{kSerialById};  ///< folder that "id=" is looked up in
};

inline constexpr std::string_view kSerialDemand = ",serial=";
inline constexpr std::size_t kLongestSerial = 16;  ///< characters, of the register map

/// Reads "modbus-tcp:HOST:PORT" and "modbus-rtu:TTY[:BAUD]", each with an optional ",serial=TEXT" that demands the
/// touchpad with this serial number; TTY may be "id=SERIAL" of the adapter.
[[nodiscard]] Result<ModbusAddress> parseModbusAddress(const std::string& text);
[[nodiscard]] std::string toString(const ModbusAddress& address);

class ModbusLink {
 public:
  ModbusLink(ModbusAddress address, Duration response_timeout, Duration quiet);
  ~ModbusLink();
  ModbusLink(const ModbusLink&) = delete;
  ModbusLink& operator=(const ModbusLink&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool isOpen() const { return context_ != nullptr; }

  /// @return an error that names the address, the reason and the remedy
  [[nodiscard]] Result<void> open();
  void close();

  /// Function 0x03.
  [[nodiscard]] Result<void> read(std::uint16_t address, std::span<std::uint16_t> out);
  /// Function 0x10.
  [[nodiscard]] Result<void> write(std::uint16_t address, std::span<const std::uint16_t> values);
  /// Function 0x17: one transaction, the write first.
  [[nodiscard]] Result<void> writeAndRead(std::uint16_t write_address, std::span<const std::uint16_t> values,
                                          std::uint16_t read_address, std::span<std::uint16_t> out);

  /// After an answer that was lost or not the one asked for: TCP closes, RTU drains until the line is quiet.
  void recover();

 private:
  struct Free {
    void operator()(_modbus* context) const;
  };
  [[nodiscard]] Result<void> makeContext();
  [[nodiscard]] Result<void> claim();
  /// Turns libmodbus' result and errno into a Result, and recovers unless the device itself has answered.
  [[nodiscard]] Result<void> finish(int done, std::size_t expected, const Message& what, std::uint16_t address);

  ModbusAddress address_;
  Duration response_timeout_;
  Duration quiet_;
  std::string name_;
  std::unique_ptr<_modbus, Free> context_;
};

}  // namespace fyd::device
