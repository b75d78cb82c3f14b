// The touchpad's firmware behind its Modbus registers: state machine of the motors, heartbeat and watchdog, thermal
// limit, vibration batches, and who may write. Pure: time is handed in. Not thread-safe (TouchpadElectronics locks).
//
// One master drives the motors: the first that writes keeps the right until it has been silent for a second or its
// connection ends. Others read, and their writes get exception 6, busy.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/device/touchpad/touchpad.h"
#include "core/protocol/registers/drive_state.h"
#include "core/protocol/registers/register_codec.h"
#include "core/sim/server/vibration_queue.h"

namespace fyd::sim {

/// Exception codes of Modbus.
enum class ModbusException : std::uint8_t {
  none = 0,
  illegal_function = 1,
  illegal_address = 2,
  illegal_value = 3,
  busy = 6,
};

class RegisterBank {
 public:
  static constexpr std::uint16_t kSize = protocol::kCommandAddress + protocol::kCommandRegisters;
  using Image = std::array<std::uint16_t, kSize>;

  RegisterBank() = default;
  /// @param serial number that the identity registers tell, at most 16 characters
  explicit RegisterBank(std::string serial) : serial_(std::move(serial)) {}

  /// Power comes up at `now`. @param cause `undervoltage` after a brown-out
  void restart(Instant now, protocol::DriveFault cause);

  /// Whether all of these may be read in one request: they lie in one block of the map.
  [[nodiscard]] static bool readable(int address, int count);
  /// @param obeys false: the values can be read back but have no effect
  [[nodiscard]] ModbusException write(int master, int address, std::span<const std::uint16_t> values, Instant now,
                                      bool obeys = true);
  /// The connection ended.
  void forget(int master);

  /// Watchdog and thermal limit, as of `now`.
  void supervise(Instant now, const std::array<double, control::kMotorCount>& temperature_degC);
  /// The motors' command at `now`; must not decrease from call to call.
  [[nodiscard]] control::MotorCommand commandAt(Instant now);

  /// All registers as `master` sees them at `now`.
  void fill(Image& image, int master, const device::TouchpadReadings& readings, Instant now);

  [[nodiscard]] const protocol::Drive& drive() const { return drive_; }
  [[nodiscard]] std::uint64_t transactions() const { return transactions_; }
  [[nodiscard]] std::uint64_t refusedWrites() const { return refused_writes_; }

 private:
  [[nodiscard]] bool mayWrite(int master, Instant now);
  [[nodiscard]] ModbusException writeSettings(std::size_t at, std::span<const std::uint16_t> values);
  [[nodiscard]] ModbusException writeCommand(std::size_t at, std::span<const std::uint16_t> values, Instant now,
                                             bool obeys);
  [[nodiscard]] protocol::DeviceState stateFor(int master, const device::TouchpadReadings& readings, Instant now);

  std::string serial_ = "FYD-SIM-0001";
  protocol::Drive drive_;
  protocol::DeviceCommand command_;
  protocol::CommandRegisters command_image_{};
  VibrationQueue vibration_;
  std::array<double, control::kMotorCount> temperature_degC_{};
  std::array<std::uint16_t, protocol::kSettingsRegisters> settings_{};
  std::optional<int> owner_;
  Instant owner_wrote_{};
  Instant last_heartbeat_{};
  Instant powered_since_{};
  bool obeys_ = true;  // as of the last write
  std::uint16_t sequence_ = 0;
  std::uint64_t transactions_ = 0;
  std::uint64_t refused_writes_ = 0;
};

}  // namespace fyd::sim
